// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <Eigen/Core>
#include <Eigen/LU>

namespace planescope::draw {
namespace {

using Plane = std::vector<float>;        // one value a pixel
using Planes = std::array<Plane, 3>;     // Y, Cx, Cz
using Kernel = std::vector<float>;       // odd length, centred
constexpr float kColorExponent = 0.7F;   // q_c
constexpr double kFeatureWidth = 0.082;  // w [deg] of the eye's edge detector

/// Linear sRGB to CIE XYZ (D65), from the primaries' chromaticities.
const Eigen::Matrix3f& to_xyz() {
  static const Eigen::Matrix3f matrix =
      (Eigen::Matrix3d() << 10135552 / 24577794.0, 8788810 / 24577794.0, 4435075 / 24577794.0,
       2613072 / 12288897.0, 8788810 / 12288897.0, 887015 / 12288897.0, 1425312 / 73733382.0,
       8788810 / 73733382.0, 70074185 / 73733382.0)
          .finished()
          .cast<float>();
  return matrix;
}

const Eigen::Vector3f& white() {
  static const Eigen::Vector3f xyz = to_xyz() * Eigen::Vector3f::Ones();
  return xyz;
}

float linear(std::uint8_t value) {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> all{};
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double v = static_cast<double>(i) / 255;
      all[i] = static_cast<float>(v > 0.04045 ? std::pow((v + 0.055) / 1.055, 2.4) : v / 12.92);
    }
    return all;
  }();
  return table[value];
}

/// The opponent space of the contrast sensitivity filters; linear in light.
Planes to_ycxcz(const Image& image) {
  Planes planes;
  const std::size_t count = image.rgb.size() / 3;
  for (Plane& plane : planes) plane.resize(count);
  const Eigen::Matrix3f matrix = white().cwiseInverse().asDiagonal() * to_xyz();
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3f xyz =
        matrix * Eigen::Vector3f(linear(image.rgb[3 * i]), linear(image.rgb[3 * i + 1]),
                                 linear(image.rgb[3 * i + 2]));
    planes[0][i] = 116 * xyz.y() - 16;
    planes[1][i] = 500 * (xyz.x() - xyz.y());
    planes[2][i] = 200 * (xyz.y() - xyz.z());
  }
  return planes;
}

/// CIELAB with Hunt's adjustment: dark colours are less colourful.
Eigen::Vector3f hunt_lab(const Eigen::Vector3f& rgb) {
  const auto f = [](float t) {
    constexpr float kDelta = 6.0F / 29;
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0F / 29;
  };
  const Eigen::Vector3f t = (to_xyz() * rgb).cwiseQuotient(white()).unaryExpr(f);
  const float lightness = 116 * t.y() - 16;
  return {lightness, lightness / 100 * 500 * (t.x() - t.y()),
          lightness / 100 * 200 * (t.y() - t.z())};
}

/// HyAB: city block between lightness and colour, Euclidean within colour.
float hyab(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  const Eigen::Vector3f d = a - b;
  return std::abs(d.x()) + std::hypot(d.y(), d.z());
}

/// Colour distance to [0, 1]: 0.4 of the largest maps to 0.95, for beyond it all is as different.
float redistributed(float distance) {
  static const float most =
      std::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), kColorExponent);
  constexpr float kPc = 0.4F, kPt = 0.95F;
  const float power = std::pow(distance, kColorExponent), knee = kPc * most;
  return power < knee ? kPt / knee * power : kPt + (power - knee) / (most - knee) * (1 - kPt);
}

/// Rows by `across`, then columns by `down`; beyond the picture its border goes on.
Plane convolve(const Plane& in, int width, int height, const Kernel& across, const Kernel& down) {
  const int radius = static_cast<int>(across.size() / 2);
  const auto w = static_cast<std::size_t>(width);
  Plane rows(in.size()), out(in.size(), 0.0F), padded(w + across.size() - 1);
  for (int y = 0; y < height; ++y) {
    const auto row = in.begin() + static_cast<std::ptrdiff_t>(y) * width;
    std::fill_n(padded.begin(), radius, *row);
    std::copy_n(row, width, padded.begin() + radius);
    std::fill_n(padded.begin() + radius + width, radius, *(row + width - 1));
    float* to = rows.data() + static_cast<std::size_t>(y) * w;
    std::fill_n(to, w, 0.0F);
    for (std::size_t k = 0; k < across.size(); ++k)
      for (std::size_t x = 0; x < w; ++x) to[x] += across[k] * padded[x + k];
  }
  const int reach = static_cast<int>(down.size() / 2);
  for (int y = 0; y < height; ++y) {
    float* to = out.data() + static_cast<std::size_t>(y) * w;
    for (int k = -reach; k <= reach; ++k) {
      const float weight = down[static_cast<std::size_t>(std::ptrdiff_t{k} + reach)];
      const float* from =
          rows.data() + static_cast<std::size_t>(std::clamp(y + k, 0, height - 1)) * w;
      for (std::size_t x = 0; x < w; ++x) to[x] += weight * from[x];
    }
  }
  return out;
}

/// A Gaussian exp(-(pi x)^2 / b) over x [deg], not normalised.
Kernel gaussian(double b, int radius) {
  Kernel kernel;
  for (int i = -radius; i <= radius; ++i) {
    const double x = i / kPixelsPerDegree;
    kernel.push_back(
        static_cast<float>(std::exp(-std::numbers::pi * std::numbers::pi * x * x / b)));
  }
  return kernel;
}

