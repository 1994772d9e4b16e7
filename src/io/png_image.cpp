// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/png_image.hpp"

#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <new>
#include <utility>

#include "planescope/error.hpp"
#include "planescope/image.hpp"

namespace planescope::io {
namespace {

// What the callbacks of libpng share. The functions that call setjmp hold no object that a long
// jump would leave undestroyed: all of them live in here, in the caller's frame.
struct Exchange {
  explicit Exchange(bool writes) : writing(writes) {}
  ~Exchange() {
    if (writing) {
      png_destroy_write_struct(&png, &info);
    } else {
      png_destroy_read_struct(&png, &info, nullptr);
    }
  }
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;

  bool writing;
  std::span<const std::byte> input;
  std::string output;
  std::array<char, 160> error{};
  bool other_kind = false;  ///< a sound PNG, of another kind than was asked for
  PngPixels pixels;
  std::vector<png_bytep> rows;
  png_structp png = nullptr;
  png_infop info = nullptr;
};

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
  auto& exchange = *static_cast<Exchange*>(png_get_error_ptr(png));
  std::strncpy(exchange.error.data(), message, exchange.error.size() - 1);
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

void on_read(png_structp png, png_bytep to, std::size_t count) {
  auto& exchange = *static_cast<Exchange*>(png_get_io_ptr(png));
  if (count > exchange.input.size()) png_error(png, "the file ends too early");
  std::memcpy(to, exchange.input.data(), count);
  exchange.input = exchange.input.subspan(count);
}

void on_write(png_structp png, png_bytep from, std::size_t count) {
  bool written = false;
  try {
    auto& exchange = *static_cast<Exchange*>(png_get_io_ptr(png));
    exchange.output.append(reinterpret_cast<char*>(from), count);
    written = true;
  } catch (const std::bad_alloc&) {  // must not pass through libpng
  }
  if (!written) png_error(png, "out of memory");
}

void on_flush(png_structp) {}

// Makes room for the image, whose size libpng has checked against kMostImageSide.
void make_rows(Exchange& exchange, PngKind kind) {
  PngPixels& pixels = exchange.pixels;
  const std::size_t bytes = kind == PngKind::Depth ? 2 : kind == PngKind::DrawingWithAlpha ? 4 : 3;
  const std::size_t stride = std::size_t{pixels.width} * bytes;
  pixels.samples.resize(stride * pixels.height);
  exchange.rows.resize(pixels.height);
  for (std::size_t y = 0; y < pixels.height; ++y) {
    exchange.rows[y] = reinterpret_cast<png_bytep>(pixels.samples.data() + y * stride);
  }
}

// Asks libpng for RGB of 8 bits, whatever the file holds.
void convert_to_rgb(png_structp png, png_infop info) {
  png_set_expand(png);
  png_set_scale_16(png);
  png_set_strip_alpha(png);
  png_set_gray_to_rgb(png);
  png_read_update_info(png, info);
}

bool read(Exchange& exchange, PngKind kind) {
  exchange.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &exchange, on_error, on_warning);
  if (exchange.png == nullptr || setjmp(png_jmpbuf(exchange.png)) != 0) return false;
  png_structp png = exchange.png;
  exchange.info = png_create_info_struct(png);
  if (exchange.info == nullptr) png_error(png, "out of memory");
  png_set_read_fn(png, &exchange, on_read);
  png_set_user_limits(png, kMostImageSide, kMostImageSide);
  png_read_info(png, exchange.info);
  exchange.pixels.width = png_get_image_width(png, exchange.info);
  exchange.pixels.height = png_get_image_height(png, exchange.info);
  if (kind == PngKind::Depth) {
    if (png_get_color_type(png, exchange.info) != PNG_COLOR_TYPE_GRAY ||
        png_get_bit_depth(png, exchange.info) != 16) {
      exchange.other_kind = true;
      png_error(png, "is no depth image; expected a PNG of 16-bit grey");
    }
    if (std::endian::native == std::endian::little) png_set_swap(png);
    png_read_update_info(png, exchange.info);
  } else {
    convert_to_rgb(png, exchange.info);
  }
  make_rows(exchange, kind);
  png_read_image(png, exchange.rows.data());
  png_read_end(png, nullptr);
  return true;
}

bool write(Exchange& exchange, PngKind kind) {
  exchange.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &exchange, on_error, on_warning);
  if (exchange.png == nullptr || setjmp(png_jmpbuf(exchange.png)) != 0) return false;
  png_structp png = exchange.png;
  exchange.info = png_create_info_struct(png);
  if (exchange.info == nullptr) png_error(png, "out of memory");
  png_set_write_fn(png, &exchange, on_write, on_flush);
  const bool depth = kind == PngKind::Depth, alpha = kind == PngKind::DrawingWithAlpha;
  png_set_IHDR(png, exchange.info, exchange.pixels.width, exchange.pixels.height, depth ? 16 : 8,
               depth   ? PNG_COLOR_TYPE_GRAY
               : alpha ? PNG_COLOR_TYPE_RGBA
                       : PNG_COLOR_TYPE_RGB,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (kind == PngKind::Drawing || alpha) {
    // Half the time of trying all filters, and files of the same size.
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
    png_set_compression_level(png, 2);
  } else {
    png_set_compression_level(png, 3);  // a third of the time of the usual 6, files a tenth larger
  }
  png_write_info(png, exchange.info);
  if (depth && std::endian::native == std::endian::little) png_set_swap(png);
  png_write_image(png, exchange.rows.data());
  png_write_end(png, exchange.info);
  return true;
}

}  // namespace

bool is_png(std::span<const std::byte> bytes) {
  return bytes.size() >= 8 &&
         png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, 8) == 0;
}

PngPixels decode_png(const std::string& name, std::span<const std::byte> bytes, PngKind kind) {
  Exchange exchange(false);
  exchange.input = bytes;
  if (read(exchange, kind)) return std::move(exchange.pixels);
  if (exchange.other_kind) throw Error(Error::Kind::Input, name + ": " + exchange.error.data());
  const std::size_t at = bytes.size() - exchange.input.size();
  throw Error(Error::Kind::Input, name + ": byte " + std::to_string(at) +
                                      ": not a readable PNG: " + exchange.error.data());
}

std::string encode_png(PngPixels pixels, PngKind kind) {
  Exchange exchange(true);
  exchange.pixels = std::move(pixels);
  make_rows(exchange, kind);
  if (write(exchange, kind)) return std::move(exchange.output);
  throw Error(Error::Kind::Internal, std::string("libpng refuses: ") + exchange.error.data());
}

}  // namespace planescope::io
