// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
// A map that grows: fused frame by frame, segmented as it changes, objects keep their numbers. A
// SLAM system gives its own pieces instead of changed_pieces().
#include <filesystem>
#include <iostream>

#include <planescope/error.hpp>
#include <planescope/synthesize.hpp>
#include <planescope/track.hpp>

int main() {
  try {
    const auto folder = std::filesystem::temp_directory_path() / "planescope-walk";
    planescope::write_sequence({.points = 1000}, 12, folder);
    const planescope::Sequence sequence(folder);
    planescope::TsdfVolume volume({.voxel_size = 0.02});
    planescope::MapTracker tracker;
    for (std::uint32_t i = 0; i < sequence.size(); ++i) {
      const planescope::Frame frame = sequence.read(i);
      volume.integrate(frame.depth, frame.color, sequence.camera(), frame.info.pose);
      const planescope::TrackStep step = tracker.update(i, changed_pieces(volume, i));
      for (const auto& event : step.events) {
        std::cout << "frame " << event.frame << ": " << name(event.kind) << " " << event.object
                  << "\n";
      }
    }
    std::cout << tracker.scene().segments.segments.size() << " segments\n";
    std::filesystem::remove_all(folder);
  } catch (const planescope::Error& error) {
    std::cerr << error.what() << "\n";
    return error.exit_code();
  }
}
