// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.hpp"
#include "planescope/image.hpp"

/// \file Depth and colour images: the first byte says as which the others are read.
namespace planescope::fuzzing {

void fuzz(std::string_view bytes) {
  static const ScratchFolder folder;
  if (bytes.empty()) return;
  const std::filesystem::path file = folder.write("image", bytes.substr(1));
  refused_or_taken([&] {
    if (bytes.front() == 'd') {
      const DepthImage image = read_depth_image(file);
      if (image.values.size() != std::size_t{image.width} * image.height) std::abort();
    } else {
      const ColorImage image = read_color_image(file);
      if (image.pixels.size() != std::size_t{image.width} * image.height) std::abort();
    }
  });
}

}  // namespace planescope::fuzzing
