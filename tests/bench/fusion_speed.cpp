// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
// Times the fusion of an RGB-D sequence beside a bare loop over Open3D's ScalableTSDFVolume, in one
// run: fusion_speed SEQUENCE [VOXEL]. Images are decoded once and kept, so that both fuse only;
// then each is timed with its own decoding too.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <vector>

#include <open3d/camera/PinholeCameraIntrinsic.h>
#include <open3d/geometry/Image.h>
#include <open3d/geometry/PointCloud.h>
#include <open3d/geometry/RGBDImage.h>
#include <open3d/io/ImageIO.h>
#include <open3d/pipelines/integration/ScalableTSDFVolume.h>

#include "planescope/fusion.hpp"

namespace {

namespace o3 = open3d;
using planescope::Frame;
using planescope::Sequence;

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

constexpr double kMaxDepth = 4;  // [m]

// Open3D's own classes, as its tutorial on integration uses them.
class Peer {
 public:
  Peer(const Sequence& sequence, double voxel)
      : sequence_(sequence),
        volume_(voxel, 4 * voxel, o3::pipelines::integration::TSDFVolumeColorType::RGB8) {
    const auto& lens = sequence.camera().lens;
    camera_ = o3::camera::PinholeCameraIntrinsic(static_cast<int>(lens.width),
                                                 static_cast<int>(lens.height), lens.fx, lens.fy,
                                                 lens.cx, lens.cy);
  }

  static o3::geometry::Image depth_of(const Frame& frame) {
    o3::geometry::Image image;
    image.Prepare(static_cast<int>(frame.depth.width), static_cast<int>(frame.depth.height), 1, 2);
    std::copy_n(reinterpret_cast<const std::uint8_t*>(frame.depth.values.data()),
                2 * frame.depth.size(), image.data_.begin());
    return image;
  }

  static o3::geometry::Image color_of(const Frame& frame) {
    o3::geometry::Image image;  // black where the frame has none: it takes no frame without
    image.Prepare(static_cast<int>(frame.depth.width), static_cast<int>(frame.depth.height), 3, 1);
    for (std::size_t i = 0; i < frame.color.pixels.size(); ++i) {
      image.data_[3 * i] = frame.color.pixels[i].r;
      image.data_[3 * i + 1] = frame.color.pixels[i].g;
      image.data_[3 * i + 2] = frame.color.pixels[i].b;
    }
    return image;
  }

  void integrate(const o3::geometry::Image& color, const o3::geometry::Image& depth,
                 const Eigen::Isometry3d& pose) {
    const auto rgbd = o3::geometry::RGBDImage::CreateFromColorAndDepth(
        color, depth, sequence_.camera().depth_scale, kMaxDepth, false);
    volume_.Integrate(*rgbd, camera_, pose.inverse().matrix());
  }

  void read_and_integrate(std::size_t i) {
    o3::geometry::Image color, depth;
    const auto& info = sequence_.info(i);
    o3::io::ReadImage(info.depth.string(), depth);
    if (info.color.empty()) {
      color.Prepare(depth.width_, depth.height_, 3, 1);
    } else {
      o3::io::ReadImage(info.color.string(), color);
    }
    integrate(color, depth, info.pose);
  }

  std::size_t points() { return volume_.ExtractPointCloud()->points_.size(); }

 private:
  const Sequence& sequence_;
  o3::pipelines::integration::ScalableTSDFVolume volume_;
  o3::camera::PinholeCameraIntrinsic camera_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  planescope::SequenceOptions options;
  options.max_depth = kMaxDepth;
  const Sequence sequence(argv[1], options);
  const double voxel = argc > 2 ? std::atof(argv[2]) : 0.01;
  std::vector<Frame> frames;
  std::vector<o3::geometry::Image> colors, depths;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    frames.push_back(sequence.read(i));
    colors.push_back(Peer::color_of(frames.back()));
    depths.push_back(Peer::depth_of(frames.back()));
  }
  const auto n = static_cast<double>(sequence.size());
  Peer peer(sequence, voxel), peer_reading(sequence, voxel);
  planescope::TsdfVolume ours({.voxel_size = voxel});
  const double theirs = seconds([&] {
    for (std::size_t i = 0; i < frames.size(); ++i) {
      peer.integrate(colors[i], depths[i], frames[i].info.pose);
    }
  });
  const double own = seconds([&] {
    for (const Frame& frame : frames) {
      ours.integrate(frame.depth, frame.color, sequence.camera(), frame.info.pose);
    }
  });
  const double theirs_reading = seconds([&] {
    for (std::size_t i = 0; i < frames.size(); ++i) peer_reading.read_and_integrate(i);
  });
  const double own_reading = seconds([&] { planescope::fuse(sequence, {.voxel_size = voxel}); });
  std::printf("frames                  %8.0f\n", n);
  std::printf("integration, Open3D     %8.2f ms a frame\n", 1e3 * theirs / n);
  std::printf("integration, planescope %8.2f ms a frame: %.2f of Open3D\n", 1e3 * own / n,
              own / theirs);
  std::printf("with images, Open3D     %8.2f ms a frame\n", 1e3 * theirs_reading / n);
  std::printf("with images, planescope %8.2f ms a frame: %.2f of Open3D\n", 1e3 * own_reading / n,
              own_reading / theirs_reading);
  std::printf("points                  Open3D %zu, planescope %zu\n", peer.points(),
              ours.points().size());
  return 0;
}
