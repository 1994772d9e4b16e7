// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include "image.hpp"

/// \file Tubes, arrows and balls as lit surfaces: lines that are to be read as things in the scene.
namespace planescope::draw {

/// Solids with a colour each, in one mesh.
class Solids {
 public:
  Solids();

  /// A cone frustum about the axis from a to b, radius `from` at a and `to` at b [m].
  void add_frustum(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double from, double to,
                   const Pixel& color);
  void add_tube(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius,
                const Pixel& color) {
    add_frustum(a, b, radius, radius, color);
  }
  /// A shaft and a head that is a quarter of the length.
  void add_arrow(const Eigen::Vector3d& tail, const Eigen::Vector3d& tip, double radius,
                 const Pixel& color);
  void add_ball(const Eigen::Vector3d& center, double radius, const Pixel& color);

  vtkIdType size() const { return points_->GetNumberOfPoints(); }
  /// Lit from the eye.
  vtkSmartPointer<vtkActor> actor() const;

 private:
  vtkIdType add_point(const Eigen::Vector3d& p, const Eigen::Vector3d& normal, const Pixel& color);

  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> cells_;
  vtkNew<vtkFloatArray> normals_;
  vtkNew<vtkUnsignedCharArray> colors_;
};

}  // namespace planescope::draw
