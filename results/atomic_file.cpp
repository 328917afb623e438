#include "ar3d/results/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/random.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "ar3d/model/error.h"

namespace ar3d {
namespace {

[[noreturn]] void refuse(const std::string& path, int reason) {
  throw InputError(fmt::format("cannot write {}: {}", path, std::strerror(reason)));
}

// The path to replace: behind symbolic links, and absent or a regular file.
std::string checked_target(const std::string& path) {
  std::error_code error;
  if (path.empty()) refuse("''", ENOENT);
  const auto status = std::filesystem::status(path, error);
  if (std::filesystem::is_directory(status)) refuse(path, EISDIR);
  if (!std::filesystem::exists(status)) return path;
  if (!std::filesystem::is_regular_file(status)) {
    throw InputError(fmt::format("cannot write {}: it is not a regular file", path));
  }
  const auto resolved = std::filesystem::canonical(path, error);
  if (error) refuse(path, error.value());
  return resolved.string();
}

// Makes the new name durable. Some file systems cannot sync a directory; the file itself is safe
// then.
void sync_directory(const std::string& target) {
  const std::string parent = std::filesystem::path(target).parent_path().string();
  const Descriptor directory(
      open(parent.empty() ? "." : parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.get() >= 0) fsync(directory.get());
}

}  // namespace

NewFile::NewFile(const std::string& target) : target_(target), name_(name_of_new_file(target)) {
  descriptor_ = Descriptor(open(name_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (descriptor_.get() < 0) refuse(target_, errno);
}

NewFile::~NewFile() {
  if (!renamed_) unlink(name_.c_str());
}

NewFile NewFile::to_replace(const std::string& path) { return NewFile(checked_target(path)); }

void NewFile::write_all(std::span<const char> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor_.get(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) refuse(target_, errno);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void NewFile::become_target() {
  if (fsync(descriptor_.get()) != 0) refuse(target_, errno);
  if (std::rename(name_.c_str(), target_.c_str()) != 0) refuse(target_, errno);
  renamed_ = true;
  sync_directory(target_);
}

bool NewFile::become_new_target() {
  if (fsync(descriptor_.get()) != 0) refuse(target_, errno);
  return give_name_if_free(name_, target_);
}

std::string name_of_new_file(const std::string& target) {
  std::uint64_t number = 0;  // process ids alone are the same in every container
  if (getrandom(&number, sizeof(number), 0) != sizeof(number)) refuse(target, errno);
  return fmt::format("{}.partial-{}-{:016x}", target, getpid(), number);
}

bool give_name_if_free(const std::string& name, const std::string& target) {
  const auto failed = [&] {
    const int reason = errno;
    unlink(name.c_str());
    if (reason != EEXIST) refuse(target, reason);
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
  NewFile file = NewFile::to_replace(path);
  file.write_all(bytes);
  file.become_target();
}

bool create_file_atomically(const std::string& path, std::span<const char> bytes) {
  NewFile file(path);
  file.write_all(bytes);
  return file.become_new_target();
}

void require_writable(const std::string& path) { const NewFile probe = NewFile::to_replace(path); }

}  // namespace ar3d
