// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/image.hpp"

#include <gtest/gtest.h>
#include <png.h>
#include <zlib.h>

#include <cstdio>
#include <cstdlib>
#include <functional>

#include <jpeglib.h>

#include "fixtures.hpp"
#include "planescope/error.hpp"

namespace planescope {
namespace {

using testing::read_bytes;
using testing::TemporaryFolder;
using testing::write_bytes;

DepthImage make_depth() {
  DepthImage image{5, 3, {}};
  for (std::uint16_t i = 0; i < 15; ++i)
    image.values.push_back(static_cast<std::uint16_t>(i * 4369));
  return image;  // 0 and 61166 among them, all bits of both bytes used
}

ColorImage make_color(std::uint32_t width, std::uint32_t height) {
  ColorImage image{width, height, {}};
  for (std::uint32_t i = 0; i < width * height; ++i) {
    image.pixels.push_back(
        {static_cast<std::uint8_t>(7 * i), static_cast<std::uint8_t>(255 - i), 9});
  }
  return image;
}

/// A JPEG of one colour, by libjpeg's own compressor.
std::string make_jpeg(std::uint32_t width, std::uint32_t height, Rgb color) {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &bytes, &size);
  jpeg.image_width = width;
  jpeg.image_height = height;
  jpeg.input_components = 3;
  jpeg.in_color_space = JCS_RGB;
  jpeg_set_defaults(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  std::vector<Rgb> row(width, color);
  auto* samples = reinterpret_cast<JSAMPROW>(row.data());
  while (jpeg.next_scanline < height) jpeg_write_scanlines(&jpeg, &samples, 1);
  jpeg_finish_compress(&jpeg);
  std::string result(reinterpret_cast<char*>(bytes), size);
  jpeg_destroy_compress(&jpeg);
  std::free(bytes);
  return result;
}

Error::Kind kind_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.kind();
  }
  ADD_FAILURE() << "nothing was thrown";
  return Error::Kind::Internal;
}

TEST(Image, DepthComesBackBitByBit) {
  const TemporaryFolder folder;
  const DepthImage image = make_depth();
  write_depth_image(image, folder / "d.png");
  const DepthImage back = read_depth_image(folder / "d.png");
  EXPECT_EQ(back.width, 5u);
  EXPECT_EQ(back.height, 3u);
  EXPECT_EQ(back.values, image.values);
}

TEST(Image, DepthIsStoredHighestByteFirstAsPngHasIt) {
  const TemporaryFolder folder;
  write_depth_image(make_depth(), folder / "d.png");
  const std::string bytes = read_bytes(folder / "d.png");
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()), 0);
  EXPECT_EQ(png.format & PNG_FORMAT_FLAG_LINEAR, unsigned{PNG_FORMAT_FLAG_LINEAR});  // 16 bits
  png_image_free(&png);
  EXPECT_EQ(bytes[24], 16);  // IHDR: bit depth
  EXPECT_EQ(bytes[25], 0);   // grey
}

TEST(Image, ColorComesBackAndIsWhatLibpngReads) {
  const TemporaryFolder folder;
  const ColorImage image = make_color(7, 4);
  write_color_image(image, folder / "c.png");
  EXPECT_EQ(read_color_image(folder / "c.png").pixels, image.pixels);
  const std::string bytes = read_bytes(folder / "c.png");
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()), 0);
  png.format = PNG_FORMAT_RGB;
  std::vector<Rgb> pixels(28);
  ASSERT_NE(png_image_finish_read(&png, nullptr, pixels.data(), 0, nullptr), 0);
  EXPECT_EQ(pixels, image.pixels);
}

TEST(Image, JpegIsReadByContentWhateverItsName) {
  const TemporaryFolder folder;
  write_bytes(folder / "c.png", make_jpeg(20, 10, {200, 100, 50}));
  const ColorImage image = read_color_image(folder / "c.png");
  ASSERT_EQ(image.width, 20u);
  ASSERT_EQ(image.height, 10u);
  for (const Rgb& p : image.pixels) {
    EXPECT_NEAR(p.r, 200, 2);
    EXPECT_NEAR(p.g, 100, 2);
    EXPECT_NEAR(p.b, 50, 2);
  }
}

