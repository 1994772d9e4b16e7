// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <vector>

/// \file Numbers and words from text: whole words only, the same in every locale.
namespace planescope::io {

/// Blank within a line. CR is one, so that CRLF files need no care.
inline bool is_blank(char c) noexcept { return c == ' ' || c == '\t' || c == '\r'; }

/// The words of a line, into `words` (its memory is used again).
void split(std::string_view line, std::vector<std::string_view>& words);

/// A word from a file for a message: in quotes, at most 40 characters, unprintable ones as '?'.
std::string in_quotes(std::string_view word);

/// Reads the number that starts at `first`; where it ends, or nullptr where there is none or T does
/// not hold it. Integers: decimal, '-' only where T is signed. Reals: also "nan", "inf" and a
/// leading '+'; a number too large for T is refused, not made infinite.
template <class T>
const char* parse_number(const char* first, const char* last, T& value) noexcept {
  if constexpr (std::is_floating_point_v<T>) {
    const bool plus = last - first > 1 && first[0] == '+' && first[1] != '-';
    const auto [end, failure] = std::from_chars(first + (plus ? 1 : 0), last, value);
    if (failure == std::errc::result_out_of_range) {
      // Too small is zero, too large is an error; from_chars says the same of both.
      double wide = 0;
      const auto again = std::from_chars(first + (plus ? 1 : 0), last, wide);
      if (again.ec != std::errc() || std::abs(wide) >= 1) return nullptr;
      value = std::copysign(T(0), static_cast<T>(std::signbit(wide) ? -1 : 1));
      return end;
    }
    if (failure != std::errc()) return nullptr;
    // "1e999" must not pass as infinity: only words do.
    const char* sign = first + (*first == '+' || *first == '-' ? 1 : 0);
    if (std::isinf(value) && *sign != 'i' && *sign != 'I') return nullptr;
    return end;
  } else {
    const auto [end, failure] = std::from_chars(first, last, value);
    return failure == std::errc() ? end : nullptr;
  }
}

/// The number that the whole word is, or nothing.
template <class T>
std::optional<T> parse_word(std::string_view word) noexcept {
  T value{};
  const char* last = word.data() + word.size();
  if (word.empty() || parse_number(word.data(), last, value) != last) return std::nullopt;
  return value;
}

}  // namespace planescope::io
