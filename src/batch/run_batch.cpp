// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "batch/run_batch.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <deque>
#include <fstream>
#include <memory>
#include <thread>

#include "planescope/error.hpp"

namespace planescope {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// A folder of ours is no link: what is written and removed in it must not be elsewhere.
void refuse_link(const fs::path& folder) {
  if (fs::is_symlink(fs::symlink_status(folder)))
    throw Error(Error::Kind::Input, folder.string() +
                                        ": is a link, and a batch follows none out of its folder; "
                                        "remove it, or name another folder with -o");
}

void make_folder(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (!fs::is_directory(folder))
    throw Error(Error::Kind::Input, folder.string() + ": the folder cannot be made: " +
                                        failure.message() + "; name another with -o");
}

/// What is hidden in a job's folder is what a killed process left behind.
void prepare_folder(const fs::path& folder) {
  refuse_link(folder.parent_path());
  refuse_link(folder);
  make_folder(folder);
  for (const char* name :
       {"job.json", "scores.json", "result.json", "run.json", "segment.log", "evaluate.log"})
    fs::remove(folder / name);
  std::vector<fs::path> left;
  for (const auto& file : fs::directory_iterator(folder))
    if (file.path().filename().string().starts_with(".")) left.push_back(file.path());
  for (const fs::path& file : left) fs::remove_all(file);
}

/// The last line that a program printed, without its own name.
std::string last_line(const fs::path& file) {
  std::ifstream in(file);
  std::string last;
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) last = line;
  constexpr std::string_view kName = "planescope: ";
  return last.starts_with(kName) ? last.substr(kName.size()) : last;
}

std::string describe(const ChildEnd& end, const ChildLimits& limits, const fs::path& log) {
  char number[32];
  std::snprintf(number, sizeof number, "%g", limits.seconds);
  if (end.how == ChildEnd::How::TimedOut)
    return std::string("took longer than ") + number + " s (--time-limit)";
  if (end.how == ChildEnd::How::Signalled)
    return std::string("was ended by signal ") + std::to_string(end.code) + " (" +
           ::strsignal(end.code) + ")";
  const std::string line = last_line(log);
  return "exit code " + std::to_string(end.code) + (line.empty() ? "" : ": " + line);
}

/// A file or folder as an argument that no program takes for an option.
std::string as_argument(const fs::path& file) {
  return file.string().starts_with('-') ? "./" + file.string() : file.string();
}

/// One scene by one method: `segment`, then `evaluate`, each a process.
class Job {
 public:
  Job(const BatchPlan& plan, const BatchRun& run, const BatchScene& scene,
      const std::string& method)
      : plan_(plan),
        run_(run),
        scene_(scene),
        method_(method),
        folder_(job_folder(run.folder, scene.name, method)) {
    record_.settings_key = plan.settings_key(method);
    record_.input_key = input_key(scene);
  }

  std::string name() const { return scene_.name + ", " + method_; }
  const JobRecord& record() const { return record_; }

  bool is_done() const {
    const auto before = read_record(folder_);
    return before && before->done && fs::exists(folder_ / "result.json") &&
           before->settings_key == record_.settings_key && before->input_key == record_.input_key;
  }

  void start() {
    prepare_folder(folder_);
    start_process(segment_words(), folder_ / ".stdout");
  }

  /// True once the job has ended, well or not; then job.json is there.
  bool advance() {
    const auto end = process_->poll();
    if (!end) return false;
    record_.peak_memory_mb = std::max(record_.peak_memory_mb, end->peak_memory_mb);
    if (!end->good()) {
      finish(describe(*end, run_.limits, log()));
      return true;
    }
    if (!evaluating_ && plan_.scored) {
      evaluating_ = true;
      start_process(evaluate_words(), folder_ / ".scores");
      return false;
    }
    finish("");
    return true;
  }

 private:
  fs::path log() const { return folder_ / (evaluating_ ? "evaluate.log" : "segment.log"); }

  void start_process(std::vector<std::string> words, const fs::path& out) {
    words.insert(words.begin(), run_.program.begin(), run_.program.end());
    process_.reset();
    process_ = std::make_unique<ChildProcess>(words, out, log(), run_.limits);
  }

  std::vector<std::string> segment_words() const {
    const unsigned all = std::max(1U, std::thread::hardware_concurrency());
    std::vector<std::string> words = {"segment",
                                      as_argument(scene_.file),
                                      "--output=" + folder_.string(),
                                      "--quiet",
                                      "--method=" + method_,
                                      "--threads=" + std::to_string(std::max(1U, all / run_.jobs))};
    if (!run_.pictures) words.push_back("--no-pictures");
    words.insert(words.end(), plan_.segment_arguments.begin(), plan_.segment_arguments.end());
    return words;
  }