// Every prefix of every kind of file is refused, and none is read as if it were whole.
TEST(Image, TruncatedFilesAreRefused) {
  const TemporaryFolder folder;
  write_depth_image(make_depth(), folder / "d.png");
  write_color_image(make_color(7, 4), folder / "c.png");
  const std::string depth = read_bytes(folder / "d.png"), color = read_bytes(folder / "c.png");
  const std::string jpeg = make_jpeg(64, 64, {9, 90, 200});
  const auto input = Error::Kind::Input;
  for (std::size_t n = 0; n < depth.size(); ++n) {
    write_bytes(folder / "t", depth.substr(0, n));
    EXPECT_EQ(kind_of([&] { read_depth_image(folder / "t"); }), input) << n;
  }
  for (std::size_t n = 0; n < color.size(); n += 3) {
    write_bytes(folder / "t", color.substr(0, n));
    EXPECT_EQ(kind_of([&] { read_color_image(folder / "t"); }), input) << n;
  }
  for (std::size_t n = 0; n + 2 < jpeg.size(); n += 7) {
    write_bytes(folder / "t", jpeg.substr(0, n));
    EXPECT_EQ(kind_of([&] { read_color_image(folder / "t"); }), input) << n;
  }
}

// Any byte may be wrong: an error or an image of a legal size, never a crash (run under ASan too).
TEST(Image, DamagedFilesDoNoHarm) {
  const TemporaryFolder folder;
  write_depth_image(make_depth(), folder / "d.png");
  const std::string files[] = {read_bytes(folder / "d.png"), make_jpeg(33, 17, {1, 2, 3})};
  for (const std::string& file : files) {
    for (std::size_t at = 0; at < file.size(); ++at) {
      std::string bytes = file;
      bytes[at] = static_cast<char>(bytes[at] ^ 0x5A);
      write_bytes(folder / "t", bytes);
      try {
        const ColorImage image = read_color_image(folder / "t");
        EXPECT_LE(image.width, kMostImageSide);
        EXPECT_EQ(image.pixels.size(), std::size_t{image.width} * image.height);
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), Error::Kind::Input) << error.what();
      }
    }
  }
}

TEST(Image, WrongKindsAreRefused) {
  const TemporaryFolder folder;
  write_color_image(make_color(7, 4), folder / "c.png");
  write_bytes(folder / "text", "depth");
  EXPECT_EQ(kind_of([&] { read_depth_image(folder / "c.png"); }), Error::Kind::Input);
  EXPECT_EQ(kind_of([&] { read_depth_image(folder / "text"); }), Error::Kind::Input);
  EXPECT_EQ(kind_of([&] { read_color_image(folder / "text"); }), Error::Kind::Input);
  EXPECT_EQ(kind_of([&] { read_depth_image(folder / "none.png"); }), Error::Kind::Input);
  EXPECT_EQ(kind_of([&] { write_depth_image({2, 2, {1}}, folder / "x.png"); }), Error::Kind::Usage);
}

// A header that claims 60000 x 60000 pixels takes no memory.
TEST(Image, HugeClaimsAreRefused) {
  const TemporaryFolder folder;
  write_depth_image(make_depth(), folder / "d.png");
  std::string bytes = read_bytes(folder / "d.png");
  const std::string side = {0, 0, '\xEA', '\x60'};
  bytes.replace(16, 4, side);
  bytes.replace(20, 4, side);
  const auto crc = crc32(0, reinterpret_cast<const Bytef*>(bytes.data()) + 12, 17);
  for (int k = 0; k < 4; ++k)
    bytes[29 + static_cast<std::size_t>(k)] = static_cast<char>(crc >> (24 - 8 * k));
  write_bytes(folder / "t", bytes);
  EXPECT_EQ(kind_of([&] { read_depth_image(folder / "t"); }), Error::Kind::Input);
}

}  // namespace
}  // namespace planescope
