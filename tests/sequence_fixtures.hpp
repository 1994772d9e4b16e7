// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "fixtures.hpp"
#include "planescope/image.hpp"
#include "planescope/sequence.hpp"

/// \file Small sequences on disk, for the tests.
namespace planescope::testing {

inline constexpr std::uint32_t kSmallWidth = 8, kSmallHeight = 6;

/// All pixels at the same stored depth.
inline DepthImage flat_depth(std::uint16_t value, std::uint32_t width = kSmallWidth,
                             std::uint32_t height = kSmallHeight) {
  return {width, height, std::vector<std::uint16_t>(std::size_t{width} * height, value)};
}

inline ColorImage flat_color(Rgb color, std::uint32_t width = kSmallWidth,
                             std::uint32_t height = kSmallHeight) {
  return {width, height, std::vector<Rgb>(std::size_t{width} * height, color)};
}

/// A pose that turns by 90 degrees about z and moves by (1, 2, 3 + k).
inline Eigen::Isometry3d pose_of(int k) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  pose.translation() = Eigen::Vector3d(1, 2, 3 + k);
  return pose;
}

inline std::string matrix_text(int k) {
  return "0 -1 0 1\n1 0 0 2\n0 0 1 " + std::to_string(3 + k) + "\n0 0 0 1\n";
}

inline std::string number_text(int k) {
  char text[16];
  std::snprintf(text, sizeof text, "%06d", k);
  return text;
}

inline void write_camera(const std::filesystem::path& folder, double scale) {
  write_bytes(folder / "camera.txt", "# width height fx fy cx cy depth_scale\n8 6 7 7.5 3.5 2.5 " +
                                         std::to_string(scale) + "\n");
}

/// depth/, image/, trajectory.log.
inline void write_redwood(const std::filesystem::path& folder, int frames) {
  std::filesystem::create_directories(folder / "depth");
  std::filesystem::create_directories(folder / "image");
  std::string log;
  for (int k = 0; k < frames; ++k) {
    write_depth_image(flat_depth(static_cast<std::uint16_t>(1000 + k)),
                      folder / "depth" / (number_text(k) + ".png"));
    write_color_image(flat_color({static_cast<std::uint8_t>(k), 1, 2}),
                      folder / "image" / (number_text(k) + ".png"));
    const std::string n = std::to_string(k);
    log += n + " " + n + " " + std::to_string(k + 1) + "\n" + matrix_text(k);
  }
  write_bytes(folder / "trajectory.log", log);
  write_camera(folder, 1000);
}

/// frame-NNNNNN.*
inline void write_frames(const std::filesystem::path& folder, int frames) {
  std::filesystem::create_directories(folder);
  for (int k = 0; k < frames; ++k) {
    const std::string stem = "frame-" + number_text(k);
    write_depth_image(flat_depth(static_cast<std::uint16_t>(1000 + k)),
                      folder / (stem + ".depth.png"));
    write_color_image(flat_color({static_cast<std::uint8_t>(k), 1, 2}),
                      folder / (stem + ".color.png"));
    write_bytes(folder / (stem + ".pose.txt"), matrix_text(k));
  }
  write_camera(folder, 1000);
}

/// depth.txt, rgb.txt, groundtruth.txt: frame k at 10 + k s, its colour 5 ms and its pose 4 ms
/// later. The quaternion is that of 90 degrees about z.
inline void write_tum(const std::filesystem::path& folder, int frames) {
  std::filesystem::create_directories(folder / "depth");
  std::filesystem::create_directories(folder / "rgb");
  std::string depth = "# time file\n", rgb = "# time file\n",
              poses = "# time tx ty tz qx qy qz qw\n";
  for (int k = 0; k < frames; ++k) {
    const std::string file = number_text(k) + ".png", second = std::to_string(10 + k);
    write_depth_image(flat_depth(static_cast<std::uint16_t>(5 * (1000 + k))),
                      folder / "depth" / file);
    write_color_image(flat_color({static_cast<std::uint8_t>(k), 1, 2}), folder / "rgb" / file);
    depth += second + ".000 depth/" + file + "\n";
    rgb += second + ".005 rgb/" + file + "\n";
    poses += second + ".004 1 2 " + std::to_string(3 + k) +
             " 0 0 0.70710678118654752 0.70710678118654752\n";
  }
  write_bytes(folder / "depth.txt", depth);
  write_bytes(folder / "rgb.txt", rgb);
  write_bytes(folder / "groundtruth.txt", poses);
  write_camera(folder, 5000);
}

}  // namespace planescope::testing
