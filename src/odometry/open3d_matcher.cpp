// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <numeric>
#include <string>

#include "odometry/messages.hpp"
#include "odometry/observability.hpp"
#include "planescope/error.hpp"
#include "planescope/odometry.hpp"

namespace planescope {
namespace {

using odometry::Do;
using odometry::Hello;
using odometry::Reply;
using odometry::Request;

/// The program, and the socket that is its standard input.
class Program {
 public:
  Program(const std::filesystem::path& path, double patience) : name_(path.string()) {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
      fail_to_start(errno);
    socket_ = ends[0];
    const auto whole = static_cast<time_t>(patience);
    const timeval wait{whole, static_cast<suseconds_t>((patience - double(whole)) * 1e6)};
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &wait, sizeof wait);
    ::setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &wait, sizeof wait);
    const int failure = spawn(ends[1]);
    ::close(ends[1]);
    if (failure == 0) return;
    ::close(socket_);
    fail_to_start(failure);
  }

  ~Program() {
    ::close(socket_);
    ::kill(pid_, SIGKILL);  // it keeps nothing
    int status = 0;
    ::waitpid(pid_, &status, 0);
  }

  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void send(const void* data, std::size_t size) const {
    const char* at = static_cast<const char*>(data);
    while (size > 0) {
      const ssize_t done = ::send(socket_, at, size, MSG_NOSIGNAL);
      if (done < 0 && errno == EINTR) continue;
      if (done <= 0) fail_by(done == 0 ? 0 : errno);
      at += done;
      size -= static_cast<std::size_t>(done);
    }
  }

  Reply receive() const {
    Reply reply;
    char* at = reinterpret_cast<char*>(&reply);
    std::size_t size = sizeof reply;
    while (size > 0) {
      const ssize_t done = ::recv(socket_, at, size, 0);
      if (done < 0 && errno == EINTR) continue;
      if (done <= 0) fail_by(done == 0 ? 0 : errno);
      at += done;
      size -= static_cast<std::size_t>(done);
    }
    if (reply.magic != odometry::kMagic || reply.found > 1) fail("answers with nonsense");
    return reply;
  }

  /// What it works on, for messages.
  void work_on(const std::string& what) { work_ = what; }

 private:
  /// What it prints goes nowhere: its answers say what there is to say.
  int spawn(int its_end) {
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, its_end, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawnattr_t how;
    posix_spawnattr_init(&how);
    sigset_t signals;
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&how, &signals);  // ours are not its business
    sigaddset(&signals, SIGPIPE);
    posix_spawnattr_setsigdefault(&how, &signals);
    posix_spawnattr_setflags(&how, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    std::array<char*, 2> words = {name_.data(), nullptr};
    const int failure = ::posix_spawn(&pid_, name_.c_str(), &files, &how, words.data(), environ);
    posix_spawnattr_destroy(&how);
    posix_spawn_file_actions_destroy(&files);
    return failure;
  }

  [[noreturn]] void fail_to_start(int failure) const {
    throw Error(Error::Kind::Computation,
                name_ + ": cannot be started: " + std::strerror(failure) +
                    "; it is built where libopen3d-dev is installed, and estimates poses");
  }

  [[noreturn]] void fail_by(int failure) const {
    if (failure == EAGAIN || failure == EWOULDBLOCK) fail("gives no answer");
    fail("has ended" + how_it_ended());
  }

  [[noreturn]] void fail(const std::string& how) const {
    throw Error(Error::Kind::Computation, name_ + ": " + how +
                                              (work_.empty() ? ", at its start" : ", at " + work_) +
                                              "; give poses with the sequence, or other --frames");
  }

  /// ` with exit code 1`; nothing where it has not ended, or not soon.
  std::string how_it_ended() const {
    siginfo_t info{};
    for (int tries = 0; tries < 50 && info.si_pid == 0; ++tries) {
      if (::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) != 0) break;
      if (info.si_pid == 0) ::usleep(10'000);
    }
    if (info.si_pid == 0) return "";
    return (info.si_code == CLD_EXITED ? " with exit code " : " by signal ") +
           std::to_string(info.si_status);
  }

  std::string name_, work_;
  int socket_ = -1;
  pid_t pid_ = -1;
};

class Open3dMatcher final : public FrameMatcher {
 public:
  Open3dMatcher(const std::filesystem::path& path, const DepthCamera& camera, double patience)
      : camera_(camera), program_(path, patience) {
    const PinholeCamera& lens = camera.lens;
    Hello hello;
    hello.width = lens.width;
    hello.height = lens.height;
    hello.fx = lens.fx;
    hello.fy = lens.fy;
    hello.cx = lens.cx;
    hello.cy = lens.cy;
    hello.min_depth = camera.min_depth;
    hello.max_depth = camera.max_depth;
    program_.send(&hello, sizeof hello);
    program_.receive();
  }

  void take(const Frame& frame) override {
    std::vector<float> values;
    values.reserve(frame.depth.size());
    for (const Rgb& c : frame.color.pixels) {
      values.push_back(static_cast<float>(odometry::brightness(c)));
    }
    const double sum = std::accumulate(values.begin(), values.end(), 0.0);
    // Both images are brought to one mean brightness: what is as good as black cannot be.
    const bool has_color = sum > 0.01 * static_cast<double>(values.size());
    values.resize(frame.depth.size());
    std::vector<float> depths;
    depths.reserve(values.size());
    for (const std::uint16_t z : frame.depth.values) {
      depths.push_back(static_cast<float>(camera_.depth(z)));
    }
    program_.work_on(frame.info.depth.string());
    request(Do::Take, has_color);
    program_.send(depths.data(), depths.size() * sizeof(float));
    program_.send(values.data(), values.size() * sizeof(float));
  }

  void keep() override { request(Do::Keep, false); }

  std::optional<FrameMatch> match(const Eigen::Isometry3d& guess) override {
    Request request{.what = Do::Match, .has_color = 0, .guess = {}};
    std::memcpy(request.guess.data(), guess.matrix().data(), sizeof request.guess);
    program_.send(&request, sizeof request);
    const Reply reply = program_.receive();
    if (reply.found == 0) return std::nullopt;
    const Eigen::Map<const Eigen::Matrix4d> motion(reply.motion.data());
    FrameMatch match;
    match.share = reply.share;
    match.motion.translation() = motion.topRightCorner<3, 1>();
    const Eigen::Matrix3d turn = motion.topLeftCorner<3, 3>();
    match.motion.linear() = Eigen::Quaterniond(turn).normalized().toRotationMatrix();
    return match;
  }

 private:
  void request(Do what, bool has_color) const {
    const Request request{.what = what, .has_color = has_color ? 1U : 0U, .guess = {}};
    program_.send(&request, sizeof request);
  }

  DepthCamera camera_;
  Program program_;
};

}  // namespace

std::unique_ptr<FrameMatcher> start_open3d_matcher(const std::filesystem::path& program,
                                                   const DepthCamera& camera, double patience) {
  return std::make_unique<Open3dMatcher>(program, camera, patience);
}

}  // namespace planescope
