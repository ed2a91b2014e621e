#include "core/io/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <utility>

namespace alphascope {

namespace fs = std::filesystem;

namespace {

// Names of temporary files, as a signal handler can read them. A file beyond the last place is
// written all the same; only a signal would leave its temporary file behind.
constexpr int kPlaces = 64;
std::atomic<char*> temporary_names[kPlaces];
static_assert(std::atomic<char*>::is_always_lock_free, "a signal handler reads them");

int remember(const fs::path& path) {
  char* const name = ::strdup(path.c_str());
  for (int place = 0; name != nullptr && place < kPlaces; ++place) {
    char* empty = nullptr;
    if (temporary_names[place].compare_exchange_strong(empty, name)) return place;
  }
  std::free(name);
  return -1;
}

void forget(int place) {
  if (place >= 0) std::free(temporary_names[place].exchange(nullptr));
}

// Behind all links, also where the last one leads to nothing yet. Sets errno when that fails.
bool follow_links(fs::path& path) {
  constexpr int kMostLinks = 40;  // as Linux has it
  std::error_code error;
  for (int k = 0; k < kMostLinks; ++k) {
    if (!fs::is_symlink(path, error)) return true;
    const fs::path next = fs::read_symlink(path, error);
    if (error) break;
    path = path.parent_path() / next;  // `next` alone when it is absolute
  }
  errno = error ? error.value() : ELOOP;
  return false;
}

// In the folder of `target`, and short, since the name of `target` may be as long as can be.
fs::path temporary_name(const fs::path& target, int attempt) {
  return target.parent_path() /
         (".alphascope-" + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".tmp");
}

}  // namespace

AtomicFile::AtomicFile(const fs::path& path) : name_(path.string()) {
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) {
    throw WriteError("Cannot write " + name_ + ": it is a folder. Give a file name.");
  }
  // No new file can take the place of one that has no name (any more).
  if (exists && (!S_ISREG(status.st_mode) || status.st_nlink == 0)) {
    do {  // a pipe waits for its reader
      descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    } while (descriptor_ < 0 && errno == EINTR);
    if (descriptor_ < 0) fail("open");
    return;
  }
  target_ = path;
  if (!follow_links(target_)) fail("open");
  // Renaming would replace a file that its owner has made read-only.
  if (exists && ::access(target_.c_str(), W_OK) != 0) fail("write");
  open_temporary();
  if (exists) keep_owner_and_mode();
}

AtomicFile::AtomicFile(int descriptor, const std::string& name)
    : name_(name), descriptor_(::fcntl(descriptor, F_DUPFD_CLOEXEC, 3)) {
  if (descriptor_ < 0) fail("write");
  if ((::fcntl(descriptor_, F_GETFL) & O_ACCMODE) == O_RDONLY) {
    ::close(descriptor_);
    errno = EBADF;
    fail("write");
  }
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  forget(slot_);
}

void AtomicFile::open_temporary() {
  constexpr int kAttempts = 10000;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const fs::path name = temporary_name(target_, attempt);
    // The mode that any new file gets.
    descriptor_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ >= 0) {
      temporary_ = name;
      slot_ = remember(name);
      return;
    }
    if (errno != EEXIST) break;
  }
  fail("open");
}

void AtomicFile::keep_owner_and_mode() const {
  struct stat old {
  }, made{};
  if (::stat(target_.c_str(), &old) != 0 || ::fstat(descriptor_, &made) != 0) return;
  mode_t mode = old.st_mode & 0777;
  if (old.st_uid != made.st_uid || old.st_gid != made.st_gid) {
    // Only root gives a file away; its owner may still change the group to one of theirs.
    const bool group_kept = ::fchown(descriptor_, old.st_uid, old.st_gid) == 0 ||
                            ::fchown(descriptor_, static_cast<uid_t>(-1), old.st_gid) == 0;
    // Another group must not read what the old one's members alone could.
    if (!group_kept) mode &= ~mode_t{070} | ((mode & 07) << 3);
  }
  static_cast<void>(::fchmod(descriptor_, mode));
}

void AtomicFile::write(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor_, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("write");
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void AtomicFile::commit() {
  const int descriptor = std::exchange(descriptor_, -1);
  if (::close(descriptor) != 0) fail("write");
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail("rename the new file to");
  temporary_.clear();
  forget(std::exchange(slot_, -1));
}

void AtomicFile::fail(const char* action) const {
  const std::string what = std::string("Cannot ") + action + " " + name_ + ": ";
  // A descriptor that is not open for writing stands in for one that was closed at the start.
  if (errno == EBADF) throw WriteError(what + "it is closed.");
  throw WriteError(what + std::strerror(errno) + "." +
                   (target_.empty() ? "" : " Check the folder, its permissions and free space."));
}

void remove_temporary_files() noexcept {
  for (std::atomic<char*>& place : temporary_names) {
    if (const char* const name = place.load()) ::unlink(name);
  }
}

void make_output_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && ::access(folder.c_str(), W_OK | X_OK) != 0) {
    error.assign(errno, std::generic_category());
  }
  if (error) {
    throw WriteError("Cannot make the folder " + folder.string() + ": " + error.message() + ".");
  }
}

}  // namespace alphascope
