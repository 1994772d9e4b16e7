// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/ending.hpp"

#include <mutex>
#include <utility>
#include <vector>

namespace planescope {
namespace {

/// Never destroyed: the thread that waits for signals may outlive static objects.
struct Actions {
  std::recursive_mutex mutex;  // a pause may hold files
  std::vector<std::pair<const EndingAction*, std::function<void()>>> list;
};

Actions& actions() {
  static auto* all = new Actions;
  return *all;
}

}  // namespace

EndingAction::EndingAction(std::function<void()> undo) {
  const std::lock_guard lock(actions().mutex);
  actions().list.emplace_back(this, std::move(undo));
}

EndingAction::~EndingAction() {
  const std::lock_guard lock(actions().mutex);
  std::erase_if(actions().list, [&](const auto& entry) { return entry.first == this; });
}

EndingPause::EndingPause() { actions().mutex.lock(); }
EndingPause::~EndingPause() { actions().mutex.unlock(); }

void run_ending_actions() {
  actions().mutex.lock();  // and never unlocked
  auto& list = actions().list;
  for (auto entry = list.rbegin(); entry != list.rend(); ++entry) entry->second();
}

}  // namespace planescope
