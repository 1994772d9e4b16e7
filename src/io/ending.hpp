// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>

/// \file What is put right when the process is asked to end (SIGINT, SIGTERM) while it works. The
/// library only keeps the list; a program that wants it calls run_ending_actions() from a thread
/// that waits for signals.
namespace planescope {

/// Something to undo at such an end, for as long as the object lives: a file that is not whole, a
/// process of ours. Once the end has begun, construction and destruction wait for it, for ever:
/// nothing new is begun.
class EndingAction {
 public:
  explicit EndingAction(std::function<void()> undo);
  ~EndingAction();
  EndingAction(const EndingAction&) = delete;
  EndingAction& operator=(const EndingAction&) = delete;
};

/// While it lives, the end waits: for steps that are short and must not be half done.
class EndingPause {
 public:
  EndingPause();
  ~EndingPause();
  EndingPause(const EndingPause&) = delete;
  EndingPause& operator=(const EndingPause&) = delete;
};

/// Runs all actions, the latest first. The process must end after it: what is undone is not begun
/// again. For a thread of its own, never for a signal handler.
void run_ending_actions();

}  // namespace planescope
