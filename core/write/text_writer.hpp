// SPDX-License-Identifier: GPL-3.0-or-later
// Text and bytes for a file, passed on in pieces of a megabyte. So files of gigabytes need little
// memory.
#pragma once

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include "core/files/atomic_file.hpp"
#include "core/geometry/lattice.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

// All functions throw WriteError. A cancelled token is noticed once per megabyte and throws
// Cancelled. The last piece needs a flush().
class TextWriter {
 public:
  explicit TextWriter(AtomicFile& file, CancelToken cancel = {})
      : file_(file), cancel_(std::move(cancel)) {}

  TextWriter& operator<<(std::string_view text) {
    text_ += text;
    return *this;
  }
  TextWriter& operator<<(std::size_t number) {
    char buffer[24];
    text_.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr);
    return *this;
  }
  // Nine digits, which distinguish all floats; alpha values are floats.
  TextWriter& operator<<(double number) {
    char buffer[32];
    const auto end =
        std::to_chars(buffer, buffer + sizeof buffer, number, std::chars_format::general, 9);
    text_.append(buffer, end.ptr);
    return *this;
  }
  // The shortest decimal that reads back as the same number: "17.047".
  TextWriter& shortest(double number) {
    char buffer[400];
    const auto end =
        std::to_chars(buffer, buffer + sizeof buffer, number, std::chars_format::fixed);
    text_.append(buffer, end.ptr);
    return *this;
  }
  // A lattice number in Å with all its digits, without rounding.
  TextWriter& lattice(std::int32_t units, int digits) {
    char buffer[32];
    const double unit = Lattice{digits}.units_per_angstrom();
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, units / unit,
                                   std::chars_format::fixed, std::max(digits, 0));
    text_.append(buffer, end.ptr);
    return *this;
  }
  // Bytes as in memory. Files are little-endian, as are the machines.
  template <class T>
  TextWriter& bytes(const T& value) {
    static_assert(std::endian::native == std::endian::little);
    char buffer[sizeof value];
    std::memcpy(buffer, &value, sizeof value);
    text_.append(buffer, sizeof value);
    if (text_.size() >= kFlushBytes) flush();
    return *this;
  }
  void end_line() {
    text_ += '\n';
    if (text_.size() >= kFlushBytes) flush();
  }
  void flush() {
    cancel_.throw_if_cancelled();
    file_.write(text_);
    text_.clear();
  }

 private:
  static constexpr std::size_t kFlushBytes = std::size_t{1} << 20;

  AtomicFile& file_;
  CancelToken cancel_;
  std::string text_;
};

}  // namespace alphascope
