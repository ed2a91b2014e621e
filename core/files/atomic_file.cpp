// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a temporary file beside the target, and gives it the target's name in one step.
#include "core/files/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>
#include <set>
#include <system_error>
#include <utility>

#include "core/files/temporary_names.hpp"
#include "core/run/child_program.hpp"
#include "core/run/uninterrupted_step.hpp"

namespace alphascope {

namespace fs = std::filesystem;

namespace {

// Names of temporary files, in a form that a signal handler can read. If all places are in use, a
// further file is still written, but a signal would leave its temporary file behind. Nothing is
// allocated here, because an allocation could fail when the file already exists.
enum PlaceState : int { kFree, kTaken, kNamed };
struct Place {
  std::atomic<int> state{kFree};
  std::array<char, PATH_MAX> name;
};
constexpr int kPlaces = 64;
Place places[kPlaces];
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler reads them");

int remember(const fs::path& path) {
  if (path.native().size() >= PATH_MAX) return -1;
  for (int k = 0; k < kPlaces; ++k) {
    int state = kFree;
    if (!places[k].state.compare_exchange_strong(state, kTaken)) continue;
    std::memcpy(places[k].name.data(), path.c_str(), path.native().size() + 1);
    places[k].state = kNamed;
    return k;
  }
  return -1;
}

void forget(int place) {
  if (place >= 0) places[place].state = kFree;
}

// Follows all links, also to a file that does not exist yet. Sets errno on failure.
bool follow_links(fs::path& path) {
  constexpr int kMostLinks = 40;  // the limit of Linux
  std::error_code error;
  for (int k = 0; k < kMostLinks; ++k) {
    if (!fs::is_symlink(path, error)) return true;
    const fs::path next = fs::read_symlink(path, error);
    if (error) break;
    path = path.parent_path() / next;  // only `next` if it is absolute
  }
  errno = error ? error.value() : ELOOP;
  return false;
}

// Waits until the file is on the disk; false with errno. A file system that cannot do this counts
// as success.
bool on_the_disk(int descriptor) {
  return ::fsync(descriptor) == 0 || errno == EINVAL || errno == ENOSYS || errno == ENOTSUP ||
         errno == EROFS;
}

// Waits until the new name is on the disk as well. A folder that cannot be opened is ignored.
void folder_on_the_disk(const fs::path& folder) noexcept {
  const char* const name = folder.empty() ? "." : folder.c_str();
  const int descriptor = ::open(name, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  static_cast<void>(::fsync(descriptor));
  ::close(descriptor);
}

bool exchange(const fs::path& a, const fs::path& b) {
  return ::renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0;
}

}  // namespace

void refuse_to_replace_input(const std::string& what, const fs::path& output, FileKind kind) {
  if (const auto input = input_replaced_by(output, kind)) {
    throw ReplacesInput(what + " would replace " + *input +
                        ", which is read. Give the output another name.");
  }
}

AtomicFile::AtomicFile(const fs::path& path, FileKind kind) : name_(path.string()), kind_(kind) {
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) {
    target_ = path;
    fail("open");
  }
  if (exists && S_ISDIR(status.st_mode)) {
    throw WriteError("Cannot write " + name_ + ": it is a folder. Give a file name.");
  }
  // Something other than a regular file, or a file without a name, cannot be replaced by a new
  // file, so it is written directly.
  if (exists && (!S_ISREG(status.st_mode) || status.st_nlink == 0)) {
    do {  // opening a pipe waits for its reader
      descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    } while (descriptor_ < 0 && errno == EINTR);
    if (descriptor_ < 0) fail("open");
    return;
  }
  refuse_to_replace_input("Writing " + name_, path, kind);
  target_ = path;
  if (!follow_links(target_)) fail("open");
  // Without this check a name that is too long would fail only at the rename.
  if (::lstat(target_.c_str(), &status) != 0 && errno != ENOENT) fail("open");
  // A rename would also replace a read-only file, so its permission is checked here.
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
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  if (descriptor_ >= 0) ::close(descriptor_);
  forget(slot_);
}

void AtomicFile::open_temporary() {
  remove_left_behind(target_.parent_path());
  constexpr int kAttempts = 10000;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    temporary_ = temporary_name(target_, attempt);
    const UninterruptedStep step;
    // The mode of any new file.
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ >= 0) {
      slot_ = remember(temporary_);
      mark_as_in_use(descriptor_);
      return;
    }
    if (errno != EEXIST) break;
  }
  temporary_.clear();
  fail("open");
}

