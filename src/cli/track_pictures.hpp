// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/track_tables.hpp"
#include "planescope/render.hpp"
#include "planescope/sequence.hpp"
#include "planescope/track.hpp"

namespace planescope::cli {

/// Takes a picture of the map at each segmentation.
class TrackCamera {
 public:
  /// \param how `steady` or `sensor`; else no picture is taken. \param drawing view and size; the
  /// animation is half as large. \param options of the tracker.
  /// \throws Error as Sequence::read() and segment() do.
  TrackCamera(const std::string& how, const RenderOptions& drawing, const Sequence& sequence,
              const TrackOptions& options);

  /// After a step: adds a picture to `pictures` if there is something new to see.
  void take(const MapTracker& tracker, const TrackStep& step, const FrameInfo& frame,
            std::vector<std::string>& pictures) const;

 private:
  bool on_ = false, follows_ = false;
  RenderOptions drawing_;
  PinholeCamera lens_;
};

/// growth.png of the pictures, if there are any, and track.png, a plot of the tables.
void write_track_pictures(const std::vector<std::string>& pictures, const TrackTables& tables,
                          const std::filesystem::path& folder);

}  // namespace planescope::cli
