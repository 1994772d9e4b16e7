// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/jpeg_image.hpp"

#include <array>
#include <csetjmp>
#include <cstdio>

#include <jpeglib.h>

#include "planescope/error.hpp"

namespace planescope::io {
namespace {

static_assert(sizeof(Rgb) == 3, "rows of libjpeg are written into Rgb as they are");

// The decoder with what its callbacks need; objects live here, in the caller's frame, so that a
// long jump leaves none undestroyed.
struct Decoder {
  Decoder() = default;
  ~Decoder() { jpeg_destroy_decompress(&jpeg); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  jpeg_decompress_struct jpeg{};
  jpeg_error_mgr errors{};
  std::jmp_buf jump{};
  std::array<char, JMSG_LENGTH_MAX> message{};
  ColorImage image;
};

[[noreturn]] void on_error(j_common_ptr jpeg) {
  auto& decoder = *static_cast<Decoder*>(jpeg->client_data);
  jpeg->err->format_message(jpeg, decoder.message.data());
  std::longjmp(decoder.jump, 1);
}

// libjpeg fills what is missing of a truncated file with grey and warns: we do not want such
// pixels.
void on_message(j_common_ptr jpeg, int level) {
  if (level < 0) on_error(jpeg);
}

bool read(Decoder& decoder, std::span<const std::byte> bytes) {
  jpeg_decompress_struct& jpeg = decoder.jpeg;
  jpeg.err = jpeg_std_error(&decoder.errors);
  decoder.errors.error_exit = on_error;
  decoder.errors.emit_message = on_message;
  jpeg.client_data = &decoder;
  if (setjmp(decoder.jump) != 0) return false;
  jpeg_create_decompress(&jpeg);
  jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&jpeg, TRUE);
  if (jpeg.image_width > kMostImageSide || jpeg.image_height > kMostImageSide) {
    std::snprintf(decoder.message.data(), decoder.message.size(), "%u x %u pixels, more than %u",
                  jpeg.image_width, jpeg.image_height, kMostImageSide);
    return false;
  }
  jpeg.out_color_space = JCS_RGB;
  jpeg_start_decompress(&jpeg);
  decoder.image.width = jpeg.output_width;
  decoder.image.height = jpeg.output_height;
  decoder.image.pixels.resize(std::size_t{jpeg.output_width} * jpeg.output_height);
  while (jpeg.output_scanline < jpeg.output_height) {
    auto* row = reinterpret_cast<JSAMPROW>(decoder.image.pixels.data() +
                                           std::size_t{jpeg.output_scanline} * jpeg.output_width);
    jpeg_read_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_decompress(&jpeg);
  return true;
}

}  // namespace

bool is_jpeg(std::span<const std::byte> bytes) {
  return bytes.size() >= 3 && bytes[0] == std::byte{0xFF} && bytes[1] == std::byte{0xD8} &&
         bytes[2] == std::byte{0xFF};
}

ColorImage decode_jpeg(const std::string& name, std::span<const std::byte> bytes) {
  Decoder decoder;
  if (read(decoder, bytes)) return std::move(decoder.image);
  throw Error(Error::Kind::Input,
              name + ": not a readable JPEG: " + decoder.message.data() + "; fetch it again");
}

}  // namespace planescope::io