void AtomicFile::keep_owner_and_mode() const {
  struct stat old {
  }, made{};
  if (::stat(target_.c_str(), &old) != 0 || ::fstat(descriptor_, &made) != 0) return;
  mode_t mode = old.st_mode & 0777;
  if (old.st_uid != made.st_uid || old.st_gid != made.st_gid) {
    // Only root can give a file away, but its owner can still change the group to one of their
    // groups.
    const bool group_kept = ::fchown(descriptor_, old.st_uid, old.st_gid) == 0 ||
                            ::fchown(descriptor_, static_cast<uid_t>(-1), old.st_gid) == 0;
    // If the group could not be kept, the new group gets only the rights that all users have.
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
  AtomicFile* const one = this;
  commit_together({&one, 1});
}

void AtomicFile::flush_to_disk() {
  if (temporary_.empty()) {
    if (::close(std::exchange(descriptor_, -1)) != 0) fail("write");
    return;
  }
  if (!on_the_disk(descriptor_)) fail("write");
  // Another part of the program may have read the target since this file was opened.
  refuse_to_replace_input("Writing " + name_, target_, kind_);
}

// Gives the file its name. When other files follow, one of which may fail, the old file is kept
// under the temporary name.
void AtomicFile::take_name(bool alone) {
  if (temporary_.empty()) return;
  struct stat status {};
  const bool replaces = !alone && ::lstat(target_.c_str(), &status) == 0 && S_ISREG(status.st_mode);
  if (replaces && exchange(temporary_, target_)) {
    taken_ = Taken::exchanged;
    return;
  }
  const bool kept = replaces && set_aside();
  if (std::rename(temporary_.c_str(), target_.c_str()) == 0) {
    taken_ = kept ? Taken::set_aside : alone || replaces ? Taken::alone : Taken::from_nobody;
    return;
  }
  const int error = errno;
  if (kept) ::unlink(old_.c_str());
  errno = error;
  fail("rename the new file to");
}

// Keeps the old file under a second name, for file systems that cannot exchange names, such as NFS.
// Where a file cannot have a second name either, a replaced file cannot be restored.
bool AtomicFile::set_aside() {
  constexpr int kAttempts = 10000;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    old_ = temporary_name(target_, attempt);
    if (::link(target_.c_str(), old_.c_str()) == 0) return true;
    if (errno != EEXIST) return false;
  }
  return false;
}

void AtomicFile::give_name_back() noexcept {
  if (taken_ == Taken::exchanged) {
    exchange(temporary_, target_);
  } else if (taken_ == Taken::from_nobody) {
    std::rename(target_.c_str(), temporary_.c_str());
  } else if (taken_ == Taken::set_aside) {
    std::rename(old_.c_str(), target_.c_str());
  }
  taken_ = Taken::no;  // the temporary file is removed afterwards
}

void AtomicFile::finish() noexcept {
  if (temporary_.empty()) return;
  if (taken_ == Taken::exchanged) ::unlink(temporary_.c_str());
  if (taken_ == Taken::set_aside) ::unlink(old_.c_str());
  temporary_.clear();
  ::close(std::exchange(descriptor_, -1));
  forget(std::exchange(slot_, -1));
}

void commit_together(std::span<AtomicFile* const> files) {
  for (AtomicFile* const file : files) file->flush_to_disk();
  std::set<fs::path> folders;
  for (AtomicFile* const file : files) {
    if (!file->temporary_.empty()) folders.insert(file->target_.parent_path());
  }
  {
    const UninterruptedStep step;
    try {
      for (AtomicFile* const file : files) file->take_name(files.size() == 1);
    } catch (...) {
      for (AtomicFile* const file : files) file->give_name_back();
      throw;
    }
    for (AtomicFile* const file : files) file->finish();
  }
  for (const fs::path& folder : folders) folder_on_the_disk(folder);
}

void AtomicFile::fail(const char* action) const {
  const int error = errno;
  const std::string what = std::string("Cannot ") + action + " " + name_ + ": ";
  // EBADF also stands for a descriptor that was closed when the program started: one that is not
  // open for writing.
  if (error == EBADF) throw WriteError(what + "it is closed.");
  const char* const remedy = target_.empty()         ? ""
                             : error == ENAMETOOLONG ? " Give it a shorter name."
                                                     : " Check the folder, its permissions and "
                                                       "free space.";
  throw WriteError(what + std::strerror(error) + "." + remedy);
}

void remove_temporary_files() noexcept {
  for (Place& place : places) {
    if (place.state.load() == kNamed) ::unlink(place.name.data());
  }
}

void end_all_writing() noexcept {
  end_uninterrupted_steps();
  kill_child_programs();
  remove_temporary_files();
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

std::string why_not_writable(const fs::path& path) {
  std::error_code ignored;
  const fs::path folder = path.parent_path();
  if (!fs::is_directory(folder, ignored)) return "There is no folder " + folder.string() + ".";
  if (fs::is_directory(path, ignored)) return path.string() + " is a folder.";
  const bool exists = fs::exists(path, ignored);
  if (exists && ::access(path.c_str(), W_OK) != 0) {
    return path.filename().string() + " is write-protected.";
  }
  // A device is written directly. For all else a new file is made where the links lead.
  if (exists && !fs::is_regular_file(path, ignored)) return {};
  const fs::path target = exists ? fs::canonical(path, ignored) : path;
  const fs::path made_in = target.empty() ? folder : target.parent_path();
  if (::access(made_in.c_str(), W_OK | X_OK) != 0) {
    return "You may not write in the folder " + made_in.string() + ".";
  }
  return {};
}

}  // namespace alphascope
