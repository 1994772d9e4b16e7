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

std::optional<std::array<double, 3>> triple(const std::string& text) {
  const auto parts = split(text, ',');
  if (parts.size() != 3) return std::nullopt;
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < 3; ++i) {
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
  const auto values = triple(text);
  if (!values) refuse(option, text, "X,Y,Z, such as 0,0,1");
  return {(*values)[0], (*values)[1], (*values)[2]};
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
  const auto values = triple(text);
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
