// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/point_fields.hpp"
#include "io/point_source.hpp"

/// \file One line of text into one point's numbers.
namespace planescope::io {

/// Parses lines whose words are the numbers of given fields, in order.
class RowParser {
 public:
  /// The vectors must outlive the parser.
  RowParser(const std::vector<Field>& fields, const Selection& selection);

  /// The fewest words that a line can have.
  std::uint64_t least_words() const noexcept { return least_words_; }

  /// Stores the line's used numbers as those of `point`; what is wrong with it, in words, if
  /// anything is. Words of other fields must be there, but are not looked at.
  std::optional<std::string> parse(std::string_view line, std::size_t point,
                                   MemoryColumns& columns) const;

 private:
  std::optional<std::string> parse_one(std::string_view& rest, const Field& field,
                                       std::byte* to) const;

  const std::vector<Field>& fields_;
  std::vector<std::optional<std::size_t>> column_;  ///< of each field, where it is used
  std::uint64_t least_words_ = 0;
};

}  // namespace planescope::io
