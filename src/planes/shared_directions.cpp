// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planes/shared_directions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "planes/object_faces.hpp"

namespace planescope {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Where the patches of a plane lie, and how far it may turn.
struct Body {
  double area = 0;
  Vector3d mean = Vector3d::Zero();
  Matrix3d scatter = Matrix3d::Zero();  // [m^2] mean of d d^T, d from `mean`
  Vector3d normal = Vector3d::UnitZ();  // as fitted
  double allowed = 0;                   // [m^2] variance along the normal that it may have

  double variance(const Vector3d& direction) const { return direction.dot(scatter * direction); }
};

// A plane, and which column of a frame its normal is.
struct Member {
  std::size_t plane = 0;
  int axis = 0;
};

// Three orthogonal directions.
struct Frame {
  Matrix3d axes = Matrix3d::Identity();  // columns
  std::vector<Member> members;
  bool complete = false;  // before, only the first column means anything
  int parent = kNone;     // frame that it has the first column from, or kNone
  int parent_axis = 0;    // its column there

  int columns() const { return complete ? 3 : 1; }
};

double cosine_of(double degrees) { return std::cos(degrees * std::numbers::pi / 180); }
double sine_of(double degrees) { return std::sin(degrees * std::numbers::pi / 180); }

std::vector<Body> measure(const std::vector<SupportingPlane>& planes,
                          std::span<const Patch> patches, std::span<const std::int32_t> patch_plane,
                          const DirectionTolerance& tolerance) {
  std::vector<Body> bodies(planes.size());
  const auto for_each_member = [&](const auto& use) {
    for (std::size_t i = 0; i < patch_plane.size(); ++i) {
      if (patch_plane[i] == kNone) continue;
      use(bodies[static_cast<std::size_t>(patch_plane[i])], double(patches[i].area),
          patches[i].centroid.cast<double>());
    }
  };
  for_each_member([](Body& body, double area, const Vector3d& c) {
    body.area += area;
    body.mean += area * c;
  });
  for (Body& body : bodies) {
    if (body.area > 0) body.mean /= body.area;
  }
  for_each_member([](Body& body, double area, const Vector3d& c) {
    const Vector3d d = c - body.mean;
    body.scatter += area / body.area * d * d.transpose();
  });
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const bool face = planes[p].role == PlaneRole::Face;
    const double sigma = face ? tolerance.face_sigma : tolerance.support_sigma;
    bodies[p].normal = planes[p].plane.normal.cast<double>();
    bodies[p].allowed =
        std::max(2.25 * bodies[p].variance(bodies[p].normal), 0.0625 * sigma * sigma) +
        tolerance.surface_error * tolerance.surface_error;
  }
  return bodies;
}

// Supporting planes first, then by area: what is seen best decides where the frames lie.
std::vector<std::size_t> founding_order(const std::vector<SupportingPlane>& planes,
                                        const std::vector<Body>& bodies) {
  std::vector<std::size_t> order;
  for (std::size_t p = 0; p < planes.size(); ++p) {
    if (bodies[p].area > 0) order.push_back(p);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (planes[a].role != planes[b].role) return planes[a].role == PlaneRole::Support;
    return bodies[a].area > bodies[b].area;
  });
  return order;
}

bool may_take(const Body& body, const Vector3d& direction, const DirectionTolerance& tolerance) {
  return std::abs(direction.dot(body.normal)) >= cosine_of(tolerance.angle) &&
         body.variance(direction) <= body.allowed;
}

// The direction orthogonal to `axis` that is nearest to the body's normal, if it may take it.
std::optional<Vector3d> beside(const Body& body, const Vector3d& axis,
                               const DirectionTolerance& tolerance) {
  const double along = axis.dot(body.normal);
  if (std::abs(along) > sine_of(tolerance.angle)) return std::nullopt;
  const Vector3d direction = (body.normal - along * axis).normalized();
  if (!may_take(body, direction, tolerance)) return std::nullopt;
  return direction;
}

// The frame with this first column and the second nearest to `second`.
Matrix3d completed(const Vector3d& first, const Vector3d& second) {
  const Vector3d beside = (second - first.dot(second) * first).normalized();
  Matrix3d axes;
  axes << first, beside, first.cross(beside);
  return axes;
}

// Joins the first frame, made by larger planes, that has the plane's direction.
bool join(std::vector<Frame>& frames, std::size_t plane, const Body& body,
          const DirectionTolerance& tolerance) {
  for (Frame& frame : frames) {
    int best = kNone;
    for (int a = 0; a < frame.columns(); ++a) {
      const Vector3d direction = frame.axes.col(a);
      if (may_take(body, direction, tolerance)) best = a;  // the others are 90 degrees away
    }
    if (best == kNone) continue;
    frame.members.push_back({plane, best});
    return true;
  }
  return false;
}

