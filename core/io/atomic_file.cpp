#include "core/io/atomic_file.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

namespace alphascope {

namespace fs = std::filesystem;

AtomicFile::AtomicFile(const fs::path& path) : path_(path) {
  std::error_code ignored;
  if (fs::is_symlink(path_, ignored)) {
    const fs::path target = fs::weakly_canonical(path_, ignored);
    if (!ignored) path_ = target;
  }
  const fs::file_status status = fs::status(path_, ignored);
  if (fs::is_directory(status)) {
    throw WriteError("Cannot write " + path.string() + ": it is a folder. Give a file name.");
  }
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    file_ = std::fopen(path_.c_str(), "wb");
  } else {
    std::string pattern = path_.string() + ".XXXXXX";
    const int descriptor = ::mkstemp(pattern.data());
    if (descriptor >= 0) {
      temporary_ = pattern;
      // mkstemp gives 0600; the result should have what any new file has.
      const mode_t mask = ::umask(0);
      ::umask(mask);
      static_cast<void>(::fchmod(descriptor, 0666 & ~mask));
      file_ = ::fdopen(descriptor, "wb");
    }
  }
  if (!file_) fail("open");
}

AtomicFile::~AtomicFile() {
  if (file_) std::fclose(file_);
  if (!temporary_.empty()) {
    std::error_code ignored;
    fs::remove(temporary_, ignored);
  }
}

void AtomicFile::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail("write");
}

void AtomicFile::commit() {
  if (std::fflush(file_) != 0) fail("write");
  std::FILE* file = std::exchange(file_, nullptr);
  if (std::fclose(file) != 0) fail("write");
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail("rename the new file to");
  temporary_.clear();
}

void AtomicFile::fail(const char* action) const {
  throw WriteError(std::string("Cannot ") + action + " " + path_.string() + ": " +
                   std::strerror(errno) + ". Check the folder, its permissions and free space.");
}

}  // namespace alphascope
