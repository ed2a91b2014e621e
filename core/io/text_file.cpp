#include "core/io/text_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>

#include "core/io/read_error.hpp"
#include "core/io/sha256.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 20;

// Coordinates of molecules pack to a third or a tenth, a file of equal lines to a hundredth; a gzip
// bomb to a thousandth. Small files may do what they like.
constexpr std::uint64_t kMostExpansion = 200;
constexpr std::uint64_t kSuspiciousFrom = std::uint64_t{256} << 20;  // bytes

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // UTF-8's

std::string mebibytes(std::uint64_t bytes) {
  return std::to_string(bytes >> 20) + " MiB";
}

[[noreturn]] void refuse_size(const std::filesystem::path& path, std::uint64_t limit) {
  throw ReadError(path, 0, "the text is larger than the limit of " + mebibytes(limit),
                  "Keep only the atoms that you need, in a file of their own");
}

[[noreturn]] void refuse_errno(const std::filesystem::path& path, const char* what,
                               const char* remedy) {
  throw ReadError(path, 0, std::string(what) + ": " + std::strerror(errno), remedy);
}

class Descriptor {
 public:
  // Not waiting for a writer, should this be a pipe.
  explicit Descriptor(const std::filesystem::path& path)
      : number_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

void refuse_what_is_no_file(const std::filesystem::path& path, const struct stat& status) {
  if (S_ISDIR(status.st_mode)) {
    throw ReadError(path, 0, "this is a folder, not a file", "Choose a file inside it");
  }
  if (!S_ISREG(status.st_mode)) {
    throw ReadError(path, 0, "this is a pipe or a device, not an ordinary file",
                    "Save its content to a file and open that");
  }
}

[[noreturn]] void refuse_opening(const std::filesystem::path& path) {
  if (errno == ENOENT || errno == ENOTDIR) {
    throw ReadError(path, 0, "there is no such file", "Check the name and the folder");
  }
  refuse_errno(path, "the file cannot be opened", "Check that you may read it");
}

// Refuses a line that is too long while the text still grows.
class LineLengths {
 public:
  explicit LineLengths(const std::filesystem::path& path) : path_(path) {}

  void look_at(std::string_view text) {
    const std::string_view fresh = text.substr(seen_);
    const std::size_t last = fresh.find_last_of("\n\r");
    if (last != std::string_view::npos) line_start_ = seen_ + last + 1;
    seen_ = text.size();
    if (seen_ - line_start_ <= kLongestLine) return;
    const std::string_view before = text.substr(0, line_start_);
    throw ReadError(
        path_, 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')),
        "this line is longer than " + mebibytes(kLongestLine),
        "No coordinate file has such lines; check that this is one, and fetch it again");
  }

 private:
  const std::filesystem::path& path_;
  std::size_t seen_ = 0, line_start_ = 0;
};

TextBuffer read_bytes(const std::filesystem::path& path, std::uint64_t max_bytes,
                      const RunContext& context) {
  // Looked at before it is opened, which may do something to a device; and again afterwards, should
  // something else be there by then.
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) refuse_opening(path);
  refuse_what_is_no_file(path, status);
  const Descriptor file(path);
  if (file.number() < 0 || ::fstat(file.number(), &status) != 0) refuse_opening(path);
  refuse_what_is_no_file(path, status);
  const std::uint64_t size = static_cast<std::uint64_t>(status.st_size);
  if (size > max_bytes) refuse_size(path, max_bytes);
  LineLengths lengths(path);
  TextBuffer bytes;
  bytes.reserve(size + 1);  // one more, to meet the end within it
  for (;;) {
    context.cancel.throw_if_cancelled();
    if (bytes.size() == bytes.capacity())
      bytes.reserve(bytes.size() + kChunk);  // it grew meanwhile
    const std::size_t room = std::min(kChunk, bytes.capacity() - bytes.size());
    const ssize_t got = ::read(file.number(), bytes.data() + bytes.size(), room);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) refuse_errno(path, "reading stopped", "Check the disk or the network drive");
    if (got == 0) return bytes;
    bytes.set_size(bytes.size() + static_cast<std::size_t>(got));
    if (bytes.size() > max_bytes) refuse_size(path, max_bytes);
    if (!bytes.view().starts_with("\x1f\x8b")) lengths.look_at(bytes.view());
  }
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

void refuse_bomb(const std::filesystem::path& path, std::uint64_t unpacked, std::uint64_t packed) {
  if (unpacked <= kSuspiciousFrom || unpacked / kMostExpansion <= packed) return;
  throw ReadError(path, 0,
                  "the gzip data unpack to more than " + std::to_string(kMostExpansion) +
                      " times their size, which coordinates never do",
                  "If this is a molecule nevertheless, unpack the file and open that");
}

// All members of a gzip file, one after another, as gunzip does.
TextBuffer unpack(const std::filesystem::path& path, TextBuffer packed, std::uint64_t max_bytes,
                  const RunContext& context) {
  Inflater inflater;
  z_stream& stream = inflater.stream;
  LineLengths lengths(path);
  TextBuffer text;
  std::size_t used = 0;
  text.reserve(std::clamp<std::uint64_t>(packed.size() * 5, kChunk, max_bytes + 1));
  for (;;) {
    context.cancel.throw_if_cancelled();
    if (text.size() == text.capacity()) {
      if (text.size() > max_bytes) refuse_size(path, max_bytes);
      text.reserve(std::min<std::uint64_t>(text.capacity() * 2, max_bytes + 1));
    }
    stream.next_in = reinterpret_cast<Bytef*>(packed.data() + used);
    stream.avail_in = static_cast<uInt>(std::min<std::size_t>(packed.size() - used, 1u << 30));
    stream.next_out = reinterpret_cast<Bytef*>(text.data() + text.size());
    stream.avail_out = static_cast<uInt>(std::min(text.capacity() - text.size(), 8 * kChunk));
    const uInt in = stream.avail_in, out = stream.avail_out;
    const int code = inflate(&stream, Z_NO_FLUSH);
    used += in - stream.avail_in;
    text.set_size(text.size() + (out - stream.avail_out));
    lengths.look_at(text.view());
    refuse_bomb(path, text.size(), packed.size());
    if (code == Z_STREAM_END) {
      if (!packed.view().substr(used).starts_with("\x1f\x8b")) break;
      inflateReset(&stream);
    } else if (code != Z_OK) {
      refuse_gzip(path, code);
    } else if (used == packed.size() && stream.avail_out != 0) {
      refuse_gzip(path, Z_BUF_ERROR);
    }
  }
  if (text.size() > max_bytes) refuse_size(path, max_bytes);
  return text;
}

}  // namespace

LoadedText load_text(const std::filesystem::path& path, std::uint64_t max_bytes,
                     const RunContext& context) {
  max_bytes = std::min<std::uint64_t>(max_bytes, std::numeric_limits<std::int64_t>::max() / 4);
  LoadedText loaded;
  loaded.buffer = read_bytes(path, max_bytes, context);
  loaded.file_bytes = loaded.buffer.size();
  if (loaded.buffer.view().starts_with("\x1f\x8b")) {
    loaded.compressed = true;
    Sha256 hash;
    hash.update(loaded.buffer.view());
    loaded.sha256 = hash.finish();
    loaded.buffer = unpack(path, std::move(loaded.buffer), max_bytes, context);
  }
  loaded.text = loaded.buffer.view();
  loaded.byte_order_mark = loaded.text.starts_with(kByteOrderMark);
  if (loaded.byte_order_mark) loaded.text.remove_prefix(kByteOrderMark.size());
  // Lines of the oldest systems end with CR alone.
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
