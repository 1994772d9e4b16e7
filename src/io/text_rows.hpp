// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/input_file.hpp"
#include "io/point_fields.hpp"
#include "io/point_source.hpp"

/// \file Points as lines of text: one line a point, blank lines do not count.
namespace planescope::io {

/// Where the points' lines are in a file, and what they hold.
struct TextRows {
  std::uint64_t begin = 0;       ///< [byte] first byte after the header
  std::uint64_t first_line = 1;  ///< its line number, for messages
  std::uint64_t skip = 0;        ///< lines of other elements before the first point
  std::uint64_t points = 0;
  bool may_go_on = false;  ///< further lines after the points are another element's
};

/// Reads the used fields of all points. The file is walked in windows of 8 MB, whose pieces are
/// parsed in parallel; that the points fit into the file is checked before memory is taken.
/// \throws Error{Kind::Input} with the line: a word is no number of its field's type, too few or
/// too many words; or the file ends early (with the byte), or goes on where it should not.
std::unique_ptr<MemoryColumns> read_text(const InputFile& file, const std::vector<Field>& fields,
                                         const Selection& selection, const TextRows& rows);

}  // namespace planescope::io