// Gives a frame of one direction its others, or founds one that shares a direction, or a new one.
void found(std::vector<Frame>& frames, std::size_t plane, const Body& body,
           const DirectionTolerance& tolerance) {
  for (std::size_t f = 0; f < frames.size(); ++f) {
    for (int a = 0; a < frames[f].columns(); ++a) {
      const Vector3d axis = frames[f].axes.col(a);
      const std::optional<Vector3d> direction = beside(body, axis, tolerance);
      if (!direction) continue;
      if (frames[f].complete) {
        frames.push_back({completed(axis, *direction), {{plane, 1}}, true, static_cast<int>(f), a});
      } else {
        frames[f].axes = completed(axis, *direction);
        frames[f].complete = true;
        frames[f].members.push_back({plane, 1});
      }
      return;
    }
  }
  frames.push_back({completed(body.normal, body.normal.unitOrthogonal()), {{plane, 0}}});
}

void turn(Frame& frame, const Vector3d& by) {
  const double angle = by.norm();
  if (angle == 0) return;
  const Matrix3d turned = Eigen::AngleAxisd(angle, by / angle) * frame.axes;
  frame.axes = completed(turned.col(0).normalized(), turned.col(1));
}

// Gauss-Newton over rotations: least sum of w S(r, r), r the members' columns. A shared direction
// stays: the frame turns about it alone.
void fit(Frame& frame, const std::vector<Body>& bodies) {
  constexpr int kSteps = 5;
  for (int step = 0; step < kSteps; ++step) {
    Matrix3d hessian = Matrix3d::Zero();
    Vector3d gradient = Vector3d::Zero();
    for (const Member& member : frame.members) {
      const Body& body = bodies[member.plane];
      const Vector3d r = frame.axes.col(member.axis);
      Matrix3d b;  // d(w x r) / dw
      b << 0, r.z(), -r.y(), -r.z(), 0, r.x(), r.y(), -r.x(), 0;
      const double weight = body.area / body.allowed;
      hessian += weight * b.transpose() * body.scatter * b;
      gradient += weight * b.transpose() * (body.scatter * r);
    }
    if (frame.parent != kNone) {
      const Vector3d axis = frame.axes.col(0);
      const double stiffness = axis.dot(hessian * axis);
      if (stiffness > 0) turn(frame, -axis.dot(gradient) / stiffness * axis);
    } else {
      // The turn about a lone direction is free: a little stiffness keeps it where it is.
      hessian += 1e-9 * hessian.trace() * Matrix3d::Identity();
      turn(frame, -hessian.ldlt().solve(gradient));
    }
  }
}

// Fits all frames, parents first, and lets go of planes that do not stand the outcome.
void fit_all(std::vector<Frame>& frames, const std::vector<Body>& bodies,
             const DirectionTolerance& tolerance) {
  for (Frame& frame : frames) {
    if (frame.parent != kNone) {
      const Frame& parent = frames[static_cast<std::size_t>(frame.parent)];
      frame.axes = completed(parent.axes.col(frame.parent_axis), frame.axes.col(1));
    }
    fit(frame, bodies);
    std::erase_if(frame.members, [&](const Member& member) {
      return !may_take(bodies[member.plane], frame.axes.col(member.axis), tolerance);
    });
    fit(frame, bodies);
  }
}

void set_direction(SupportingPlane& plane, const Body& body, const Vector3d& direction) {
  const Vector3d normal = direction.dot(body.normal) < 0 ? Vector3d(-direction) : direction;
  plane.plane = {normal.cast<float>(), static_cast<float>(normal.dot(body.mean))};
  plane.rms = static_cast<float>(std::sqrt(std::max(0.0, body.variance(normal))));
}

}  // namespace

double surface_error(double smoothing) { return std::numbers::sqrt3 / 4 * smoothing; }

DirectionTolerance direction_tolerance(const Options& options) {
  return {.angle = options.planes.weight_angle > 0 ? options.planes.alpha : 0,
          .face_sigma = face_sigma(options.planes.sigma),
          .support_sigma = options.planes.sigma,
          .surface_error = surface_error(options.patches.smoothing)};
}

void share_directions(std::vector<SupportingPlane>& planes, std::span<const Patch> patches,
                      std::span<const std::int32_t> patch_plane,
                      const DirectionTolerance& tolerance) {
  if (tolerance.angle <= 0) return;
  const std::vector<Body> bodies = measure(planes, patches, patch_plane, tolerance);
  std::vector<Frame> frames;
  for (const std::size_t p : founding_order(planes, bodies)) {
    if (!join(frames, p, bodies[p], tolerance)) found(frames, p, bodies[p], tolerance);
  }
  fit_all(frames, bodies, tolerance);
  for (const Frame& frame : frames) {
    const bool alone = frame.members.size() < 2 && frame.parent == kNone;
    if (alone) continue;  // as it was fitted
    for (const Member& member : frame.members) {
      set_direction(planes[member.plane], bodies[member.plane], frame.axes.col(member.axis));
    }
  }
}

}  // namespace planescope