/// A contrast sensitivity function in space (the paper's Table 1): a sum of two Gaussians,
/// normalised to 1 over its square.
Plane sensitivity_filtered(const Plane& in, int width, int height,
                           const std::array<std::array<double, 2>, 2>& terms) {
  constexpr double kWidest = 0.04;  // b of all terms
  const int radius =
      static_cast<int>(std::ceil(3 * std::sqrt(kWidest / 2) / std::numbers::pi * kPixelsPerDegree));
  Plane out(in.size(), 0.0F);
  std::array<double, 2> weights{};
  double total = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto [a, b] = terms[i];
    double sum = 0;
    for (const float value : gaussian(b, radius)) sum += static_cast<double>(value);
    weights[i] = a * std::sqrt(std::numbers::pi / b);
    total += weights[i] * sum * sum;
  }
  for (std::size_t i = 0; i < 2; ++i) {
    if (weights[i] == 0) continue;
    const Kernel kernel = gaussian(terms[i][1], radius);
    const Plane term = convolve(in, width, height, kernel, kernel);
    const auto weight = static_cast<float>(weights[i] / total);
    for (std::size_t k = 0; k < out.size(); ++k) out[k] += weight * term[k];
  }
  return out;
}

/// What is left of a picture on the way to the brain: filtered, within what a screen can show, in
/// Hunt-adjusted CIELAB.
std::vector<Eigen::Vector3f> perceived(const Planes& in, int width, int height) {
  const Planes seen = {sensitivity_filtered(in[0], width, height, {{{1, 0.0047}, {0, 1e-5}}}),
                       sensitivity_filtered(in[1], width, height, {{{1, 0.0053}, {0, 1e-5}}}),
                       sensitivity_filtered(in[2], width, height, {{{34.1, 0.04}, {13.5, 0.025}}})};
  static const Eigen::Matrix3f to_rgb = to_xyz().inverse();
  std::vector<Eigen::Vector3f> lab(in[0].size());
  for (std::size_t i = 0; i < lab.size(); ++i) {
    const float y = (seen[0][i] + 16) / 116;
    const Eigen::Vector3f xyz(y + seen[1][i] / 500, y, y - seen[2][i] / 200);
    lab[i] = hunt_lab((to_rgb * xyz.cwiseProduct(white())).cwiseMax(0.0F).cwiseMin(1.0F));
  }
  return lab;
}

/// Positive weights sum to 1 and negative ones to -1, over a square whose other side sums to 1.
Kernel balanced(Kernel kernel) {
  float positive = 0, negative = 0;
  for (const float value : kernel) (value > 0 ? positive : negative) += std::abs(value);
  for (float& value : kernel) value /= value > 0 ? positive : negative;
  return kernel;
}

/// Strength of edges (first derivative) or of points (second derivative) in lightness.
Plane features(const Plane& lightness, int width, int height, bool points) {
  const double sigma = 0.5 * kFeatureWidth * kPixelsPerDegree;
  const int radius = static_cast<int>(std::ceil(3 * sigma));
  Kernel smooth, derivative;
  for (int i = -radius; i <= radius; ++i) {
    const double g = std::exp(-i * i / (2 * sigma * sigma));
    smooth.push_back(static_cast<float>(g));
    derivative.push_back(static_cast<float>((points ? i * i / (sigma * sigma) - 1 : -i) * g));
  }
  derivative = balanced(std::move(derivative));
  float sum = 0;
  for (const float value : smooth) sum += value;
  for (float& value : smooth) value /= sum;
  Plane strength = convolve(lightness, width, height, derivative, smooth);
  const Plane other = convolve(lightness, width, height, smooth, derivative);
  for (std::size_t i = 0; i < strength.size(); ++i) strength[i] = std::hypot(strength[i], other[i]);
  return strength;
}

/// The larger of the differences in edges and in points, 0 to 1.
Plane feature_errors(const Planes& a, const Planes& b, int width, int height) {
  const auto normalised = [](Plane lightness) {
    for (float& value : lightness) value = (value + 16) / 116;
    return lightness;
  };
  const Plane first = normalised(a[0]), second = normalised(b[0]);
  Plane errors(first.size(), 0.0F);
  for (const bool points : {false, true}) {
    const Plane one = features(first, width, height, points);
    const Plane two = features(second, width, height, points);
    for (std::size_t i = 0; i < errors.size(); ++i)
      errors[i] = std::max(errors[i], std::abs(one[i] - two[i]));
  }
  for (float& error : errors) error = std::sqrt(error / std::numbers::sqrt2_v<float>);
  return errors;
}

}  // namespace

std::vector<float> flip_errors(const Image& a, const Image& b) {
  const Planes first = to_ycxcz(a), second = to_ycxcz(b);
  Plane errors = feature_errors(first, second, a.width, a.height);
  const auto seen = perceived(first, a.width, a.height);
  const auto other = perceived(second, a.width, a.height);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const float color = redistributed(hyab(seen[i], other[i]));
    errors[i] = std::pow(color, 1 - errors[i]);  // differing features make it worse
  }
  return errors;
}

}  // namespace planescope::draw
