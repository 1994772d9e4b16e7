// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
// planescope-odometry: puts RGB-D frames to each other by Open3D. planescope starts it, and speaks
// to it over standard input, which is a socket (odometry/messages.hpp). Open3D lives here and
// nowhere else. Ends with 0 when planescope hangs up, with 2 when it is started by hand.
#include <omp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>
#include <vector>

#include <open3d/camera/PinholeCameraIntrinsic.h>
#include <open3d/geometry/Image.h>
#include <open3d/geometry/RGBDImage.h>
#include <open3d/pipelines/odometry/Odometry.h>

#include "odometry/messages.hpp"

namespace {

namespace o3 = open3d;
using planescope::odometry::Do;
using planescope::odometry::Hello;
using planescope::odometry::Reply;
using planescope::odometry::Request;

/// False when planescope has hung up.
bool receive(void* data, std::size_t size) {
  char* at = static_cast<char*>(data);
  while (size > 0) {
    const ssize_t done = ::recv(STDIN_FILENO, at, size, 0);
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    at += done;
    size -= static_cast<std::size_t>(done);
  }
  return true;
}

bool send(const Reply& reply) {
  return ::send(STDIN_FILENO, &reply, sizeof reply, MSG_NOSIGNAL) == sizeof reply;
}

struct View {
  o3::geometry::RGBDImage images;  // brightness, depth [m]
  bool has_color = false;
  std::size_t returns = 0;  // pixels with a depth
};

class Matcher {
 public:
  explicit Matcher(const Hello& hello)
      : hello_(hello),
        lens_(static_cast<int>(hello.width), static_cast<int>(hello.height), hello.fx, hello.fy,
              hello.cx, hello.cy) {
    flat_ = make_image();
    const float grey = 0.5F;
    for (std::size_t i = 0; i < flat_.data_.size(); i += sizeof grey) {
      std::memcpy(flat_.data_.data() + i, &grey, sizeof grey);
    }
  }

  bool take(bool has_color) {
    taken_.has_color = has_color;
    taken_.images.depth_ = make_image();
    taken_.images.color_ = make_image();
    auto& depths = taken_.images.depth_.data_;
    auto& values = taken_.images.color_.data_;
    if (!receive(depths.data(), depths.size()) || !receive(values.data(), values.size())) {
      return false;
    }
    taken_.returns = 0;
    for (std::size_t i = 0; i < depths.size(); i += sizeof(float)) {
      float depth = 0;
      std::memcpy(&depth, depths.data() + i, sizeof depth);
      taken_.returns += depth > 0 ? 1U : 0U;
    }
    return true;
  }

  void keep() { kept_ = taken_; }

  Reply match(const Request& request) const {
    Reply reply;
    if (taken_.returns == 0 || kept_.returns == 0) return reply;
    const bool both = taken_.has_color && kept_.has_color;
    if (both) reply = match(request, taken_.images, kept_.images);
    if (reply.found == 0) reply = match(request, without_color(taken_), without_color(kept_));
    return reply;
  }

 private:
  o3::geometry::Image make_image() const {
    o3::geometry::Image image;
    image.Prepare(lens_.width_, lens_.height_, 1, sizeof(float));
    return image;
  }

  /// The same grey all over: only the depths say anything.
  o3::geometry::RGBDImage without_color(const View& view) const {
    return {flat_, view.images.depth_};
  }

  Reply match(const Request& request, const o3::geometry::RGBDImage& taken,
              const o3::geometry::RGBDImage& kept) const {
    namespace odo = o3::pipelines::odometry;
    odo::OdometryOption option;
    option.depth_min_ = hello_.min_depth;
    option.depth_max_ = hello_.max_depth;
    const Eigen::Matrix4d guess = Eigen::Map<const Eigen::Matrix4d>(request.guess.data());
    const auto [found, motion, information] = odo::ComputeRGBDOdometry(
        taken, kept, lens_, guess, odo::RGBDOdometryJacobianFromHybridTerm(), option);
    Reply reply;
    // Of translation, the information is the number of pixels that correspond.
    reply.share = information(5, 5) / static_cast<double>(taken_.returns);
    if (!found || !motion.allFinite()) return Reply{};
    Eigen::Map<Eigen::Matrix4d>(reply.motion.data()) = motion;
    reply.found = 1;
    return reply;
  }

  Hello hello_;
  o3::camera::PinholeCameraIntrinsic lens_;
  o3::geometry::Image flat_;
  View taken_, kept_;
};

}  // namespace

int main() {
  Hello hello;
  if (!receive(&hello, sizeof hello) || hello.magic != planescope::odometry::kMagic) {
    std::fputs("planescope-odometry is started by planescope, where a sequence has no poses\n",
               stderr);
    return 2;
  }
  omp_set_num_threads(1);  // more of them add up in an order of their own: other bits each time
  o3::utility::SetVerbosityLevel(o3::utility::VerbosityLevel::Error);
  Matcher matcher(hello);
  if (!send({})) return 0;
  Request request;
  while (receive(&request, sizeof request)) {
    if (request.what == Do::Keep) matcher.keep();
    if (request.what == Do::Take && !matcher.take(request.has_color != 0)) return 0;
    if (request.what == Do::Match && !send(matcher.match(request))) return 0;
  }
  return 0;
}
