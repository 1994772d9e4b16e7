// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/compare_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "flip.hpp"
#include "image.hpp"
#include "palette.hpp"
#include "planescope/error.hpp"

namespace planescope {
namespace {

using draw::Image;
using draw::Pixel;

/// An opaque picture of a transparent one.
Image over(const Image& image, std::uint8_t ground) {
  Image flat{image.width, image.height, image.rgb};
  for (std::size_t i = 0; i < image.alpha.size(); ++i)
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c)
      flat.rgb[c] = static_cast<std::uint8_t>(
          (image.rgb[c] * image.alpha[i] + ground * (255 - image.alpha[i]) + 127) / 255);
  return flat;
}

std::vector<float> errors_of(const Image& a, const Image& b) {
  if (a.alpha.empty() && b.alpha.empty()) return draw::flip_errors(a, b);
  std::vector<float> errors = draw::flip_errors(over(a, 255), over(b, 255));
  const std::vector<float> others = draw::flip_errors(over(a, 0), over(b, 0));
  for (std::size_t i = 0; i < errors.size(); ++i) errors[i] = std::max(errors[i], others[i]);
  return errors;
}

std::size_t count_changed(const Image& a, const Image& b) {
  const auto alpha = [](const Image& image, std::size_t i) {
    return image.alpha.empty() ? 255 : image.alpha[i];
  };
  std::size_t changed = 0;
  for (std::size_t i = 0; i < a.rgb.size() / 3; ++i) {
    const auto at = static_cast<std::ptrdiff_t>(3 * i);
    const bool same = std::equal(a.rgb.begin() + at, a.rgb.begin() + at + 3, b.rgb.begin() + at) &&
                      alpha(a, i) == alpha(b, i);
    changed += same ? 0 : 1;
  }
  return changed;
}

/// The square with the largest sum, by sums of columns that slide down and sums of those that slide
/// to the right.
void find_worst(const std::vector<float>& errors, int width, int height, PictureComparison& found) {
  const int w = std::min(kCompareSquare, width), h = std::min(kCompareSquare, height);
  std::vector<double> columns(static_cast<std::size_t>(width), 0);
  const auto add_row = [&](int y, double sign) {
    for (std::size_t x = 0; x < columns.size(); ++x)
      columns[x] +=
          sign * static_cast<double>(errors[static_cast<std::size_t>(y) * columns.size() + x]);
  };
  double most = -1;
  for (int y = 0; y < height; ++y) {
    add_row(y, 1);
    if (y >= h) add_row(y - h, -1);
    if (y < h - 1) continue;
    double sum = 0;
    for (int x = 0; x < width; ++x) {
      sum += columns[static_cast<std::size_t>(x)];
      if (x >= w) sum -= columns[static_cast<std::size_t>(x - w)];
      if (x < w - 1 || sum <= most) continue;
      most = sum;
      found.worst_at = {x - w / 2, y - h / 2};
    }
  }
  // Sums that slide leave a rounding error behind.
  found.worst = std::clamp(most / (w * h), 0.0, 1.0);
}

/// From yellow over red to black, the more the error.
Pixel heat(double error) {
  return draw::from_oklch(0.92 - 0.75 * error, 0.19 - 0.10 * error, 100 - 75 * error);
}

Image draw_difference(const Image& a, const std::vector<float>& errors) {
  Image image{a.width, a.height, {}};
  image.rgb.reserve(3 * errors.size());
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const Pixel own = {a.rgb[3 * i], a.rgb[3 * i + 1], a.rgb[3 * i + 2]};
    const auto grey = static_cast<std::uint8_t>(205 + draw::luma(own) * 50 / 255);
    const double error = static_cast<double>(errors[i]);
    const double share = std::min(1.0, error / 0.05);  // what can just be seen is tinted
    const Pixel hot = heat(error);
    for (const std::uint8_t channel : hot)
      image.rgb.push_back(static_cast<std::uint8_t>(std::lround(grey + share * (channel - grey))));
  }
  return image;
}

}  // namespace

PictureComparison compare_pictures(const std::filesystem::path& a, const std::filesystem::path& b,
                                   const std::filesystem::path& difference) {
  const Image first = draw::read_png(a), second = draw::read_png(b);
  const auto size = [](const Image& image) {
    return std::to_string(image.width) + "x" + std::to_string(image.height);
  };
  if (first.width != second.width || first.height != second.height)
    throw Error(Error::Kind::Mismatch, a.string() + " is " + size(first) + " pixels, " +
                                           b.string() + " is " + size(second) +
                                           "; draw them with the same --size");
  PictureComparison found;
  found.changed = count_changed(first, second);
  found.pixels = first.rgb.size() / 3;
  std::vector<float> errors(found.pixels, 0.0F);
  if (!found.identical()) {
    errors = errors_of(first, second);
    for (const float error : errors) found.mean += static_cast<double>(error);
    found.mean /= static_cast<double>(found.pixels);
    find_worst(errors, first.width, first.height, found);
  }
  if (!difference.empty()) draw::write_png(draw_difference(over(first, 255), errors), difference);
  return found;
}

}  // namespace planescope
