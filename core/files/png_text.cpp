// SPDX-License-Identifier: GPL-3.0-or-later
// Makes text chunks and inserts them behind the header of a PNG file.
#include "core/files/png_text.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>

namespace alphascope {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t kHeaderEnd = 33;  // signature, then IHDR: length, type, 13 bytes, checksum

void append_big_endian(std::string& bytes, std::uint32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xFF);
}

std::string text_chunk(const std::string& keyword, const std::string& text) {
  const bool ascii = std::all_of(text.begin(), text.end(),
                                 [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  std::string body = (ascii ? "tEXt" : "iTXt") + keyword;
  // End of keyword; for iTXt: not compressed, method 0, no language, no translation.
  body.append(ascii ? 1 : 5, '\0');
  body += text;
  std::string chunk;
  append_big_endian(chunk, static_cast<std::uint32_t>(body.size() - 4));
  chunk += body;
  append_big_endian(chunk,
                    static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(body.data()),
                                                     static_cast<uInt>(body.size()))));
  return chunk;
}

}  // namespace

std::string with_png_text(std::string_view png,
                          const std::vector<std::pair<std::string, std::string>>& entries) {
  if (!png.starts_with(kSignature) || png.size() < kHeaderEnd) {
    throw std::invalid_argument("texts can only be put into a PNG picture");
  }
  std::string result(png.substr(0, kHeaderEnd));
  for (const auto& [keyword, text] : entries) result += text_chunk(keyword, text);
  result += png.substr(kHeaderEnd);
  return result;
}

}  // namespace alphascope
