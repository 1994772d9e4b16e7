// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

/// \file What planescope uses of oneTBB, on std::thread. The thread sanitizer has to see how
/// threads are started and joined, or it takes every hand-over for a race; it does not see into a
/// libtbb that was not built with it, such as Debian's. Here it sees everything, and tasks run on
/// four threads even where there are fewer cores, so that races of our own have a chance to show.
/// The preset `tsan` puts this in the place of the headers in tbb/ and oneapi/tbb/. Not for use
/// elsewhere: a thread a task is slow.
namespace tbb {

class global_control {
 public:
  enum parameter { max_allowed_parallelism };
  global_control(parameter, std::size_t most) : before_(limit().exchange(most)) {}
  ~global_control() { limit() = before_; }
  global_control(const global_control&) = delete;
  global_control& operator=(const global_control&) = delete;

  static std::atomic<std::size_t>& limit() {
    static std::atomic<std::size_t> most = 4;
    return most;
  }

 private:
  std::size_t before_;
};

namespace this_task_arena {
inline int max_concurrency() { return static_cast<int>(global_control::limit().load()); }
}  // namespace this_task_arena

/// Calls task(k) for k below `count` from up to as many threads as are allowed; the first exception
/// is thrown on once all have ended.
template <typename Task>
void run_tasks(std::size_t count, const Task& task) {
  const std::size_t threads = std::min<std::size_t>(count, global_control::limit());
  std::atomic<bool> failed = false;
  std::exception_ptr failure;
  std::mutex failing;
  // Every thread has tasks of its own: were they handed out as threads come free, the first could
  // have done all of them before the second starts, and there would be no race to be seen.
  const auto work = [&](std::size_t first) {
    for (std::size_t k = first; k < count && !failed.load(std::memory_order_relaxed);
         k += threads) {
      try {
        task(k);
      } catch (...) {
        const std::lock_guard lock(failing);
        if (!failure) failure = std::current_exception();
        failed.store(true, std::memory_order_relaxed);
      }
    }
  };
  std::vector<std::thread> others;
  for (std::size_t t = 1; t < threads; ++t) others.emplace_back(work, t);
  work(0);
  for (std::thread& other : others) other.join();
  if (failure) std::rethrow_exception(failure);
}

template <typename Value>
class blocked_range {
 public:
  blocked_range(Value begin, Value end, std::size_t grain = 1)
      : begin_(begin), end_(end), grain_(grain) {}
  Value begin() const { return begin_; }
  Value end() const { return end_; }
  std::size_t grainsize() const { return grain_; }

 private:
  Value begin_, end_;
  std::size_t grain_;
};

/// Splits a range into up to 16 parts, none smaller than its grain but the last.
template <typename Value, typename Body>
void for_parts(const blocked_range<Value>& range, const Body& body) {
  const auto size = static_cast<std::size_t>(range.end() - range.begin());
  const std::size_t step = std::max({range.grainsize(), (size + 15) / 16, std::size_t{1}});
  run_tasks((size + step - 1) / step, [&](std::size_t k) {
    const std::size_t begin = k * step, end = std::min(size, begin + step);
    body(blocked_range<Value>(range.begin() + static_cast<Value>(begin),
                              range.begin() + static_cast<Value>(end), range.grainsize()));
  });
}

template <typename Value, typename Body>
void parallel_for(const blocked_range<Value>& range, const Body& body) {
  for_parts(range, body);
}

template <typename Index, typename Body>
requires std::is_integral_v<Index>
void parallel_for(Index first, Index last, const Body& body) {
  if (first >= last) return;
  run_tasks(static_cast<std::size_t>(last - first),
            [&](std::size_t k) { body(first + static_cast<Index>(k)); });
}

template <typename Value, typename Result, typename Body, typename Join>
Result parallel_reduce(const blocked_range<Value>& range, const Result& identity, const Body& body,
                       const Join& join) {
  Result all = identity;
  std::mutex joining;
  for_parts(range, [&](const blocked_range<Value>& part) {
    const Result mine = body(part, identity);
    const std::lock_guard lock(joining);
    all = join(all, mine);
  });
  return all;
}

template <typename First, typename Second>
void parallel_invoke(const First& first, const Second& second) {
  run_tasks(2, [&](std::size_t k) { k == 0 ? first() : second(); });
}

template <typename Iterator, typename... Compare>
void parallel_sort(Iterator begin, Iterator end, const Compare&... compare) {
  std::sort(begin, end, compare...);
}

/// One value a thread.
template <typename T>
class enumerable_thread_specific {
 public:
  T& local() {
    const std::lock_guard lock(mutex_);
    const auto me = std::this_thread::get_id();
    const auto at = std::find(owners_.begin(), owners_.end(), me);
    if (at != owners_.end()) return values_[static_cast<std::size_t>(at - owners_.begin())];
    owners_.push_back(me);
    return values_.emplace_back();
  }
  auto begin() { return values_.begin(); }
  auto end() { return values_.end(); }

 private:
  std::mutex mutex_;
  std::deque<T> values_;  // references stay valid
  std::vector<std::thread::id> owners_;
};

class flow_control {
 public:
  void stop() { stopped_ = true; }
  bool stopped() const { return stopped_; }

 private:
  bool stopped_ = false;
};

enum class filter_mode { parallel, serial_in_order };

template <typename In, typename Out, typename Body>
struct Filter {
  Body body;
};

template <typename In, typename Out, typename Body>
Filter<In, Out, Body> make_filter(filter_mode, const Body& body) {
  return {body};
}

template <typename First, typename Second>
struct Chain {
  First first;
  Second second;
};

template <typename In, typename Mid, typename A, typename Out, typename B>
auto operator&(const Filter<In, Mid, A>& a, const Filter<Mid, Out, B>& b) {
  return Chain<Filter<In, Mid, A>, Filter<Mid, Out, B>>{a, b};
}

template <typename A, typename B, typename In, typename C>
auto operator&(const Chain<A, B>& ab, const Filter<In, void, C>& c) {
  return Chain<Chain<A, B>, Filter<In, void, C>>{ab, c};
}

/// Source in order, middle in parallel, sink in order, `tokens` at a time.
template <typename Item, typename Source, typename Made, typename Middle, typename Sink>
void parallel_pipeline(std::size_t tokens,
                       const Chain<Chain<Filter<void, Item, Source>, Filter<Item, Made, Middle>>,
                                   Filter<Made, void, Sink>>& pipeline) {
  flow_control control;
  while (!control.stopped()) {
    std::vector<Item> items;
    while (items.size() < tokens) {
      Item item = pipeline.first.first.body(control);
      if (control.stopped()) break;
      items.push_back(std::move(item));
    }
    std::vector<std::optional<Made>> made(items.size());
    run_tasks(items.size(), [&](std::size_t k) { made[k] = pipeline.first.second.body(items[k]); });
    for (std::optional<Made>& one : made) pipeline.second.body(std::move(*one));
  }
}

}  // namespace tbb

namespace oneapi {
namespace tbb = ::tbb;
}
