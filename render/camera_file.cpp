// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/whole_file.hpp"
#include "json_file.hpp"
#include "planescope/camera.hpp"
#include "planescope/error.hpp"

/// \file Cameras as JSON.
namespace planescope {
namespace {

using Json = nlohmann::ordered_json;
constexpr const char* kHint = "`planescope render --save-camera` writes such a file";

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
  throw Error(Error::Kind::Input, name + ": " + what + "; " + kHint);
}

double number(const Json& json, const std::string& key, const std::string& name) {
  if (!json.at(key).is_number()) refuse(name, "`" + key + "` should be a number");
  return json.at(key).get<double>();
}

Eigen::Vector3d vector(const Json& json, const std::string& key, const std::string& name) {
  Eigen::Vector3d v = Eigen::Vector3d::Constant(NAN);
  const bool found =
      json.is_object() && json.contains(key) && json.at(key).is_array() && json.at(key).size() == 3;
  for (Eigen::Index i = 0; found && i < 3; ++i) {
    const Json& item = json.at(key).at(static_cast<std::size_t>(i));
    if (item.is_number()) v[i] = item.get<double>();
  }
  if (!v.allFinite()) refuse(name, "`" + key + "` should be three numbers");
  return v;
}

}  // namespace

std::string camera_json(const Camera& camera) {
  const auto list = [](const Eigen::Vector3d& v) { return Json{v.x(), v.y(), v.z()}; };
  Json json = {{"position", list(camera.position)},
               {"focal", list(camera.focal)},
               {"up", list(camera.up)},
               {"view_angle", camera.view_angle}};
  if (camera.parallel()) json["parallel_height"] = camera.parallel_height;
  return json.dump();
}

Camera parse_camera(const std::string& text, const std::string& name) {
  const Json json = parse_json(text, name, kHint);
  Camera camera;
  camera.position = vector(json, "position", name);
  camera.focal = vector(json, "focal", name);
  const Eigen::Vector3d up = vector(json, "up", name);
  if (json.contains("view_angle")) camera.view_angle = number(json, "view_angle", name);
  if (json.contains("parallel_height"))
    camera.parallel_height = number(json, "parallel_height", name);
  if (!(camera.view_angle >= 0.1 && camera.view_angle <= 170))
    refuse(name, "`view_angle` should be 0.1 to 170 degrees");
  if (!(camera.parallel_height >= 0) || !std::isfinite(camera.parallel_height))
    refuse(name, "`parallel_height` should be a length in metres");
  if (!((camera.focal - camera.position).norm() > 1e-9))
    refuse(name, "`position` and `focal` are the same place");
  const Eigen::Vector3d flat = up - up.dot(camera.forward()) * camera.forward();
  if (!(flat.norm() > 1e-6 * up.norm())) refuse(name, "`up` lies along the view");
  camera.up = flat.normalized();
  return camera;
}

Camera read_camera(const std::filesystem::path& file) {
  return parse_camera(read_json_text(file, kHint), file.string());
}

void write_camera(const Camera& camera, const std::filesystem::path& file) {
  write_whole(file, camera_json(camera) + "\n");
}

}  // namespace planescope
