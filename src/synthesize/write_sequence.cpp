// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "io/whole_file.hpp"
#include "planescope/error.hpp"
#include "planescope/image.hpp"
#include "planescope/synthesize.hpp"
#include "synthesize/room.hpp"
#include "synthesize/sampling.hpp"
#include "synthesize/seen_area.hpp"
#include "synthesize/views.hpp"
#include "synthesize/walk.hpp"

namespace planescope {
namespace {

namespace fs = std::filesystem;
using synthesis::Camera;

constexpr double kScale = 1000;  // stored units a metre, as Open3D takes them

DepthImage to_depth(const PointCloud& view) {
  DepthImage image{view.width, view.height, {}};
  image.values.reserve(view.size());
  for (const Eigen::Vector3f& p : view.positions) {
    image.values.push_back(is_finite(p)
                               ? static_cast<std::uint16_t>(std::lround(double(p.z()) * kScale))
                               : std::uint16_t{0});
  }
  return image;
}

std::string file_name(std::uint32_t frame) {
  char text[16];
  std::snprintf(text, sizeof text, "%05u.png", frame);
  return text;
}

std::string trajectory_entry(std::uint32_t frame, const Eigen::Isometry3d& pose) {
  char text[256];
  std::snprintf(text, sizeof text, "%u %u %u\n", frame, frame, frame + 1);
  std::string entry = text;
  for (int row = 0; row < 4; ++row) {
    const auto& m = pose.matrix();
    std::snprintf(text, sizeof text, "%.10f %.10f %.10f %.10f\n", m(row, 0) + 0.0, m(row, 1) + 0.0,
                  m(row, 2) + 0.0, m(row, 3) + 0.0);
    entry += text;
  }
  return entry;
}

void make_folder(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) {
    throw Error(Error::Kind::Input, folder.string() + ": cannot be made: " + failure.message());
  }
}

void write_camera(const fs::path& folder, const Camera& camera) {
  char text[160];
  std::snprintf(text, sizeof text,
                "# width height fx fy cx cy depth_scale\n%d %d %.10g %.10g %.10g %.10g %g\n",
                camera.width, camera.height, camera.focal, camera.focal, camera.cx, camera.cy,
                kScale);
  write_whole(folder / "camera.txt", text);
}

}  // namespace

SynthesizedScene write_sequence(const SynthesisOptions& options, std::uint32_t frames,
                                const fs::path& folder, const Progress& progress) {
  if (frames < 1 || frames > kMostFrames) {
    throw Error(Error::Kind::Usage, "synthesize: the sequence has " + std::to_string(frames) +
                                        " frames; expected 1 to " + std::to_string(kMostFrames));
  }
  SynthesisOptions exact = options;
  exact.views = 0;
  exact.noise = 0;
  SynthesizedScene made = synthesize(exact);
  const synthesis::Room room = synthesis::make_room(options.random_seed, options.ceiling);
  const synthesis::RayCaster caster(room.scene);
  const std::vector<Camera> cameras = synthesis::walk_through(room, options.random_seed, frames);
  synthesis::SeenArea seen(room.scene);
  make_folder(folder / "depth");
  make_folder(folder / "image");
  const Eigen::Translation3d shift(options.offset);
  std::string trajectory;
  for (std::uint32_t k = 0; k < frames; ++k) {
    if (progress) progress("frames", double(k) / frames);
    const synthesis::DepthView depth = render_depth(caster, cameras[k]);
    const PointCloud view = sense(room.scene, cameras[k], depth, options, k);
    seen.add(cameras[k], depth, view);
    write_depth_image(to_depth(view), folder / "depth" / file_name(k));
    write_color_image({view.width, view.height, view.colors}, folder / "image" / file_name(k));
    trajectory += trajectory_entry(k, shift * cameras[k].pose);
  }
  made.planes = synthesis::describe_seen(
      room.scene, seen,
      Eigen::Isometry3d(Eigen::Translation3d(options.offset - made.cloud.origin)));
  write_camera(folder, cameras.front());
  write_whole(folder / "trajectory.log", trajectory);  // last: without it, it is no sequence
  if (progress) progress("frames", 1);
  return made;
}

}  // namespace planescope
