// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <string_view>

#include "planescope/error.hpp"
#include "sequence/layouts.hpp"

namespace planescope::sequence {
namespace {

namespace fs = std::filesystem;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Takes the number that `text` starts with, without its leading zeros.
std::string_view take_number(std::string_view& text) {
  std::size_t end = 0;
  while (end < text.size() && is_digit(text[end])) ++end;
  std::string_view number = text.substr(0, end);
  text.remove_prefix(end);
  number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
  return number;
}

/// Names in the order of the numbers in them: `frame-9` before `frame-10`.
bool in_order(std::string_view a, std::string_view b) {
  while (!a.empty() && !b.empty()) {
    if (is_digit(a.front()) && is_digit(b.front())) {
      const std::string_view m = take_number(a), n = take_number(b);
      if (m.size() != n.size()) return m.size() < n.size();
      if (m != n) return m < n;
    } else {
      if (a.front() != b.front()) return a.front() < b.front();
      a.remove_prefix(1);
      b.remove_prefix(1);
    }
  }
  return a.size() < b.size();
}

}  // namespace

std::vector<fs::path> list_files(const fs::path& folder, const std::vector<std::string>& endings) {
  std::vector<std::string> names;
  std::error_code failure;
  for (fs::directory_iterator it(folder, failure), end; !failure && it != end;
       it.increment(failure)) {
    const std::string name = it->path().filename().string();
    const auto fits = [&](const std::string& ending) { return name.ends_with(ending); };
    if (!name.starts_with('.') && std::ranges::any_of(endings, fits)) names.push_back(name);
  }
  if (failure) {
    throw Error(Error::Kind::Input, folder.string() + ": cannot be read: " + failure.message());
  }
  std::ranges::sort(names);
  std::ranges::stable_sort(names, in_order);
  std::vector<fs::path> files;
  files.reserve(names.size());
  for (const std::string& name : names) files.push_back(folder / name);
  return files;
}

bool has_pose_files(const fs::path& folder, SequenceLayout layout) {
  if (layout == SequenceLayout::Redwood) return fs::exists(folder / "trajectory.log");
  if (layout == SequenceLayout::Tum) return fs::exists(folder / "groundtruth.txt");
  return !list_files(folder, {".pose.txt"}).empty();
}

SequenceLayout detect_layout(const fs::path& folder, bool with_poses) {
  if (!fs::is_directory(folder)) {
    throw Error(Error::Kind::Input, folder.string() + ": is no folder; expected an RGB-D sequence");
  }
  const bool poses_of_redwood = fs::exists(folder / "trajectory.log");
  const bool poses_of_tum = fs::exists(folder / "groundtruth.txt");
  if (poses_of_redwood && fs::is_directory(folder / "depth")) return SequenceLayout::Redwood;
  if (poses_of_tum && fs::exists(folder / "depth.txt")) return SequenceLayout::Tum;
  if (!list_files(folder, {".depth.png"}).empty()) return SequenceLayout::Frames;
  if (!with_poses && fs::exists(folder / "depth.txt")) return SequenceLayout::Tum;
  if (!with_poses && fs::is_directory(folder / "depth")) return SequenceLayout::Redwood;
  const bool depths = fs::is_directory(folder / "depth") || fs::exists(folder / "depth.txt");
  throw Error(Error::Kind::Input,
              folder.string() + (depths ? ": has depth images but no poses" : ": is no sequence") +
                  "; expected depth.txt and groundtruth.txt (TUM), depth/ and trajectory.log "
                  "(Open3D), or frame-*.depth.png and frame-*.pose.txt (7-Scenes)");
}

}  // namespace planescope::sequence
