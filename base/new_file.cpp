// Files appear whole or not at all. The bytes go into a file without a name, which vanishes with a
// killed process; only when all are on the disk does it get its name. Where a file system has no
// nameless files, a locked temporary name beside the target does the same.
#include "ar3d/base/new_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/random.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <regex>

#include "ar3d/base/error.h"
#include "ar3d/base/system_calls.h"

namespace ar3d {
namespace {

constexpr mode_t kMode = 0666;  // the umask takes away from it

std::string folder_of(const std::string& target) {
  const std::string folder = std::filesystem::path(target).parent_path().string();
  return folder.empty() ? "." : folder;
}

// Makes a new name durable. Some file systems cannot sync a directory; the file itself is safe
// then.
void sync_directory(const std::string& target) {
  const Descriptor directory(open(folder_of(target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.get() >= 0) fsync(directory.get());
}

/// For as long as the open file is: by this no other process takes it for a leftover. Where locks
/// are unknown no process has them, and nothing is ever removed.
bool lock(int descriptor) {
  struct flock whole {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  return fcntl(descriptor, F_OFD_SETLK, &whole) == 0;
}

std::string temporary_name(const std::string& beginning) {
  const char* folder = std::getenv("TMPDIR");
  return fmt::format("{}/{}-XXXXXX", folder == nullptr || *folder == '\0' ? "/tmp" : folder,
                     beginning);
}

[[noreturn]] void refuse_temporary(const std::string& path) {
  throw InputError(
      fmt::format("cannot create {} (TMPDIR says where): {}", path, std::strerror(errno)));
}

}  // namespace

void refuse_writing(const std::string& path, int reason) {
  throw InputError(
      fmt::format("cannot write {}: {}", path.empty() ? "''" : path, std::strerror(reason)));
}

void refuse_reading(const std::string& path, int reason) {
  throw InputError(fmt::format("cannot read {}: {}", path, std::strerror(reason)));
}

void write_all(int descriptor, std::span<const char> bytes, const std::string& path) {
  if (write_whole(descriptor, bytes) < bytes.size()) refuse_writing(path, errno);
}

NewFile::NewFile(const std::string& path) : path_(path), target_(path) {
  if (path.empty()) refuse_writing(path, ENOENT);
  struct stat status {};
  const bool exists = stat(path.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) refuse_writing(path, EISDIR);
  if (exists && !S_ISREG(status.st_mode)) {
    throw InputError(fmt::format("cannot write {}: it is not a regular file", path));
  }
  if (exists && access(path.c_str(), W_OK) != 0) refuse_writing(path, errno);
  if (!exists && lstat(path.c_str(), &status) == 0) {
    throw InputError(fmt::format("cannot write {}: it is a symbolic link to nothing", path));
  }
  std::error_code error;  // a path that opening will refuse
  const std::filesystem::path real = std::filesystem::weakly_canonical(path, error);
  if (!error) target_ = real.string();
  if (!open_nameless()) {
    name_ = name_of_new_file(target_);
    descriptor_ = Descriptor(open(name_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, kMode));
    if (descriptor_.get() < 0) refuse_writing(path_, errno);
  }
  lock(descriptor_.get());
  if (exists) (void)fchmod(descriptor_.get(), status.st_mode & 07777);
}

NewFile::~NewFile() {
  if (!name_.empty()) unlink(name_.c_str());
}

/// A file without a name in the target's folder; false if there is no such thing.
bool NewFile::open_nameless() {
  if (access("/proc/self/fd", X_OK) != 0) return false;  // take_name needs it
  descriptor_ = Descriptor(open(folder_of(target_).c_str(), O_RDWR | O_TMPFILE | O_CLOEXEC, kMode));
  return descriptor_.get() >= 0;
}

/// Gives the file without a name one beside the target.
void NewFile::take_name() {
  const std::string self = fmt::format("/proc/self/fd/{}", descriptor_.get());
  const std::string name = name_of_new_file(target_);
  if (linkat(AT_FDCWD, self.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) != 0) {
    refuse_writing(path_, errno);
  }
  name_ = name;
}

void NewFile::write_all(std::span<const char> bytes) {
  ar3d::write_all(descriptor_.get(), bytes, path_);
}

/// Some file systems tell of a full disk on closing only. The lock stays until the file has its
/// name.
void NewFile::close_checked() {
  const int again = dup(descriptor_.get());
  if (again < 0 || close(again) != 0) refuse_writing(path_, errno);
}

void NewFile::become_target() {
  if (fsync(descriptor_.get()) != 0) refuse_writing(path_, errno);
  if (name_.empty()) take_name();
  close_checked();
  if (std::rename(name_.c_str(), target_.c_str()) != 0) refuse_writing(path_, errno);
  name_.clear();
  sync_directory(target_);
}

bool NewFile::become_new_target() {
  if (fsync(descriptor_.get()) != 0) refuse_writing(path_, errno);
  if (name_.empty()) take_name();
  close_checked();
  return give_name_if_free(std::exchange(name_, {}), target_);
}

Descriptor open_input(const std::string& path) {
  struct stat status {};
  if (!path.starts_with("/dev/") && stat(path.c_str(), &status) == 0 && S_ISFIFO(status.st_mode)) {
    throw InputError(fmt::format("cannot read {}: it is a FIFO", path));
  }
  return Descriptor(open(path.c_str(), O_RDONLY | O_CLOEXEC));
}

std::string read_file(const std::string& path) {
  const Descriptor file = open_input(path);
  std::string text, bytes(1 << 16, ' ');
  ssize_t got = file.get() < 0 ? -1 : 1;
  while (got > 0) {
    while ((got = read(file.get(), bytes.data(), bytes.size())) < 0 && errno == EINTR) continue;
    if (got > 0) text.append(bytes, 0, static_cast<std::size_t>(got));
  }
  if (got < 0) refuse_reading(path, errno);
  return text;
}

Descriptor new_temporary_file(const std::string& beginning, std::string& path) {
  path = temporary_name(beginning);
  Descriptor file(mkostemp(path.data(), O_CLOEXEC));
  if (file.get() < 0) refuse_temporary(path);
  return file;
}

std::string new_temporary_folder(const std::string& beginning) {
  std::string path = temporary_name(beginning);
  if (mkdtemp(path.data()) == nullptr) refuse_temporary(path);
  return path;
}

void remove_folder(const std::string& path) noexcept {
  std::error_code ignored;
  std::filesystem::remove_all(path, ignored);
}

std::string name_of_new_file(const std::string& target) {
  std::uint64_t number = 0;  // process ids alone are the same in every container
  if (getrandom(&number, sizeof(number), 0) != sizeof(number)) refuse_writing(target, errno);
  return fmt::format("{}.partial-{}-{:016x}", target, getpid(), number);
}

void remove_leftovers(const std::string& path) {
  std::error_code error;
  const std::filesystem::path target = std::filesystem::weakly_canonical(path, error);
  if (error) return;
  static const std::regex made("(\\.partial-[0-9]+-[0-9a-f]{16})+");
  const std::string name = target.filename().string();
  for (std::filesystem::directory_iterator at(folder_of(target.string()), error), end;
       !error && at != end; at.increment(error)) {
    const std::string other = at->path().filename().string();
    if (!other.starts_with(name) || !std::regex_match(other.substr(name.size()), made)) continue;
    const Descriptor file(open(at->path().c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat status {};
    const bool is_file = fstat(file.get(), &status) == 0 && S_ISREG(status.st_mode);
    const bool is_target =
        has_its_name(file.get(), target);  // its second name, which may be locked
    if (is_file && (is_target || lock(file.get()))) unlink(at->path().c_str());
  }
}

bool give_name_if_free(const std::string& name, const std::string& target) {
  const auto failed = [&] {
    const int reason = errno;
    unlink(name.c_str());
    if (reason != EEXIST) refuse_writing(target, reason);
    return false;
  };
  if (link(name.c_str(), target.c_str()) == 0) {
    unlink(name.c_str());
  } else if (errno == EEXIST) {
    return failed();
  } else if (renameat2(AT_FDCWD, name.c_str(), AT_FDCWD, target.c_str(), RENAME_NOREPLACE) != 0) {
    if (errno == EEXIST) return failed();
    // Neither hard links nor that rename: what is left has a gap between looking and renaming.
    if (access(target.c_str(), F_OK) == 0) {
      errno = EEXIST;
      return failed();
    }
    if (std::rename(name.c_str(), target.c_str()) != 0) return failed();
  }
  sync_directory(target);
  return true;
}

void write_file_atomically(const std::string& path, std::span<const char> bytes) {
  NewFile file(path);
  file.write_all(bytes);
  file.become_target();
}

bool create_file_atomically(const std::string& path, std::span<const char> bytes) {
  NewFile file(path);
  file.write_all(bytes);
  return file.become_new_target();
}

void require_writable(const std::string& path) { const NewFile probe(path); }

}  // namespace ar3d
