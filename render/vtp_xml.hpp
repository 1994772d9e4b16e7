// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

/// \file The XML part of a VTP file: which arrays there are, and where.
namespace planescope::draw {

/// One <DataArray>.
struct VtpArray {
  std::string type, name;  ///< `Float32`, `normal`
  std::uint64_t components = 1;
  std::uint64_t offset = 0;  ///< [byte] in the appended data
};

/// What the header says; nothing of it has been held against the data.
struct VtpHeader {
  std::map<std::string, std::uint64_t, std::less<>> counts;  ///< `NumberOfPoints` and the others
  std::map<std::string, std::vector<VtpArray>, std::less<>> arrays;  ///< by `PointData`, `Lines`...
  std::string_view appended;                                         ///< base64, from offset 0 on
};

/// \throws Error{Kind::Input} other elements, formats, encodings or byte orders than
/// vtkXMLPolyDataWriter's own; more than one piece. The result's views are of `bytes`.
VtpHeader parse_vtp_header(std::string_view bytes, const std::string& name);

/// \throws Error{Kind::Input} always: what is wrong with the file.
[[noreturn]] void refuse_vtp(const std::string& name, const std::string& what);

}  // namespace planescope::draw
