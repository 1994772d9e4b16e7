// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "image.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include <vtkCommand.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include "io/png_image.hpp"
#include "io/whole_file.hpp"
#include "planescope/error.hpp"
#include "vtk_errors.hpp"

namespace planescope::draw {
namespace {

std::size_t bytes_per_row(const Image& image) { return static_cast<std::size_t>(image.width) * 3; }

/// A row of sums of light, the weighted sum of the rows that [low, high) covers.
void add_rows(const Image& image, double low, double high, std::vector<float>& sums) {
  std::fill(sums.begin(), sums.end(), 0.0F);
  for (auto y = static_cast<int>(low); y < image.height && y < high; ++y) {
    const auto weight = static_cast<float>(std::min(high, y + 1.0) - std::max<double>(low, y));
    const std::uint8_t* in = image.rgb.data() + static_cast<std::size_t>(y) * bytes_per_row(image);
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += weight * static_cast<float>(in[i]);
  }
}

}  // namespace

Image filled(int width, int height, const Pixel& color) {
  Image image{width, height, {}};
  image.rgb.resize(bytes_per_row(image) * static_cast<std::size_t>(height));
  for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = color[i % 3];
  return image;
}

namespace {

/// Adds up the blocks of a row; a constant number of pixels makes straight code.
template <std::size_t kStep>
void add_blocks(const std::uint8_t* in, std::vector<std::uint16_t>& sums) {
  for (std::size_t x = 0; x < sums.size(); x += 3)
    for (std::size_t k = 0; k < kStep; ++k, in += 3)
      for (std::size_t c = 0; c < 3; ++c)
        sums[x + c] = static_cast<std::uint16_t>(sums[x + c] + in[c]);
}

}  // namespace

Image downsample(const PixelRows& rows, int factor) {
  Image small{rows.width / factor, rows.height / factor, {}};
  const std::size_t width = bytes_per_row(small);
  small.rgb.resize(width * static_cast<std::size_t>(small.height));
  using Add = void (*)(const std::uint8_t*, std::vector<std::uint16_t>&);
  constexpr std::array<Add, 4> kAdd = {add_blocks<1>, add_blocks<2>, add_blocks<3>, add_blocks<4>};
  const auto add = kAdd.at(static_cast<std::size_t>(factor - 1));
  const int block = factor * factor;
  std::vector<std::uint16_t> sums(width);
  for (int y = 0; y < small.height; ++y) {
    std::uint8_t* out = small.rgb.data() + width * static_cast<std::size_t>(y);
    const std::uint8_t* in = rows.top + rows.step * y * factor;
    if (factor == 1) {
      std::memcpy(out, in, width);
      continue;
    }
    std::fill(sums.begin(), sums.end(), std::uint16_t{0});
    for (int row = 0; row < factor; ++row) add(in + rows.step * row, sums);
    for (std::size_t i = 0; i < width; ++i)
      out[i] = static_cast<std::uint8_t>((sums[i] + block / 2) / block);
  }
  return small;
}

Image downsample(const Image& image, int factor) {
  if (factor == 1) return image;
  const auto step = static_cast<std::ptrdiff_t>(bytes_per_row(image));
  return downsample(PixelRows{image.rgb.data(), step, image.width, image.height}, factor);
}

Image shrunk(const Image& image, int width, int height) {
  if (width == image.width && height == image.height) return image;
  Image small{width, height, {}};
  small.rgb.reserve(bytes_per_row(small) * static_cast<std::size_t>(height));
  const double across = static_cast<double>(image.width) / width;
  const double down = static_cast<double>(image.height) / height;
  const auto area = static_cast<float>(across * down);
  std::vector<float> sums(bytes_per_row(image));
  for (int y = 0; y < height; ++y) {
    add_rows(image, y * down, (y + 1) * down, sums);
    for (int x = 0; x < width; ++x) {
      const double low = x * across, high = (x + 1) * across;
      std::array<float, 3> light{};
      for (auto k = static_cast<int>(low); k < image.width && k < high; ++k) {
        const auto weight = static_cast<float>(std::min(high, k + 1.0) - std::max<double>(low, k));
        for (std::size_t c = 0; c < 3; ++c)
          light[c] += weight * sums[3 * static_cast<std::size_t>(k) + c];
      }
      for (const float value : light)
        small.rgb.push_back(static_cast<std::uint8_t>(std::min(value / area + 0.5F, 255.0F)));
    }
  }
  return small;
}

Image matte(const Image& on_white, const Image& on_black) {
  Image image = on_black;
  image.alpha.resize(on_black.rgb.size() / 3);
  for (std::size_t i = 0; i < image.alpha.size(); ++i) {
    int through = 255;  // of the white; the least of the channels: antialiasing rounds
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c)
      through = std::min(through, on_white.rgb[c] - on_black.rgb[c]);
    const int alpha = 255 - std::max(through, 0);
    image.alpha[i] = static_cast<std::uint8_t>(alpha);
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c)
      image.rgb[c] = static_cast<std::uint8_t>(
          alpha == 0 ? 0 : std::min(255, (on_black.rgb[c] * 255 + alpha / 2) / alpha));
  }
  return image;
}

