// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/deep_stack.hpp"

#include <pthread.h>

#include <exception>

#include "planescope/error.hpp"

namespace planescope {
namespace {

struct Job {
  const std::function<void()>* work;
  std::exception_ptr failure;
};

void* run(void* argument) {
  Job& job = *static_cast<Job*>(argument);
  try {
    (*job.work)();
  } catch (...) {
    job.failure = std::current_exception();
  }
  return nullptr;
}

}  // namespace

void run_with_stack(std::size_t bytes, const std::function<void()>& work) {
  constexpr std::size_t kPage = 1 << 16;
  Job job{&work, nullptr};
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_t thread{};
  const bool started =
      pthread_attr_setstacksize(&attributes, (bytes + kPage - 1) / kPage * kPage) == 0 &&
      pthread_create(&thread, &attributes, run, &job) == 0;
  pthread_attr_destroy(&attributes);
  if (!started)
    throw Error(Error::Kind::Computation,
                "no thread with a stack of " + std::to_string(bytes >> 20) +
                    " MB for the peer's recursion: enlarge patch_size or free address space");
  pthread_join(thread, nullptr);
  if (job.failure) std::rethrow_exception(job.failure);
}

}  // namespace planescope
