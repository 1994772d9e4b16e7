// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/text_row.hpp"

#include <cstring>

#include "io/numbers.hpp"

namespace planescope::io {
namespace {

/// Takes the blanks off the front; false where nothing is left.
bool to_word(std::string_view& rest) {
  std::size_t at = 0;
  while (at < rest.size() && is_blank(rest[at])) ++at;
  rest.remove_prefix(at);
  return !rest.empty();
}

/// Takes the word at the front off; to_word() must have been true.
std::string_view take_word(std::string_view& rest) {
  std::size_t size = 0;
  while (size < rest.size() && !is_blank(rest[size])) ++size;
  const std::string_view word = rest.substr(0, size);
  rest.remove_prefix(size);
  return word;
}

std::string too_few(const Field& field) {
  return "the line ends before the field " + field.name +
         "; expected one number for each field of the header";
}

/// Parses the word at the front as a T and stores it; false where it is none.
template <class T>
bool store_number(std::string_view& rest, std::byte* to) {
  T value{};
  const char* last = rest.data() + rest.size();
  const char* end = parse_number(rest.data(), last, value);
  if (end == nullptr || (end != last && !is_blank(*end))) return false;
  std::memcpy(to, &value, sizeof(T));
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  return true;
}

}  // namespace

RowParser::RowParser(const std::vector<Field>& fields, const Selection& selection)
    : fields_(fields), column_(fields.size()) {
  for (std::size_t i = 0; i < selection.used.size(); ++i) column_[selection.used[i]] = i;
  for (const Field& field : fields) least_words_ += field.list ? 1 : field.count;
}

std::optional<std::string> RowParser::parse_one(std::string_view& rest, const Field& field,
                                                std::byte* to) const {
  if (!to_word(rest)) return too_few(field);
  const bool stored = visit(field.type, [&]<class T>() { return store_number<T>(rest, to); });
  if (stored) return std::nullopt;
  return "the field " + field.name + " is " + in_quotes(take_word(rest)) +
         "; expected a number as " + words(field.type) + " hold it";
}

std::optional<std::string> RowParser::parse(std::string_view rest, std::size_t point,
                                            MemoryColumns& columns) const {
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const Field& field = fields_[i];
    if (column_[i]) {
      auto failure = parse_one(rest, field, columns.at(*column_[i], point));
      if (failure) return failure;
      continue;
    }
    std::uint64_t count = field.count;
    if (field.list) {
      if (!to_word(rest)) return too_few(field);
      const std::string_view word = take_word(rest);
      const auto length = parse_word<std::uint64_t>(word);
      if (!length)
        return "the length of the list " + field.name + " is " + in_quotes(word) +
               "; expected a whole number";
      count = *length;  // bounded by the words of the line: each must be there
    }
    for (std::uint64_t k = 0; k < count; ++k) {
      if (!to_word(rest)) return too_few(field);
      take_word(rest);
    }
  }
  if (to_word(rest)) {
    return "the line goes on with " + in_quotes(take_word(rest)) +
           "; expected one number for each field of the header";
  }
  return std::nullopt;
}

}  // namespace planescope::io
