// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cli/track_tables.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "io/whole_file.hpp"

namespace planescope::cli {
namespace {

double percent(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 100 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

void TrackTables::add_row(const TrackStep& s, int segmented) {
  char line[256];
  std::snprintf(line, sizeof line, "%u,%d,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu\n",
                s.frame, segmented, s.pieces, s.changed, s.tiles, s.waiting, s.points, s.patches,
                s.planes, s.segments, s.carried, s.kept, s.steady, s.steady_kept);
  frames_ += line;
  for (const TrackEvent& event : s.events) {
    std::snprintf(line, sizeof line, "%u,%s,%u,%u,%u\n", event.frame,
                  std::string(name(event.kind)).c_str(), event.object, event.other, event.points);
    events_ += line;
  }
  event_count_ += s.events.size();
}

void TrackTables::add(TrackStep step, double fusion) {
  add_row(step, step.segmented ? 1 : 0);
  carried_ += step.carried;
  kept_ += step.kept;
  steady_ += step.steady;
  steady_kept_ += step.steady_kept;
  step.events.clear();
  steps_.push_back(std::move(step));
  fusion_.push_back(fusion);
}

void TrackTables::close(const TrackStep& step) {
  add_row(step, 2);
  whole_ = step;
}

void TrackTables::add_jump(std::uint32_t frame) {
  events_ += std::to_string(frame) + ",jump,0,0,0\n";
  ++jumps_;
}

void TrackTables::write(const std::filesystem::path& folder) const {
  write_whole(folder / "frames.csv", frames_);
  write_whole(folder / "events.csv", events_);
  std::string times = "frame,tracking_ms,fusion_ms\n";
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    char line[96];
    std::snprintf(line, sizeof line, "%u,%.3f,%.3f\n", steps_[i].frame, steps_[i].milliseconds,
                  fusion_[i]);
    times += line;
  }
  write_whole(folder / "times.csv", times);
}

std::string TrackTables::summary() const {
  double tracking = 0, fusion = 0, worst = 0;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    tracking += steps_[i].milliseconds;
    fusion += fusion_[i];
    // Half of the map is seen from here on.
    if (2 * steps_[i].points >= whole_.points) worst = std::max(worst, steps_[i].milliseconds);
  }
  const double count = std::max(1.0, static_cast<double>(steps_.size()));
  char text[320];
  std::snprintf(
      text, sizeof text,
      "tracking %.1f ms a frame (at most %.1f once half of the map is seen), the whole at "
      "once %.1f, fusion %.1f a frame; %llu events; of the places %.2f %% keep their "
      "object at a segmentation, %.2f %% of those seen often",
      tracking / count, worst, whole_.milliseconds, fusion / count,
      static_cast<unsigned long long>(event_count_), percent(kept_, carried_),
      percent(steady_kept_, steady_));
  return text;
}

void TrackTables::store(io::StateWriter& to) const {
  to.text(frames_);
  to.text(events_);
  for (const std::uint64_t value : {jumps_, event_count_, carried_, kept_, steady_, steady_kept_}) {
    to.put(value);
  }
}

void TrackTables::restore(io::StateReader& from) {
  frames_ = from.text();
  events_ = from.text();
  for (std::uint64_t* value :
       {&jumps_, &event_count_, &carried_, &kept_, &steady_, &steady_kept_}) {
    *value = from.get<std::uint64_t>();
  }
}

std::string objects_csv(const std::vector<std::uint32_t>& objects) {
  std::string text = "label,object\n";
  for (std::size_t s = 0; s < objects.size(); ++s) {
    text += std::to_string(s + 1);
    text += ',';
    text += std::to_string(objects[s]);
    text += '\n';
  }
  return text;
}

}  // namespace planescope::cli
