// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cli/signals.hpp"

#include <pthread.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include "io/ending.hpp"

namespace planescope::cli {
namespace {

bool is_ignored(int signal) {
  struct sigaction action {};
  return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

/// Ends the process by the signal itself, so that the shell sees why.
[[noreturn]] void die_by(int signal) {
  std::signal(signal, SIG_DFL);
  sigset_t one;
  sigemptyset(&one);
  sigaddset(&one, signal);
  ::kill(::getpid(), signal);
  pthread_sigmask(SIG_UNBLOCK, &one, nullptr);
  ::_exit(128 + signal);
}

}  // namespace

void handle_signals() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  sigset_t waited;
  sigemptyset(&waited);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (!is_ignored(signal)) sigaddset(&waited, signal);
  }
  // Blocked in every thread to come, so that they are left to the one that waits for them: it may
  // lock and allocate, which a handler may not.
  pthread_sigmask(SIG_BLOCK, &waited, nullptr);
  std::thread([waited] {
    int signal = 0;
    while (sigwait(&waited, &signal) != 0) {
    }
    run_ending_actions();
    die_by(signal);
  }).detach();
}

}  // namespace planescope::cli