  std::vector<std::string> evaluate_words() const {
    std::vector<std::string> words = {"evaluate", as_argument(folder_),
                                      "--truth=" + scene_.truth.string(), "--json"};
    if (!scene_.truth_planes.empty())
      words.push_back("--truth-planes=" + scene_.truth_planes.string());
    words.insert(words.end(), plan_.evaluate_arguments.begin(), plan_.evaluate_arguments.end());
    return words;
  }

  void finish(const std::string& failure) {
    process_.reset();
    record_.reason = failure;
    if (failure.empty()) read_values();
    record_.done = record_.reason.empty();
    fs::remove(folder_ / ".stdout");
    fs::remove(folder_ / ".scores");
    write_record(record_, folder_);
  }

  void read_values() {
    try {
      const fs::path scores = plan_.scored ? folder_ / "scores.json" : fs::path();
      if (plan_.scored) fs::rename(folder_ / ".scores", scores);
      record_.values = read_measures(scores, folder_ / "run.json");
    } catch (const std::exception& error) {
      record_.reason = error.what();
    }
  }

  const BatchPlan& plan_;
  const BatchRun& run_;
  const BatchScene& scene_;
  std::string method_;
  fs::path folder_;
  JobRecord record_;
  bool evaluating_ = false;
  std::unique_ptr<ChildProcess> process_;
};

/// Two batches in one folder would take each other's files away. Shards share a folder: each has a
/// lock of its own. The system frees it however the process ends.
class FolderLock {
 public:
  FolderLock(const fs::path& folder, const Shard& shard)
      : file_(folder / ("shard-" + std::to_string(shard.index) + "-of-" +
                        std::to_string(shard.count) + ".lock")),
        descriptor_(::open(file_.c_str(), O_CREAT | O_RDWR | O_NOFOLLOW | O_CLOEXEC, 0644)) {
    if (descriptor_ >= 0 && ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
    const int why = errno;
    if (descriptor_ >= 0) ::close(descriptor_);
    throw Error(Error::Kind::Input,
                folder.string() + (why == EWOULDBLOCK
                                       ? ": another batch is at work here; wait for it, or name "
                                         "another folder with -o"
                                       : std::string(": cannot be written: ") + std::strerror(why) +
                                             "; name another with -o"));
  }
  ~FolderLock() { ::close(descriptor_); }  // the file stays: who removed it could remove another's
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  fs::path file_;
  int descriptor_;
};

using Jobs = std::deque<std::unique_ptr<Job>>;

Jobs jobs_of(const BatchPlan& plan, const BatchRun& run) {
  Jobs jobs;
  for (std::size_t k = 0; k < plan.scenes.size(); ++k) {
    if (!run.shard.has(k)) continue;
    for (const std::string& method : plan.methods)
      jobs.push_back(std::make_unique<Job>(plan, run, plan.scenes[k], method));
  }
  return jobs;
}

}  // namespace

double BatchState::seconds_left() const {
  const auto ran = static_cast<double>(done + failed);
  return ran == 0 ? 0 : seconds / ran * static_cast<double>(jobs - ended());
}

BatchState run_batch(const BatchPlan& plan, const BatchRun& run, const BatchProgress& progress) {
  make_folder(run.folder);
  const FolderLock lock(run.folder, run.shard);
  write_plan(plan, run.folder);
  Jobs waiting = jobs_of(plan, run), running;
  BatchState state;
  state.jobs = waiting.size();
  if (!run.fresh)
    state.skipped = std::erase_if(waiting, [](const auto& job) { return job->is_done(); });
  const auto start = Clock::now();
  const auto tell = [&](const std::string& failure) {
    state.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (progress) progress(state, failure);
  };
  tell("");
  while (!waiting.empty() || !running.empty()) {
    while (!waiting.empty() && running.size() < run.jobs) {
      running.push_back(std::move(waiting.front()));
      waiting.pop_front();
      running.back()->start();
    }
    std::erase_if(running, [&](const auto& job) {
      if (!job->advance()) return false;
      const JobRecord& record = job->record();
      ++(record.done ? state.done : state.failed);
      tell(record.done ? "" : job->name() + ": " + record.reason);
      return true;
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return state;
}

}  // namespace planescope