namespace {

/// Shifted by one pixel, a uniform picture is itself.
bool all_alike(const std::vector<std::uint8_t>& bytes, std::ptrdiff_t begin, std::ptrdiff_t end,
               std::ptrdiff_t pixel) {
  const auto first = bytes.begin() + begin, last = bytes.begin() + end;
  return end - begin <= pixel || std::equal(first + pixel, last, first, last - pixel);
}

}  // namespace

bool is_uniform(const Image& image, int first, int last) {
  const auto row = static_cast<std::ptrdiff_t>(image.width);
  return all_alike(image.rgb, 3 * row * first, 3 * row * last, 3) &&
         (image.alpha.empty() || all_alike(image.alpha, first * row, last * row, 1));
}

void paste(Image& canvas, const Image& piece, int x, int y) {
  for (int row = 0; row < piece.height; ++row) {
    const auto from = static_cast<std::size_t>(row) * bytes_per_row(piece);
    const auto to =
        static_cast<std::size_t>(y + row) * bytes_per_row(canvas) + static_cast<std::size_t>(x) * 3;
    std::memcpy(canvas.rgb.data() + to, piece.rgb.data() + from, bytes_per_row(piece));
  }
}

std::string encode_png(const Image& image, const PngNotes& notes) {
  io::PngPixels pixels{
      static_cast<std::uint32_t>(image.width), static_cast<std::uint32_t>(image.height), {}};
  const std::size_t channels = image.alpha.empty() ? 3 : 4;
  pixels.samples.resize(image.rgb.size() / 3 * channels);
  auto* out = reinterpret_cast<std::uint8_t*>(pixels.samples.data());
  if (image.alpha.empty()) {
    std::ranges::copy(image.rgb, out);
  } else {
    for (std::size_t i = 0; i < image.alpha.size(); ++i) {
      out = std::copy_n(&image.rgb[3 * i], 3, out);
      *out++ = image.alpha[i];
    }
  }
  const auto kind = image.alpha.empty() ? io::PngKind::Drawing : io::PngKind::DrawingWithAlpha;
  return with_notes(io::encode_png(std::move(pixels), kind), notes);
}

void write_png(const Image& image, const std::filesystem::path& file, const PngNotes& notes) {
  write_whole(file, encode_png(image, notes));
}

Image read_png(const std::filesystem::path& file) {
  vtkNew<vtkPNGReader> reader;
  VtkErrors errors(reader);
  std::error_code ignored;
  const bool readable =
      std::filesystem::is_regular_file(file, ignored) && reader->CanReadFile(file.c_str()) != 0;
  if (readable) {
    reader->SetFileName(file.c_str());
    reader->Update();
  }
  vtkImageData* data = reader->GetOutput();
  const int channels = data->GetNumberOfScalarComponents();
  if (!readable || errors.any() || data->GetScalarType() != VTK_UNSIGNED_CHAR || channels < 3)
    throw Error(Error::Kind::Input, file.string() + ": not an 8-bit RGB PNG; name such a file");
  Image image{data->GetDimensions()[0], data->GetDimensions()[1], {}};
  image.rgb.reserve(bytes_per_row(image) * static_cast<std::size_t>(image.height));
  for (int y = image.height - 1; y >= 0; --y) {
    const auto* in = static_cast<const std::uint8_t*>(data->GetScalarPointer(0, y, 0));
    for (int x = 0; x < image.width; ++x, in += channels) {
      image.rgb.insert(image.rgb.end(), in, in + 3);
      if (channels == 4) image.alpha.push_back(in[3]);
    }
  }
  return image;
}

}  // namespace planescope::draw
