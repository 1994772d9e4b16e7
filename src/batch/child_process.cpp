// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "batch/child_process.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "batch/data_limit.hpp"
#include "planescope/error.hpp"

namespace planescope {
namespace {

namespace fs = std::filesystem;

/// A file descriptor that is closed at the end, and in the child by exec.
class Descriptor {
 public:
  Descriptor(const fs::path& file, int flags)
      : value_(::open(file.c_str(), flags | O_CLOEXEC | O_NOFOLLOW, 0644)) {
    if (value_ >= 0) return;
    throw Error(Error::Kind::Input, file.string() + ": cannot be opened: " + std::strerror(errno) +
                                        "; is the output folder writable?");
  }
  ~Descriptor() { ::close(value_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int value() const { return value_; }

 private:
  int value_;
};

/// Between fork and exec: only calls that are safe there. Ends with 127, as a shell does.
[[noreturn]] void become(char* const* words, int in, int out, int err, std::uint64_t memory_mb,
                         pid_t parent) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(127);  // it died before it was asked to tell
  if (memory_mb > 0) limit_data(memory_mb << 20, true);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);  // ours are not the child's business
  ::signal(SIGPIPE, SIG_DFL);
  ::signal(SIGXFSZ, SIG_DFL);
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  ::dup2(in, STDIN_FILENO);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  ::execvp(words[0], words);
  constexpr char kWhy[] = "the program cannot be run\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, kWhy, sizeof kWhy - 1);
  ::_exit(127);
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& words, const fs::path& out,
                           const fs::path& err, const ChildLimits& limits)
    : start_(std::chrono::steady_clock::now()), limits_(limits), undo_([this] { ask_to_end(); }) {
  start(words, out, err);
}

void ChildProcess::start(const std::vector<std::string>& words, const fs::path& out,
                         const fs::path& err) {
  constexpr int kWrite = O_WRONLY | O_CREAT | O_TRUNC;
  const Descriptor in("/dev/null", O_RDONLY), to(out, kWrite), errors(err, kWrite);
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const EndingPause known;  // no child that ask_to_end() does not know of
  const pid_t parent = ::getpid();
  pid_ = ::fork();
  if (pid_ == 0)
    become(arguments.data(), in.value(), to.value(), errors.value(), limits_.memory_mb, parent);
  if (pid_ < 0)
    throw Error(Error::Kind::Computation, std::string("no process for a scene: ") +
                                              std::strerror(errno) + "; take fewer --jobs");
  ::setpgid(pid_, pid_);  // here too: whoever comes first
}

/// It may have files to put away, so it is asked before it is killed; others than ours may not
/// listen.
void ChildProcess::ask_to_end() const {
  if (pid_ < 0 || end_) return;
  ::kill(-pid_, SIGTERM);
  for (int tries = 0; tries < 100; ++tries) {
    siginfo_t info{};
    if (::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) != 0) return;
    if (info.si_pid == pid_) return;
    ::usleep(20'000);
  }
  ::kill(-pid_, SIGKILL);
}

ChildProcess::~ChildProcess() {
  if (end_) return;
  ::kill(-pid_, SIGKILL);
  int status = 0;
  ::waitpid(pid_, &status, 0);
}

std::optional<ChildEnd> ChildProcess::poll() {
  const EndingPause known;
  if (end_) return end_;
  if (limits_.seconds > 0 && !timed_out_ && seconds_since(start_) > limits_.seconds) {
    timed_out_ = true;
    ::kill(-pid_, SIGKILL);
  }
  int status = 0;
  rusage usage{};
  if (::wait4(pid_, &status, WNOHANG, &usage) == pid_) {
    ::kill(-pid_, SIGKILL);  // what it started and left behind
    reap(status, static_cast<double>(usage.ru_maxrss) / 1024);
  }
  return end_;
}

void ChildProcess::reap(int status, double peak_memory_mb) {
  ChildEnd end;
  end.seconds = seconds_since(start_);
  end.peak_memory_mb = peak_memory_mb;
  if (WIFSIGNALED(status)) {
    end.how = timed_out_ ? ChildEnd::How::TimedOut : ChildEnd::How::Signalled;
    end.code = WTERMSIG(status);
  } else {
    end.code = WEXITSTATUS(status);
  }
  end_ = end;
}

}  // namespace planescope
