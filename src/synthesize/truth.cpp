// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>
#include <string>

#include <nlohmann/json.hpp>

#include "io/whole_file.hpp"
#include "json_file.hpp"
#include "planescope/error.hpp"
#include "planescope/synthesize.hpp"

namespace planescope {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "planescope-truth";
constexpr int kVersion = 1;
constexpr const char* kHint = "expected the truth that `planescope synthesize` writes";
constexpr double kMaxValue = 1e9;  // [m], [m^2]

template <typename Vector>
Json to_json(const Vector& v) {
  return Json::array({v.x(), v.y(), v.z()});
}

// Looks into a JSON document that nobody has checked; says where it is wrong.
class Reader {
 public:
  explicit Reader(std::string file) : file_(std::move(file)) {}

  [[noreturn]] void fail(const std::string& what) const {
    throw Error(Error::Kind::Input, file_ + ": " + what + "; " + kHint);
  }

  const Json& member(const Json& object, const char* key, const std::string& where) const {
    if (!object.is_object() || !object.contains(key)) fail(where + ": no member \"" + key + '"');
    return object[key];
  }

  double number(const Json& value, const std::string& where) const {
    if (!value.is_number()) fail(where + " is not a number");
    const double x = value.get<double>();
    if (!(std::abs(x) <= kMaxValue)) fail(where + " is not within 1e9");
    return x;
  }

  Eigen::Vector3d vector(const Json& value, const std::string& where) const {
    if (!value.is_array() || value.size() != 3) fail(where + " is not a list of 3 numbers");
    return {number(value[0], where), number(value[1], where), number(value[2], where)};
  }

  TruePlane plane(const Json& value, const std::string& where) const {
    TruePlane plane;
    const Json& name = member(value, "name", where);
    const Json& label = member(value, "label", where);
    const Json& structural = member(value, "structural", where);
    if (!name.is_string()) fail(where + ".name is not a string");
    if (!label.is_number_unsigned() ||
        label.get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max()) {
      fail(where + ".label is not a whole number from 0 to 4294967295");
    }
    if (!structural.is_boolean()) fail(where + ".structural is neither true nor false");
    plane.name = name.get<std::string>();
    plane.label = label.get<std::uint32_t>();
    plane.structural = structural.get<bool>();
    plane.area = number(member(value, "area", where), where + ".area");
    if (plane.area < 0) fail(where + ".area is negative");
    const Eigen::Vector3d normal = vector(member(value, "normal", where), where + ".normal");
    if (std::abs(normal.norm() - 1) > 1e-3) fail(where + ".normal is not of length 1");
    plane.plane.normal = normal.cast<float>();
    plane.plane.distance =
        static_cast<float>(number(member(value, "distance", where), where + ".distance"));
    plane.centroid = vector(member(value, "centroid", where), where + ".centroid").cast<float>();
    return plane;
  }

 private:
  std::string file_;
};

// The same plane, seen from another origin: `from` - `to` is added to every position.
void move(TruePlane& plane, const Eigen::Vector3d& shift) {
  if (shift.isZero(0)) return;
  const double distance = static_cast<double>(plane.plane.distance);
  plane.plane.distance =
      static_cast<float>(distance + plane.plane.normal.cast<double>().dot(shift));
  plane.centroid = (plane.centroid.cast<double>() + shift).cast<float>();
}

}  // namespace

void write_truth(const SynthesizedScene& scene, const std::filesystem::path& json_file) {
  Json planes = Json::array();
  for (const TruePlane& plane : scene.planes) {
    planes.push_back({{"name", plane.name},
                      {"label", plane.label},
                      {"structural", plane.structural},
                      {"area", plane.area},
                      {"normal", to_json(plane.plane.normal)},
                      {"distance", plane.plane.distance},
                      {"centroid", to_json(plane.centroid)}});
  }
  const Json document = {{"format", kFormat},
                         {"version", kVersion},
                         {"origin", to_json(scene.cloud.origin)},
                         {"objects", scene.objects},
                         {"planes", std::move(planes)}};
  write_whole(json_file, document.dump(1) + "\n");
}

std::vector<TruePlane> read_true_planes(const std::filesystem::path& json_file,
                                        const Eigen::Vector3d& origin) {
  const Reader reader(json_file.string());
  const Json document = read_json(json_file, kHint);
  if (reader.member(document, "format", "the document") != kFormat) {
    reader.fail("\"format\" is not \"planescope-truth\"");
  }
  if (reader.member(document, "version", "the document") != kVersion) {
    reader.fail("\"version\" is not 1");
  }
  const Eigen::Vector3d own =
      reader.vector(reader.member(document, "origin", "the document"), "origin");
  const Json& list = reader.member(document, "planes", "the document");
  if (!list.is_array()) reader.fail("\"planes\" is not a list");
  std::vector<TruePlane> planes;
  for (std::size_t i = 0; i < list.size(); ++i) {
    planes.push_back(reader.plane(list[i], "planes[" + std::to_string(i) + "]"));
    move(planes.back(), own - origin);
  }
  return planes;
}

}  // namespace planescope
