// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "nearest_name.hpp"
#include "planescope/error.hpp"
#include "planescope/sequence.hpp"
#include "sequence/text_lines.hpp"

namespace planescope {
namespace {

struct NamedCamera {
  const char* name;
  PinholeCamera lens;
};

const std::vector<NamedCamera>& known_cameras() {
  static const std::vector<NamedCamera> cameras = {
      {"primesense", {}},
      {"tum_fr1", {.fx = 517.3, .fy = 516.5, .cx = 318.6, .cy = 255.3}},
      {"tum_fr2", {.fx = 520.9, .fy = 521.0, .cx = 325.1, .cy = 249.7}},
      {"tum_fr3", {.fx = 535.4, .fy = 539.2, .cx = 320.1, .cy = 247.6}},
      {"7scenes", {.fx = 585, .fy = 585, .cx = 320, .cy = 240}},
      {"icl_nuim", {.fx = 481.2, .fy = 480, .cx = 319.5, .cy = 239.5}}};
  return cameras;
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what) {
  throw Error(Error::Kind::Input, file.string() + ": " + what +
                                      "; expected `width height fx fy cx cy [depth_scale]`, or "
                                      "Open3D's JSON with width, height and intrinsic_matrix");
}

std::uint32_t to_side(double value) {
  return value >= 1 && value <= kMostImageSide ? static_cast<std::uint32_t>(value) : 0;
}

CameraFile parse_json(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const auto document = nlohmann::json::parse(in, nullptr, false);
  const auto find = [&](const char* key) -> const nlohmann::json& {
    if (!document.is_object() || !document.contains(key)) {
      refuse(file, std::string("is no JSON with \"") + key + '"');
    }
    return document[key];
  };
  const auto number = [&](const nlohmann::json& value, const char* what) {
    if (!value.is_number()) refuse(file, std::string(what) + " is not a number");
    return value.get<double>();
  };
  const nlohmann::json& matrix = find("intrinsic_matrix");
  if (!matrix.is_array() || matrix.size() != 9) refuse(file, "intrinsic_matrix has not 9 numbers");
  CameraFile camera;
  camera.lens.width = to_side(number(find("width"), "width"));
  camera.lens.height = to_side(number(find("height"), "height"));
  camera.lens.fx = number(matrix[0], "intrinsic_matrix[0]");
  camera.lens.fy = number(matrix[4], "intrinsic_matrix[4]");
  camera.lens.cx = number(matrix[6], "intrinsic_matrix[6]");
  camera.lens.cy = number(matrix[7], "intrinsic_matrix[7]");
  return camera;
}

CameraFile parse_text(const std::filesystem::path& file) {
  sequence::TextLines lines(file, "a camera");
  if (!lines.next()) refuse(file, "has no numbers");
  if (lines.words().size() != 6) lines.require(7, "width height fx fy cx cy [depth_scale]");
  CameraFile camera;
  camera.lens.width = to_side(lines.number(0));
  camera.lens.height = to_side(lines.number(1));
  camera.lens.fx = lines.number(2);
  camera.lens.fy = lines.number(3);
  camera.lens.cx = lines.number(4);
  camera.lens.cy = lines.number(5);
  if (lines.words().size() == 7) camera.depth_scale = lines.number(6);
  return camera;
}

}  // namespace

PinholeCamera named_camera(std::string_view name) {
  for (const NamedCamera& camera : known_cameras()) {
    if (name == camera.name) return camera.lens;
  }
  std::string names;
  for (const std::string& known : camera_names()) {
    if (!names.empty()) names += " | ";
    names += known;
  }
  throw Error(Error::Kind::Usage,
              "there is no camera `" + std::string(name) + "`; it takes " + names);
}

std::vector<std::string> camera_names() {
  std::vector<std::string> names;
  for (const NamedCamera& camera : known_cameras()) names.emplace_back(camera.name);
  return names;
}

CameraFile read_camera_file(const std::filesystem::path& file) {
  constexpr std::uint64_t kMostBytes = 1 << 20;
  const io::InputFile input(file, "a camera");
  if (input.size() > kMostBytes) refuse(file, "has more than 1 MB");
  std::byte first{};
  input.read_at(0, {&first, 1});
  CameraFile camera = first == std::byte{'{'} ? parse_json(file) : parse_text(file);
  const PinholeCamera& lens = camera.lens;
  if (lens.width == 0 || lens.height == 0) refuse(file, "width or height is not 1 to 8192");
  const bool focal = lens.fx > 0 && lens.fy > 0 && lens.fx < 1e6 && lens.fy < 1e6;
  if (!focal || !(std::abs(lens.cx) < 1e6 && std::abs(lens.cy) < 1e6)) {
    refuse(file, "a focal length is not positive, or a number is not below 1e6");
  }
  if (camera.depth_scale && !(*camera.depth_scale > 0 && *camera.depth_scale <= 1e6)) {
    refuse(file, "depth_scale is not within 0 to 1e6 units a metre");
  }
  return camera;
}

}  // namespace planescope
