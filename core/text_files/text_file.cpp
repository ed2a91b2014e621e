// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a text file or descriptor to its end, unpacks it and normalises its line ends.
#include "core/text_files/text_file.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>

#include "core/files/read_error.hpp"
#include "core/files/regular_file.hpp"
#include "core/files/sha256.hpp"
#include "core/text_files/gzip.hpp"
#include "core/text_files/text_limits.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 20;

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // of UTF-8

[[noreturn]] void refuse_errno(const std::filesystem::path& path, const char* what,
                               const char* remedy) {
  throw ReadError(path, 0, std::string(what) + ": " + std::strerror(errno), remedy);
}

// Reads to the end. `expected` bytes are likely, but there may be more or fewer.
TextBuffer read_to_end(const std::filesystem::path& path, int descriptor, std::uint64_t expected,
                       std::uint64_t max_bytes, const RunContext& context) {
  LineLengths lengths(path);
  TextBuffer bytes;
  bytes.reserve(expected + 1);  // one more, so that the end is found without growing
  for (;;) {
    context.cancel.throw_if_cancelled();
    // Grow by half, for a file that grows while it is read and for a pipe.
    if (bytes.size() == bytes.capacity()) bytes.reserve(bytes.size() + bytes.size() / 2 + kChunk);
    const std::size_t room = std::min(kChunk, bytes.capacity() - bytes.size());
    const ssize_t got = ::read(descriptor, bytes.data() + bytes.size(), room);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) refuse_errno(path, "reading stopped", "Check the disk or the network drive");
    if (got == 0) return bytes;
    bytes.set_size(bytes.size() + static_cast<std::size_t>(got));
    if (bytes.size() > max_bytes) refuse_text_beyond(path, max_bytes);
    if (!bytes.view().starts_with("\x1f\x8b")) lengths.check(bytes.view());
  }
}

TextBuffer read_bytes(const std::filesystem::path& path, std::uint64_t max_bytes,
                      const RunContext& context, FileKind kind) {
  const RegularFile file(path, kind);
  if (file.bytes() > max_bytes) refuse_text_beyond(path, max_bytes);
  return read_to_end(path, file.descriptor(), file.bytes(), max_bytes, context);
}

}  // namespace

LoadedText load_text(const std::filesystem::path& path, std::uint64_t max_bytes,
                     const RunContext& context, std::optional<int> descriptor, FileKind kind) {
  max_bytes = std::min<std::uint64_t>(max_bytes, std::numeric_limits<std::int64_t>::max() / 4);
  LoadedText loaded;
  if (descriptor) note_read(*descriptor, path, kind);
  loaded.buffer = descriptor ? read_to_end(path, *descriptor, 0, max_bytes, context)
                             : read_bytes(path, max_bytes, context, kind);
  loaded.file_bytes = loaded.buffer.size();
  if (loaded.buffer.view().starts_with("\x1f\x8b")) {
    loaded.compressed = true;
    Sha256 hash;
    hash.update(loaded.buffer.view());
    loaded.sha256 = hash.finish();
    loaded.buffer = unpack_gzip(path, loaded.buffer.view(), max_bytes, context);
  }
  loaded.text = loaded.buffer.view();
  loaded.byte_order_mark = loaded.text.starts_with(kByteOrderMark);
  if (loaded.byte_order_mark) loaded.text.remove_prefix(kByteOrderMark.size());
  // CR alone ends a line in files of the oldest systems.
  if (loaded.text.find('\n') == std::string_view::npos &&
      loaded.text.find('\r') != std::string_view::npos) {
    loaded.sha256 = file_hash(loaded);
    std::replace(loaded.buffer.data(), loaded.buffer.data() + loaded.buffer.size(), '\r', '\n');
  }
  return loaded;
}

std::string file_hash(const LoadedText& loaded) {
  if (!loaded.sha256.empty()) return loaded.sha256;
  Sha256 hash;
  hash.update(loaded.buffer.view());
  return hash.finish();
}

}  // namespace alphascope
