// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/byte_cursor.hpp"

#include <algorithm>
#include <cstring>

#include "io/numbers.hpp"

namespace planescope::io {

ByteCursor::ByteCursor(const InputFile& file, std::uint64_t begin)
    : file_(file),
      offset_(std::min(begin, file.size())),
      window_(static_cast<std::size_t>(std::min<std::uint64_t>(kWindow, file.size()))) {}

void ByteCursor::require(std::uint64_t count, std::uint64_t size, const std::string& what) const {
  const std::optional<std::uint64_t> bytes = checked_product(count, size);
  if (bytes && *bytes <= remaining()) return;
  const std::string need = bytes ? std::to_string(*bytes) : "more than 2^64";
  file_.fail_byte(file_.size(), "the file ends here, but " + what + " needs " + need +
                                    " bytes from byte " + std::to_string(offset_) +
                                    " on; the file is truncated or its header is wrong");
}

void ByteCursor::refill() {
  std::memmove(window_.data(), window_.data() + start_, buffered());
  filled_ = buffered();
  start_ = 0;
  const std::uint64_t unread = remaining() - filled_;
  const auto more =
      static_cast<std::size_t>(std::min<std::uint64_t>(window_.size() - filled_, unread));
  file_.read_at(offset_ + filled_, std::span(window_).subspan(filled_, more));
  filled_ += more;
}

std::span<const std::byte> ByteCursor::take(std::size_t size, const std::string& what) {
  require(1, size, what);
  if (buffered() < size) refill();
  const std::span<const std::byte> bytes(window_.data() + start_, size);
  start_ += size;
  offset_ += size;
  return bytes;
}

void ByteCursor::skip(std::uint64_t count, std::uint64_t size, const std::string& what) {
  require(count, size, what);
  const std::uint64_t bytes = count * size;
  start_ = bytes < buffered() ? start_ + static_cast<std::size_t>(bytes) : filled_;
  offset_ += bytes;
}

std::optional<std::string_view> ByteCursor::line() {
  if (remaining() == 0) return std::nullopt;
  const auto find = [&] {
    return buffered() == 0 ? nullptr : std::memchr(window_.data() + start_, '\n', buffered());
  };
  const void* end = find();
  if (end == nullptr) {
    refill();
    end = find();
  }
  if (end == nullptr && buffered() < remaining()) {
    file_.fail_byte(offset_, "a line is longer than " + std::to_string(kWindow) +
                                 " bytes; expected a text header");
  }
  const char* begin = reinterpret_cast<const char*>(window_.data() + start_);
  std::size_t length =
      end == nullptr ? buffered() : static_cast<std::size_t>(static_cast<const char*>(end) - begin);
  const std::size_t step = end == nullptr ? length : length + 1;
  start_ += step;
  offset_ += step;
  if (length > 0 && begin[length - 1] == '\r') --length;
  return std::string_view(begin, length);
}

const std::vector<std::string_view>& HeaderLines::next(const char* last) {
  const std::optional<std::string_view> text = cursor_.line();
  if (!text) {
    file_.fail_byte(cursor_.offset(), std::string("the file ends inside its header; expected ") +
                                          last + "; the file is truncated");
  }
  ++line_;
  if (cursor_.offset() > kLimit) {
    file_.fail_line(line_, "the header is longer than " + std::to_string(kLimit) +
                               " bytes; expected " + last + " before that");
  }
  split(*text, words_);
  return words_;
}

}  // namespace planescope::io
