// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/image.hpp"

#include <cstring>
#include <span>
#include <string>

#include "io/input_file.hpp"
#include "io/jpeg_image.hpp"
#include "io/png_image.hpp"
#include "io/whole_file.hpp"
#include "planescope/error.hpp"

namespace planescope {
namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 28;  // of a file; 8192^2 pixels, raw

std::vector<std::byte> read_file(const std::filesystem::path& path, const char* expected) {
  const io::InputFile file(path, expected);
  if (file.size() > kMostBytes)
    file.fail("has more than 256 MB; expected " + std::string(expected));
  std::vector<std::byte> bytes(static_cast<std::size_t>(file.size()));
  file.read_at(0, bytes);
  return bytes;
}

void check_size(std::uint32_t width, std::uint32_t height, std::size_t pixels) {
  if (pixels != 0 && pixels == std::size_t{width} * height) return;
  throw Error(Error::Kind::Usage, "an image of " + std::to_string(width) + " x " +
                                      std::to_string(height) + " has " + std::to_string(pixels) +
                                      " pixels; expected one value a pixel");
}

template <class Pixel>
void write(const std::vector<Pixel>& pixels, std::uint32_t width, std::uint32_t height,
           io::PngKind kind, const std::filesystem::path& file) {
  check_size(width, height, pixels.size());
  const auto bytes = std::as_bytes(std::span(pixels));
  write_whole(file, io::encode_png({width, height, {bytes.begin(), bytes.end()}}, kind));
}

}  // namespace

DepthImage read_depth_image(const std::filesystem::path& file) {
  constexpr const char* kExpected = "a depth image: a PNG of 16-bit grey";
  const std::vector<std::byte> bytes = read_file(file, kExpected);
  if (!io::is_png(bytes)) {
    throw Error(Error::Kind::Input, file.string() + ": is no PNG; expected " + kExpected);
  }
  const io::PngPixels pixels = io::decode_png(file.string(), bytes, io::PngKind::Depth);
  DepthImage image{pixels.width, pixels.height, {}};
  image.values.resize(pixels.samples.size() / 2);
  std::memcpy(image.values.data(), pixels.samples.data(), pixels.samples.size());
  return image;
}

ColorImage read_color_image(const std::filesystem::path& file) {
  constexpr const char* kExpected = "a colour image: PNG or JPEG";
  const std::vector<std::byte> bytes = read_file(file, kExpected);
  if (io::is_jpeg(bytes)) return io::decode_jpeg(file.string(), bytes);
  if (!io::is_png(bytes)) {
    throw Error(Error::Kind::Input,
                file.string() + ": is neither PNG nor JPEG; expected " + kExpected);
  }
  const io::PngPixels pixels = io::decode_png(file.string(), bytes, io::PngKind::Color);
  ColorImage image{pixels.width, pixels.height, {}};
  image.pixels.resize(pixels.samples.size() / 3);
  std::memcpy(image.pixels.data(), pixels.samples.data(), pixels.samples.size());
  return image;
}

void write_depth_image(const DepthImage& image, const std::filesystem::path& png) {
  write(image.values, image.width, image.height, io::PngKind::Depth, png);
}

void write_color_image(const ColorImage& image, const std::filesystem::path& png) {
  write(image.pixels, image.width, image.height, io::PngKind::Color, png);
}

}  // namespace planescope
