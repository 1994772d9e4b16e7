// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <type_traits>

#include <Eigen/Core>

#include <vtkAOSDataArrayTemplate.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

/// \file Short ways to and from VTK's arrays.
namespace planescope::draw {

/// A named array of one component, value(i) for i in [0, count). Zeros are positive: VTK finds an
/// array's range with several threads, writes it into files, and of both zeros it would be any one.
template <typename Array, typename Value>
vtkSmartPointer<Array> make_column(const char* name, std::size_t count, Value&& value) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  for (std::size_t i = 0; i < count; ++i) {
    auto element = static_cast<typename Array::ValueType>(value(i));
    if constexpr (std::is_floating_point_v<decltype(element)>) element += 0;  // -0 + 0 is 0
    array->SetValue(static_cast<vtkIdType>(i), element);
  }
  return array;
}

/// A named array of three components, value(i) an Eigen vector of three.
template <typename Array, typename Value>
vtkSmartPointer<Array> make_vectors(const char* name, std::size_t count, Value&& value) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const auto vector = value(i);
    for (int c = 0; c < 3; ++c) {
      array->SetTypedComponent(static_cast<vtkIdType>(i), c,
                               static_cast<typename Array::ValueType>(vector[c]));
    }
  }
  return array;
}

/// The position of point i.
inline Eigen::Vector3f point(vtkPolyData& data, vtkIdType i) {
  double p[3];
  data.GetPoint(i, p);
  return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
}

/// The corners of cell i.
inline std::span<const vtkIdType> corners(vtkCellArray& cells, vtkIdType i) {
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  cells.GetCellAtId(i, count, ids);
  return {ids, static_cast<std::size_t>(count)};
}

/// The points moved by `shift`: in double for map coordinates, in single precision near zero.
template <typename Array>
void move_points(vtkPolyData& data, const Eigen::Vector3d& shift) {
  const auto count = static_cast<std::size_t>(data.GetNumberOfPoints());
  vtkNew<vtkPoints> moved;
  moved->SetData(make_vectors<Array>("position", count, [&](std::size_t i) {
    Eigen::Vector3d p;
    data.GetPoint(static_cast<vtkIdType>(i), p.data());
    return Eigen::Vector3d(p + shift);
  }));
  data.SetPoints(moved);
}

}  // namespace planescope::draw
