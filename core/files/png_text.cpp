// SPDX-License-Identifier: GPL-3.0-or-later
// Makes chunks and inserts them behind the header of a PNG file.
#include "core/files/png_text.hpp"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace alphascope {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t kHeaderEnd = 33;  // signature, then IHDR: length, type, 13 bytes, checksum

void append_big_endian(std::string& bytes, std::uint32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xFF);
}

// `body`: the chunk's type and its data.
std::string chunk_of(const std::string& body) {
  std::string chunk;
  append_big_endian(chunk, static_cast<std::uint32_t>(body.size() - 4));
  chunk += body;
  append_big_endian(chunk,
                    static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(body.data()),
                                                     static_cast<uInt>(body.size()))));
  return chunk;
}

std::string text_chunk(const std::string& keyword, const std::string& text) {
  const bool ascii = std::all_of(text.begin(), text.end(),
                                 [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  std::string body = (ascii ? "tEXt" : "iTXt") + keyword;
  // End of keyword; for iTXt: not compressed, method 0, no language, no translation.
  body.append(ascii ? 1 : 5, '\0');
  body += text;
  return chunk_of(body);
}

// Inserts chunks behind the header.
std::string with_chunks(std::string_view png, const std::string& chunks) {
  if (!png.starts_with(kSignature) || png.size() < kHeaderEnd) {
    throw std::invalid_argument("texts and resolution can only be put into a PNG picture");
  }
  return std::string(png.substr(0, kHeaderEnd)) + chunks + std::string(png.substr(kHeaderEnd));
}

}  // namespace

std::string with_png_text(std::string_view png,
                          const std::vector<std::pair<std::string, std::string>>& entries) {
  std::string chunks;
  for (const auto& [keyword, text] : entries) chunks += text_chunk(keyword, text);
  return with_chunks(png, chunks);
}

std::string with_png_resolution(std::string_view png, int dpi) {
  constexpr double kInchesPerMetre = 1 / 0.0254;
  const auto per_metre = static_cast<std::uint32_t>(std::lround(dpi * kInchesPerMetre));
  std::string body = "pHYs";
  append_big_endian(body, per_metre);  // across
  append_big_endian(body, per_metre);  // down
  body += '\1';                        // the unit is the metre
  return with_chunks(png, chunk_of(body));
}

}  // namespace alphascope
