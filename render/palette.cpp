// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "palette.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Dense>

namespace planescope::draw {
namespace {

double to_linear(std::uint8_t value) {
  const double v = value / 255.0;
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

std::uint8_t from_linear(double light) {
  const double v = std::clamp(light, 0.0, 1.0);
  const double srgb = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * srgb));
}

Eigen::Vector3d linear(const Pixel& c) {
  return {to_linear(c[0]), to_linear(c[1]), to_linear(c[2])};
}

Pixel pixel(const Eigen::Vector3d& light) {
  return {from_linear(light[0]), from_linear(light[1]), from_linear(light[2])};
}

Eigen::Matrix3d rows(std::array<double, 9> values) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(values.data());
}

/// Linear sRGB to cone responses, and their cube roots to Oklab.
Eigen::Matrix3d cones() {
  return rows({0.4122214708, 0.5363325363, 0.0514459929,  //
               0.2119034982, 0.6806995451, 0.1073969566,  //
               0.0883024619, 0.2817188376, 0.6299787005});
}
Eigen::Matrix3d opponents() {
  return rows({0.2104542553, 0.7936177850, -0.0040720468,  //
               1.9779984951, -2.4285922050, 0.4505937099,  //
               0.0259040371, 0.7827717662, -0.8086757660});
}

Eigen::Matrix3d machado(Vision vision) {
  switch (vision) {
    case Vision::Protanopia:
      return rows({0.152286, 1.052583, -0.204868,  //
                   0.114503, 0.786281, 0.099216,   //
                   -0.003882, -0.048116, 1.051998});
    case Vision::Deuteranopia:
      return rows({0.367322, 0.860646, -0.227968,  //
                   0.280085, 0.672501, 0.047413,   //
                   -0.011820, 0.042940, 0.968881});
    case Vision::Tritanopia:
      return rows({1.255528, -0.076749, -0.178779,  //
                   -0.078411, 0.930809, 0.147602,   //
                   0.004733, 0.691367, 0.303900});
    case Vision::Grey:
      return rows({0.2126, 0.7152, 0.0722, 0.2126, 0.7152, 0.0722, 0.2126, 0.7152, 0.0722});
    case Vision::Normal:
      break;
  }
  return Eigen::Matrix3d::Identity();
}

Pixel mix(const Pixel& a, const Pixel& b, double t) {
  Pixel mixed{};
  for (std::size_t c = 0; c < 3; ++c)
    mixed[c] = static_cast<std::uint8_t>(std::lround(a[c] + (b[c] - a[c]) * t));
  return mixed;
}

}  // namespace

Pixel seen_by(Vision vision, const Pixel& color) {
  if (vision == Vision::Normal) return color;
  return pixel(machado(vision) * linear(color));
}

Eigen::Vector3d to_oklab(const Pixel& color) {
  return opponents() * (cones() * linear(color)).unaryExpr([](double v) { return std::cbrt(v); });
}

Pixel from_oklch(double lightness, double chroma, double hue) {
  const double angle = hue * std::numbers::pi / 180;
  double c = chroma;
  while (c > 0) {
    const Eigen::Vector3d lab(lightness, c * std::cos(angle), c * std::sin(angle));
    const Eigen::Vector3d roots = opponents().inverse() * lab;
    const Eigen::Vector3d light = cones().inverse() * roots.array().cube().matrix();
    if (light.minCoeff() >= -1e-4 && light.maxCoeff() <= 1 + 1e-4) return pixel(light);
    c -= 0.002;
  }
  return pixel(Eigen::Vector3d::Constant(std::pow(lightness, 3)));
}

double difference(const Pixel& a, const Pixel& b, Vision vision) {
  return (to_oklab(seen_by(vision, a)) - to_oklab(seen_by(vision, b))).norm();
}

double contrast(const Pixel& a, const Pixel& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vision vision : kVisions) least = std::min(least, difference(a, b, vision));
  return least;
}

std::vector<Pixel> calm_colors() {
  std::vector<Pixel> colors;
  for (const double lightness : {0.90, 0.81, 0.72})
    for (int hue = 70; hue < 430; hue += 40) colors.push_back(from_oklch(lightness, 0.07, hue));
  return colors;
}

std::vector<Pixel> grey_colors() {
  std::vector<Pixel> colors;
  for (const double lightness : {0.90, 0.55, 0.72, 0.40, 0.81, 0.63, 0.47})
    colors.push_back(from_oklch(lightness, 0, 0));
  return colors;
}

std::vector<Pixel> vivid_colors() {
  // Each hue at the lightness where it is most itself, then darker and lighter.
  static constexpr std::array<std::array<double, 2>, 9> hues = {{{255, 0.60},
                                                                 {55, 0.70},
                                                                 {145, 0.66},
                                                                 {20, 0.58},
                                                                 {300, 0.56},
                                                                 {95, 0.82},
                                                                 {200, 0.70},
                                                                 {345, 0.66},
                                                                 {120, 0.76}}};
  std::vector<Pixel> colors;
  for (const double shift : {0.0, -0.13, 0.11})
    for (const auto& [hue, lightness] : hues)
      colors.push_back(from_oklch(std::min(lightness + shift, 0.88), 0.17, hue));
  return colors;
}

Pixel deepened(const Pixel& color) {
  const Eigen::Vector3d lab = to_oklab(color);
  const double chroma = std::hypot(lab.y(), lab.z());
  if (chroma < 0.02) return from_oklch(lab.x() - 0.15, 0, 0);  // grey stays grey
  const double hue = std::atan2(lab.z(), lab.y()) * 180 / std::numbers::pi;
  return from_oklch(std::clamp(lab.x() - 0.12, 0.45, 0.78), std::max(chroma, 0.14), hue);
}

Pixel direction_color(const Eigen::Vector3d& normal) {
  Pixel color{};
  for (std::size_t c = 0; c < 3; ++c)
    color[c] = static_cast<std::uint8_t>(
        std::lround(60 + 185 * std::min(std::abs(normal[static_cast<Eigen::Index>(c)]), 1.0)));
  return color;
}

Pixel ramp_color(double t) {
  const double x = std::clamp(t, 0.0, 1.0);
  return from_oklch(0.30 + 0.60 * x, 0.12, 285 - 185 * x);
}

Pixel height_color(double t) {
  static constexpr std::array<Pixel, 5> stops = {
      Pixel{72, 88, 128}, {92, 129, 150}, {132, 164, 146}, {190, 192, 142}, {232, 214, 170}};
  const double x = std::clamp(t, 0.0, 1.0) * (stops.size() - 1);
  const std::size_t low = std::min<std::size_t>(static_cast<std::size_t>(x), stops.size() - 2);
  return mix(stops[low], stops[low + 1], x - static_cast<double>(low));
}

Pixel lighten(const Pixel& color, double amount) { return mix(color, {255, 255, 255}, amount); }
Pixel darken(const Pixel& color, double amount) { return mix(color, {0, 0, 0}, amount); }

double luma(const Pixel& color) {
  return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
}

}  // namespace planescope::draw
