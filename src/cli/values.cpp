// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cli/values.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <utility>
#include <vector>

#include "planescope/error.hpp"

namespace planescope::cli {
namespace {

[[noreturn]] void refuse(const std::string& option, const std::string& text,
                         const std::string& expected) {
  throw Error(Error::Kind::Usage, option + " is `" + text + "`; it takes " + expected);
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

/// The whole text as a finite number, or nothing.
template <class Number>
std::optional<Number> number(const std::string& text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, value);
  if (failure != std::errc() || stop != end || !std::isfinite(static_cast<double>(value))) {
    return std::nullopt;
  }
  return value;
}

/// N numbers with commas, or nothing.
template <std::size_t N>
std::optional<std::array<double, N>> numbers(const std::string& text) {
  const auto parts = split(text, ',');
  if (parts.size() != N) return std::nullopt;
  std::array<double, N> values{};
  for (std::size_t i = 0; i < N; ++i) {
    const auto value = number<double>(parts[i]);
    if (!value) return std::nullopt;
    values[i] = *value;
  }
  return values;
}

template <class Value, std::size_t N>
std::optional<Value> named(const std::array<std::pair<const char*, Value>, N>& names,
                           const std::string& text) {
  for (const auto& [name, value] : names) {
    if (text == name) return value;
  }
  return std::nullopt;
}

}  // namespace

Eigen::Vector3d parse_vector(const std::string& option, const std::string& text) {
  const auto values = numbers<3>(text);
  if (!values) refuse(option, text, "X,Y,Z, such as 0,0,1");
  return {(*values)[0], (*values)[1], (*values)[2]};
}

std::vector<std::uint32_t> parse_labels(const std::string& option, const std::string& text) {
  std::vector<std::uint32_t> labels;
  for (const std::string& part : split(text, ',')) {
    const auto label = number<std::uint32_t>(part);
    if (!label) refuse(option, text, "labels, whole numbers with commas, such as 1,2");
    labels.push_back(*label);
  }
  return labels;
}

std::array<double, 4> parse_intrinsics(const std::string& option, const std::string& text) {
  const auto values = numbers<4>(text);
  if (!values || !((*values)[0] > 0 && (*values)[1] > 0)) {
    refuse(option, text, "FX,FY,CX,CY in pixels, such as 525,525,319.5,239.5");
  }
  return *values;
}

Eigen::Isometry3d parse_pose(const std::string& option, const std::string& text) {
  const auto v = numbers<7>(text);
  const auto rotation = [&] { return Eigen::Quaterniond((*v)[6], (*v)[3], (*v)[4], (*v)[5]); };
  if (!v || !(std::abs(rotation().norm() - 1) < 0.01)) {
    refuse(option, text, "TX,TY,TZ,QX,QY,QZ,QW, camera to world, with a unit quaternion");
  }
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotation().normalized().toRotationMatrix();
  pose.translation() << (*v)[0], (*v)[1], (*v)[2];
  return pose;
}

std::array<int, 2> parse_size(const std::string& option, const std::string& text) {
  const auto parts = split(text, 'x');
  const auto width = number<int>(parts[0]);
  const auto height = parts.size() == 2 ? number<int>(parts[1]) : std::nullopt;
  const auto fits = [](int n) { return n >= 16 && n <= 16384; };
  if (!width || !height || !fits(*width) || !fits(*height)) {
    refuse(option, text, "WIDTHxHEIGHT in pixels, 16 to 16384 each, such as 1920x1080");
  }
  return {*width, *height};
}

std::array<double, 3> parse_color(const std::string& option, const std::string& text) {
  if (text == "white") return {1, 1, 1};
  if (text == "black") return {0, 0, 0};
  const auto values = numbers<3>(text);
  const auto fits = [](double v) { return v >= 0 && v <= 1; };
  if (!values || !fits((*values)[0]) || !fits((*values)[1]) || !fits((*values)[2])) {
    refuse(option, text, "white, black, or R,G,B from 0 to 1");
  }
  return *values;
}

View parse_view(const std::string& option, const std::string& text) {
  static constexpr std::array<std::pair<const char*, View>, 6> kNames = {
      {{"auto", View::Auto},
       {"iso", View::Iso},
       {"top", View::Top},
       {"front", View::Front},
       {"left", View::Left},
       {"sensor", View::Sensor}}};
  const auto view = named(kNames, text);
  if (!view) refuse(option, text, "auto | iso | top | front | left | sensor");
  return *view;
}

Layer parse_layers(const std::string& option, const std::string& text) {
  static constexpr std::array<std::pair<const char*, Layer>, 5> kNames = {
      {{"scene", Layer::Scene},
       {"patches", Layer::Patches},
       {"segments", Layer::Segments},
       {"planes", Layer::Planes},
       {"graph", Layer::Graph}}};
  std::optional<Layer> layers;
  for (const std::string& part : split(text, ',')) {
    const auto layer = named(kNames, part);
    if (!layer) {
      refuse(option, text, "scene, patches, segments, planes, graph, one or more with commas");
    }
    layers = layers ? *layers | *layer : *layer;
  }
  return *layers;
}

void CameraArguments::declare(CLI::App& command) {
  command.add_option("--size", size, "Size of a picture in pixels (1920x1080)")->type_name("WxH");
  command.add_option("--view", view, "auto | iso | top | front | left | sensor (auto)")
      ->type_name("VIEW");
  command.add_option("--up", up, "Direction that is up, instead of the scene's own")
      ->type_name("X,Y,Z");
}

void CameraArguments::apply(RenderOptions& options) const {
  if (!size.empty()) options.size = parse_size("--size", size);
  if (!view.empty()) options.view = parse_view("--view", view);
  if (up.empty()) return;
  const Eigen::Vector3d direction = parse_vector("--up", up);
  if (!(direction.norm() > 0)) refuse("--up", up, "a direction, which 0,0,0 is not");
  options.up = direction.normalized().cast<float>();
}

}  // namespace planescope::cli
