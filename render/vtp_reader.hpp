// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

/// \file VTP files as vtkXMLPolyDataWriter writes them by default: one piece, arrays appended in
/// base64, packed by zlib. VTK's own reader is not made for files that somebody edited: it
/// allocates what they ask for, and fuzzing crashes it in minutes.
namespace planescope::draw {

/// Reads such a file. Every count and offset is checked against the bytes that are there before
/// memory is taken; whether the cells' corners are points is not looked at.
/// \param name of the file, for messages.
/// \throws Error{Kind::Input} anything else than such a file.
vtkSmartPointer<vtkPolyData> parse_vtp(const std::string& bytes, const std::string& name);

}  // namespace planescope::draw
