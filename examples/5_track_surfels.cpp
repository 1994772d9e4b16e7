// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
// Tracking for a SLAM system with a map of its own: surfels in cells. Cells that changed are given
// anew; a loop closure gives all cells that moved. The work is spread over frames, and the tracker
// is stored and read back.
#include <cmath>
#include <iostream>
#include <map>
#include <sstream>
#include <vector>

#include <planescope/error.hpp>
#include <planescope/synthesize.hpp>
#include <planescope/track.hpp>

using namespace planescope;

/// The surfels of a map (here: points with normals) by cells of 32 cm.
std::vector<SurfacePiece> cells_of(const PointCloud& surfels, float from, float to) {
  std::map<BlockKey, PointCloud> cells;
  for (std::size_t i = 0; i < surfels.size(); ++i) {
    const Eigen::Vector3f& p = surfels.positions[i];
    const auto part = [](float v) { return static_cast<std::int32_t>(std::floor(v / 0.32f)); };
    if (p.x() < from || p.x() >= to) continue;
    PointCloud& cell = cells[{part(p.x()), part(p.y()), part(p.z())}];
    cell.positions.push_back(p);
    cell.normals.push_back(surfels.normals[i]);
  }
  std::vector<SurfacePiece> pieces;
  for (auto& [key, points] : cells) pieces.push_back({key, std::move(points)});
  return pieces;
}

int main() {
  try {
    const PointCloud room = synthesize({.points = 600'000, .normals = true}).cloud;
    TrackOptions options;
    options.interval = 5;  // segmented every fifth frame,
    options.share = 0.2;   // and a fifth of the map patched in each of the first two
    MapTracker tracker(options);
    for (std::uint32_t frame = 0; frame < 40; ++frame) {
      // What this frame changed: the cells of a slab of 32 cm, wider than the room after all.
      const float from = -6.4f + 0.32f * static_cast<float>(frame);
      const TrackStep step = tracker.update(frame, cells_of(room, from, from + 0.32f));
      for (const TrackEvent& event : step.events) {
        if (event.kind != TrackEventKind::Plane) continue;
        std::cout << "frame " << frame << ": object " << event.object << " is on a plane\n";
      }
    }
    std::stringstream stored;  // a file, opened as binary
    tracker.write(stored);
    const MapTracker again = MapTracker::read(stored, "stored");
    const TrackResult result = again.finish(40);
    std::cout << result.scene.segments.segments.size() << " segments of " << result.map.size()
              << " points\n";
  } catch (const Error& error) {
    std::cerr << error.what() << "\n";
    return error.exit_code();
  }
}
