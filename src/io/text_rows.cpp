// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/text_rows.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <string_view>

#include "io/numbers.hpp"
#include "io/text_row.hpp"

namespace planescope::io {
namespace {

constexpr std::size_t kWindow = std::size_t{1} << 23;  // [byte] the longest line, too
constexpr std::size_t kPiece = std::size_t{1} << 18;   // [byte] what one task parses

/// Some whole lines of a window, and where they stand in the file.
struct Piece {
  std::string_view text;
  std::uint64_t line = 0, row = 0;  ///< number of the first line; of the first row from 0
  std::uint64_t lines = 0, rows = 0;
  std::uint64_t bad_line = 0;  ///< where `failure` is
  std::optional<std::string> failure;
};

/// Calls f(line without its end) for each line; f returns false to stop.
template <class F>
void each_line(std::string_view text, F f) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (!f(text.substr(0, end))) return;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

bool is_row(std::string_view line) { return !std::all_of(line.begin(), line.end(), is_blank); }

/// The window in pieces that end with a line each.
std::vector<Piece> cut(std::string_view text) {
  std::vector<Piece> pieces;
  while (!text.empty()) {
    std::size_t size = std::min(kPiece, text.size());
    size = std::min(text.find('\n', size - 1), text.size() - 1) + 1;
    pieces.emplace_back().text = text.substr(0, size);
    text.remove_prefix(size);
  }
  return pieces;
}

void count_rows(Piece& piece) {
  each_line(piece.text, [&](std::string_view line) {
    ++piece.lines;
    piece.rows += is_row(line) ? 1 : 0;
    return true;
  });
}

/// Walks the windows of a file's text.
class TextReader {
 public:
  TextReader(const InputFile& file, const RowParser& parser, const TextRows& rows,
             MemoryColumns& columns)
      : file_(file),
        parser_(parser),
        rows_(rows),
        columns_(columns),
        offset_(rows.begin),
        line_(rows.first_line) {
    const std::uint64_t size = std::min<std::uint64_t>(kWindow, file.size() - rows.begin);
    capacity_ = static_cast<std::size_t>(size);
    window_ = std::make_unique_for_overwrite<char[]>(capacity_);
  }

  void read() {
    while (offset_ < file_.size() && !(rows_.may_go_on && row_ >= end_row())) window();
    if (row_ >= end_row()) return;
    const std::uint64_t found = row_ > rows_.skip ? row_ - rows_.skip : 0;
    file_.fail_byte(file_.size(), "the file ends after " + std::to_string(found) + " of " +
                                      std::to_string(rows_.points) +
                                      " points; it is truncated or its header is wrong");
  }

 private:
  std::uint64_t end_row() const noexcept { return rows_.skip + rows_.points; }

  /// The next whole lines, at least one.
  std::string_view next_lines() {
    const auto size =
        static_cast<std::size_t>(std::min<std::uint64_t>(capacity_, file_.size() - offset_));
    file_.read_at(offset_, std::as_writable_bytes(std::span(window_.get(), size)));
    const std::string_view text(window_.get(), size);
    const std::size_t end = text.rfind('\n');
    if (offset_ + size == file_.size()) return text;  // the last line may have no end
    if (end == std::string_view::npos) {
      file_.fail_line(line_, "the line is longer than " + std::to_string(kWindow) +
                                 " bytes; expected the numbers of one point");
    }
    return text.substr(0, end + 1);
  }

  void window() {
    const std::string_view text = next_lines();
    std::vector<Piece> pieces = cut(text);
    const auto all = [&](auto work) {
      tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) { work(pieces[i]); });
    };
    all(count_rows);
    for (Piece& piece : pieces) {
      piece.line = line_;
      piece.row = row_;
      line_ += piece.lines;
      row_ += piece.rows;
    }
    all([this](Piece& piece) { parse(piece); });
    for (const Piece& piece : pieces) {  // in order: the first failure of the file is the one told
      if (piece.failure) file_.fail_line(piece.bad_line, *piece.failure);
    }
    offset_ += text.size();
  }

  void parse(Piece& piece) const {
    std::uint64_t line = piece.line, row = piece.row;
    each_line(piece.text, [&](std::string_view text) {
      if (is_row(text)) {
        if (row >= end_row()) {
          if (!rows_.may_go_on) {
            piece.failure = "there are more lines than the " + std::to_string(rows_.points) +
                            " points of the header; expected the end of the file";
          }
        } else if (row >= rows_.skip) {
          piece.failure = parser_.parse(text, static_cast<std::size_t>(row - rows_.skip), columns_);
        }
        ++row;
      }
      piece.bad_line = line++;
      return !piece.failure && !(rows_.may_go_on && row >= end_row());
    });
  }

  const InputFile& file_;
  const RowParser& parser_;
  const TextRows& rows_;
  MemoryColumns& columns_;
  std::uint64_t offset_, line_, row_ = 0;
  std::size_t capacity_ = 0;
  std::unique_ptr<char[]> window_;
};

/// A point needs its words and as many ends of words, the last of the file apart.
void require_room(const InputFile& file, const RowParser& parser, const TextRows& rows) {
  const std::uint64_t there = file.size() - rows.begin + 1;
  const auto least = checked_product(rows.points, 2 * parser.least_words());
  if (least && *least <= there) return;
  file.fail_byte(file.size(), "the file ends here, but " + std::to_string(rows.points) +
                                  " points of " + std::to_string(parser.least_words()) +
                                  " numbers do not fit into " + std::to_string(there - 1) +
                                  " bytes; it is truncated or its header is wrong");
}

}  // namespace

std::unique_ptr<MemoryColumns> read_text(const InputFile& file, const std::vector<Field>& fields,
                                         const Selection& selection, const TextRows& rows) {
  const RowParser parser(fields, selection);
  require_room(file, parser, rows);
  auto columns =
      std::make_unique<MemoryColumns>(fields, selection, static_cast<std::size_t>(rows.points));
  TextReader(file, parser, rows, *columns).read();
  return columns;
}

}  // namespace planescope::io
