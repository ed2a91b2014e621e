// SPDX-License-Identifier: GPL-3.0-or-later
// Inflates gzip data by zlib, and refuses data that are damaged, followed by other data, or a gzip
// bomb.
#include "core/text_files/gzip.hpp"

#include <zlib.h>

#include <algorithm>

#include "core/files/read_error.hpp"
#include "core/text/printable.hpp"
#include "core/text_files/text_limits.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 20;

// Gzip shrinks files of coordinates to between a third and a tenth, a file of equal lines to a
// hundredth, and a gzip bomb to a thousandth. The limit applies only from kSuspiciousFrom on.
constexpr std::uint64_t kMostExpansion = 200;
constexpr std::uint64_t kSuspiciousFrom = std::uint64_t{256} << 20;  // bytes

class Inflater {
 public:
  Inflater() {
    if (inflateInit2(&stream, 15 + 16) != Z_OK) throw std::bad_alloc();
  }
  ~Inflater() { inflateEnd(&stream); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  z_stream stream{};
};

[[noreturn]] void refuse_gzip(const std::filesystem::path& path, int code) {
  if (code == Z_MEM_ERROR) throw std::bad_alloc();
  const bool short_file = code == Z_BUF_ERROR || code == Z_OK;
  throw ReadError(path, 0,
                  short_file ? "the gzip data end too early: the file is truncated"
                             : "the gzip data are damaged",
                  "Fetch or copy the file again");
}

// Refuses data behind the last member; `tail` are these data.
void refuse_rest(const std::filesystem::path& path, std::string_view packed,
                 std::string_view tail) {
  if (tail.find_first_not_of('\0') == std::string_view::npos) return;
  constexpr std::size_t kShown = 40;
  const std::string_view start = tail.substr(0, kShown);
  const bool text = std::all_of(start.begin(), start.end(), [](char c) {
    return (c >= ' ' && c <= '~') || c == '\t' || c == '\n' || c == '\r';
  });
  const std::size_t line = start.find_first_not_of("\r\n");
  const std::string_view words =
      line == start.npos ? "" : start.substr(line, start.find_first_of("\r\n", line) - line);
  throw ReadError(path, 0,
                  "the gzip data end at byte " + std::to_string(packed.size() - tail.size()) +
                      " of " + std::to_string(packed.size()) + ", and " +
                      (text ? "text follows: \"" + shortened(words) + "\"" : "other data follow"),
                  "If a file was appended without packing it, unpack the first part and append to "
                  "that; else fetch the file again");
}

void refuse_bomb(const std::filesystem::path& path, std::uint64_t unpacked, std::uint64_t packed) {
  if (unpacked <= kSuspiciousFrom || unpacked / kMostExpansion <= packed) return;
  throw ReadError(path, 0,
                  "the gzip data unpack to more than " + std::to_string(kMostExpansion) +
                      " times their size, which never happens with coordinates",
                  "If this is a molecule nevertheless, unpack the file and open that");
}

}  // namespace

TextBuffer unpack_gzip(const std::filesystem::path& path, std::string_view packed,
                       std::uint64_t max_bytes, const RunContext& context) {
  Inflater inflater;
  z_stream& stream = inflater.stream;
  LineLengths lengths(path);
  TextBuffer text;
  std::size_t used = 0;
  text.reserve(std::min<std::uint64_t>(std::max(packed.size() * 5, kChunk), max_bytes + 1));
  for (;;) {
    context.cancel.throw_if_cancelled();
    if (text.size() == text.capacity()) {
      if (text.size() > max_bytes) refuse_text_beyond(path, max_bytes);
      text.reserve(std::min<std::uint64_t>(text.capacity() * 2, max_bytes + 1));
    }
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data() + used));
    stream.avail_in = static_cast<uInt>(std::min<std::size_t>(packed.size() - used, 1u << 30));
    stream.next_out = reinterpret_cast<Bytef*>(text.data() + text.size());
    stream.avail_out = static_cast<uInt>(std::min(text.capacity() - text.size(), 8 * kChunk));
    const uInt in = stream.avail_in, out = stream.avail_out;
    const int code = inflate(&stream, Z_NO_FLUSH);
    used += in - stream.avail_in;
    text.set_size(text.size() + (out - stream.avail_out));
    lengths.check(text.view());
    refuse_bomb(path, text.size(), packed.size());
    if (code == Z_STREAM_END) {
      const std::string_view tail = packed.substr(used);
      if (!tail.starts_with("\x1f\x8b") && tail != "\x1f") {
        refuse_rest(path, packed, tail);
        break;
      }
      inflateReset(&stream);
    } else if (code != Z_OK) {
      refuse_gzip(path, code);
    } else if (used == packed.size() && stream.avail_out != 0) {
      refuse_gzip(path, Z_BUF_ERROR);
    }
  }
  if (text.size() > max_bytes) refuse_text_beyond(path, max_bytes);
  return text;
}

}  // namespace alphascope
