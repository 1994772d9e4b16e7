// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sequence/find_camera.hpp"

#include "sequence/text_lines.hpp"

namespace planescope::sequence {
namespace {

/// `m_depthWidth = 640` and the like, as BundleFusion writes them.
CameraFile read_bundle_fusion(const std::filesystem::path& file) {
  TextLines lines(file, "BundleFusion's description of a sequence");
  CameraFile camera;
  bool has_lens = false;
  while (lines.next()) {
    const std::string key(lines.words().front());
    const auto side = [&] {
      const double value = lines.number(2);
      if (!(value >= 1 && value <= kMostImageSide)) lines.fail("is not 1 to 8192 pixels");
      return static_cast<std::uint32_t>(value);
    };
    if (key == "m_depthWidth") camera.lens.width = side();
    if (key == "m_depthHeight") camera.lens.height = side();
    if (key == "m_depthShift") camera.depth_scale = lines.number(2);
    if (key != "m_calibrationDepthIntrinsic") continue;
    camera.lens.fx = lines.number(2);
    camera.lens.cx = lines.number(4);
    camera.lens.fy = lines.number(7);
    camera.lens.cy = lines.number(8);
    has_lens = camera.lens.fx > 0 && camera.lens.fy > 0 && camera.lens.fx < 1e6 &&
               camera.lens.fy < 1e6 && camera.lens.cx < 1e6 && camera.lens.cy < 1e6;
    if (!has_lens) lines.fail("is no camera: the focal lengths are to be positive, below 1e6");
  }
  const bool has_scale =
      !camera.depth_scale || (*camera.depth_scale > 0 && *camera.depth_scale <= 1e6);
  if (!has_lens || !has_scale) {
    lines.file().fail("expected m_calibrationDepthIntrinsic, and m_depthShift within 0 to 1e6");
  }
  return camera;
}

}  // namespace

FoundCamera find_camera(const std::filesystem::path& folder, SequenceLayout layout) {
  for (const char* name : {"camera.txt", "camera_intrinsic.json", "intrinsic.json"}) {
    if (std::filesystem::exists(folder / name)) return {read_camera_file(folder / name), name};
  }
  for (const char* name : {"info.txt", "_info.txt"}) {
    if (layout == SequenceLayout::Frames && std::filesystem::exists(folder / name)) {
      return {read_bundle_fusion(folder / name), name};
    }
  }
  if (layout == SequenceLayout::Frames) {
    return {{named_camera("7scenes"), {}}, "no file: taken to be 7scenes"};
  }
  return {{named_camera("primesense"), {}}, "no file: taken to be primesense"};
}

}  // namespace planescope::sequence
