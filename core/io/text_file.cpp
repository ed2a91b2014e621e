#include "core/io/text_file.hpp"

#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>

#include "core/io/read_error.hpp"
#include "core/io/sha256.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 20;

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // UTF-8's

std::string mebibytes(std::uint64_t bytes) {
  return std::to_string(bytes >> 20) + " MiB";
}

[[noreturn]] void refuse_size(const std::filesystem::path& path, std::uint64_t limit) {
  throw ReadError(path, 0, "the text is larger than the limit of " + mebibytes(limit),
                  "If this is meant to be so large, raise the limit (option max_bytes)");
}

void refuse_what_is_no_file(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) {
    throw ReadError(path, 0, "there is no such file", "Check the name and the folder");
  }
  if (error) {
    throw ReadError(path, 0, "the file cannot be reached: " + error.message(),
                    "Check the permissions of the folder");
  }
  if (status.type() == fs::file_type::directory) {
    throw ReadError(path, 0, "this is a folder, not a file", "Choose a file inside it");
  }
  if (status.type() != fs::file_type::regular) {
    throw ReadError(path, 0, "this is a pipe or a device, not an ordinary file",
                    "Save its content to a file and open that");
  }
}

std::string read_bytes(const std::filesystem::path& path, std::uint64_t max_bytes,
                       const RunContext& context) {
  refuse_what_is_no_file(path);
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw ReadError(path, 0, std::string("the file cannot be opened: ") + std::strerror(errno),
                    "Check that you may read it");
  }
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(path, error);
  if (!error && size > max_bytes) refuse_size(path, max_bytes);
  std::string bytes;
  if (!error) bytes.reserve(size);
  while (file) {
    context.cancel.throw_if_cancelled();
    const std::size_t old = bytes.size();
    bytes.resize(old + std::min<std::uint64_t>(kChunk, max_bytes + 1 - old));
    file.read(bytes.data() + old, static_cast<std::streamsize>(bytes.size() - old));
    bytes.resize(old + static_cast<std::size_t>(file.gcount()));
    if (bytes.size() > max_bytes) refuse_size(path, max_bytes);
  }
  if (file.bad()) {
    throw ReadError(path, 0, std::string("reading stopped: ") + std::strerror(errno),
                    "Check the disk or the network drive");
  }
  return bytes;
}

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

// All members of a gzip file, one after another, as gunzip does.
std::string unpack(const std::filesystem::path& path, std::string packed, std::uint64_t max_bytes,
                   const RunContext& context) {
  Inflater inflater;
  z_stream& stream = inflater.stream;
  std::string text;
  std::size_t used = 0;
  text.resize(std::clamp<std::uint64_t>(packed.size() * 5, kChunk, max_bytes + 1));
  std::size_t filled = 0;
  for (;;) {
    context.cancel.throw_if_cancelled();
    if (filled == text.size()) {
      if (filled > max_bytes) refuse_size(path, max_bytes);
      text.resize(std::min<std::uint64_t>(filled * 2, max_bytes + 1));
    }
    stream.next_in = reinterpret_cast<Bytef*>(packed.data() + used);
    stream.avail_in = static_cast<uInt>(std::min<std::size_t>(packed.size() - used, 1u << 30));
    stream.next_out = reinterpret_cast<Bytef*>(text.data() + filled);
    stream.avail_out = static_cast<uInt>(std::min<std::size_t>(text.size() - filled, 8 * kChunk));
    const uInt in = stream.avail_in, out = stream.avail_out;
    const int code = inflate(&stream, Z_NO_FLUSH);
    used += in - stream.avail_in;
    filled += out - stream.avail_out;
    if (code == Z_STREAM_END) {
      const bool another =
          packed.size() - used >= 2 && packed[used] == '\x1f' && packed[used + 1] == '\x8b';
      if (!another) break;
      inflateReset(&stream);
    } else if (code != Z_OK) {
      refuse_gzip(path, code);
    } else if (used == packed.size() && stream.avail_out != 0) {
      refuse_gzip(path, Z_BUF_ERROR);
    }
  }
  text.resize(filled);
  if (filled > max_bytes) refuse_size(path, max_bytes);
  return text;
}

}  // namespace

LoadedText load_text(const std::filesystem::path& path, std::uint64_t max_bytes,
                     const RunContext& context) {
  max_bytes = std::min<std::uint64_t>(max_bytes, std::numeric_limits<std::int64_t>::max() / 4);
  LoadedText loaded;
  loaded.text = read_bytes(path, max_bytes, context);
  loaded.file_bytes = loaded.text.size();
  if (loaded.text.starts_with("\x1f\x8b")) {
    loaded.compressed = true;
    Sha256 hash;
    hash.update(loaded.text);
    loaded.sha256 = hash.finish();
    loaded.text = unpack(path, std::move(loaded.text), max_bytes, context);
  }
  loaded.byte_order_mark = loaded.text.starts_with(kByteOrderMark);
  if (loaded.byte_order_mark) loaded.text.erase(0, kByteOrderMark.size());
  // Lines of the oldest systems end with CR alone.
  if (loaded.text.find('\n') == std::string::npos && loaded.text.find('\r') != std::string::npos) {
    loaded.sha256 = file_hash(loaded);
    std::replace(loaded.text.begin(), loaded.text.end(), '\r', '\n');
  }
  return loaded;
}

std::string file_hash(const LoadedText& loaded) {
  if (!loaded.sha256.empty()) return loaded.sha256;
  Sha256 hash;
  if (loaded.byte_order_mark) hash.update(kByteOrderMark);
  hash.update(loaded.text);
  return hash.finish();
}

}  // namespace alphascope
