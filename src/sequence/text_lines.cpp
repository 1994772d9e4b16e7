// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sequence/text_lines.hpp"

#include <optional>

#include "io/numbers.hpp"

namespace planescope::sequence {

TextLines::TextLines(const std::filesystem::path& file, const std::string& expected)
    : file_(file, expected), cursor_(file_) {}

bool TextLines::next() {
  while (const auto text = cursor_.line()) {
    ++line_;
    io::split(*text, words_);
    if (!words_.empty() && !words_.front().starts_with('#')) return true;
  }
  words_.clear();
  return false;
}

double TextLines::number(std::size_t word) const {
  const std::optional<double> value =
      word < words_.size() ? io::parse_word<double>(words_[word]) : std::nullopt;
  if (!value) {
    fail("word " + std::to_string(word + 1) + " is " +
         (word < words_.size() ? io::in_quotes(words_[word]) : "missing") + "; expected a number");
  }
  return *value;
}

void TextLines::require(std::size_t count, const char* expected) const {
  if (words_.size() == count) return;
  fail("has " + std::to_string(words_.size()) + " words; expected " + expected);
}

}  // namespace planescope::sequence
