// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include <Eigen/Core>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

/// \file The .vtp files of a result folder (VTK XML, compressed, base64): written and read by VTK's
/// own classes, in memory, so that a file appears whole and a bad one is refused in our words.
namespace planescope::draw {

/// Writes `data` moved by `origin` [m]: files hold map coordinates, in double where the origin is
/// not zero. Same data, same bytes. \throws Error{Kind::Input} cannot be written.
void write_vtp(vtkPolyData* data, const Eigen::Vector3d& origin, const std::filesystem::path& file);

/// What a file must hold; files are untrusted, and the drawing indexes by what they say.
struct VtpContract {
  enum class Columns { OfPoints, OfCells };
  struct Column {
    const char* name;
    int components;
  };
  Columns columns = Columns::OfPoints;
  std::vector<Column> required;  ///< arrays that must be there, one tuple a point or a cell
  vtkIdType points = -1;         ///< number of points; -1: any
  vtkIdType max_points = 0;      ///< where any: no more than these
};

/// Reads a file back, moved by -origin. Every cell's corners are checked against the points.
/// \throws Error{Kind::Input} missing, malformed, or not what the contract says.
vtkSmartPointer<vtkPolyData> read_vtp(const std::filesystem::path& file,
                                      const Eigen::Vector3d& origin, const VtpContract& contract);

}  // namespace planescope::draw
