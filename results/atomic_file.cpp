#include "ar3d/results/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "ar3d/model/error.h"

namespace ar3d {
namespace {

[[noreturn]] void refuse(const std::string& path, int reason) {
  throw InputError(fmt::format("cannot write {}: {}", path, std::strerror(reason)));
}

// A file that disappears unless it is renamed to its final name.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& target)
      : target_(target), name_(fmt::format("{}.partial-{}", target, getpid())) {
    descriptor_ = open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0) refuse(target_, errno);
  }
  ~TemporaryFile() {
    if (descriptor_ >= 0) close(descriptor_);
    if (!renamed_) unlink(name_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write_all(std::span<const char> bytes) {
    while (!bytes.empty()) {
      const ssize_t written = write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) refuse(target_, errno);
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
  }

  void become_target() {
    finish();
    if (std::rename(name_.c_str(), target_.c_str()) != 0) refuse(target_, errno);
    renamed_ = true;
    sync_directory();
  }

  // False if the target exists.
  bool become_new_target() {
    finish();
    if (link(name_.c_str(), target_.c_str()) != 0) {
      if (errno != EEXIST) refuse(target_, errno);
      return false;
    }
    sync_directory();
    return true;
  }

 private:
  void finish() {
    if (fsync(descriptor_) != 0) refuse(target_, errno);
    if (close(std::exchange(descriptor_, -1)) != 0) refuse(target_, errno);
  }

  // Makes the new name durable. Some file systems cannot sync a directory; the file itself is safe
  // then.
  void sync_directory() const {
    const std::string parent = std::filesystem::path(target_).parent_path().string();
    const int directory =
        open(parent.empty() ? "." : parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (directory < 0) return;
    fsync(directory);
    close(directory);
  }

  std::string target_;
  std::string name_;
  int descriptor_ = -1;
  bool renamed_ = false;
};

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

}  // namespace

void write_file_atomically(const std::string& path, std::span<const char> bytes) {
  TemporaryFile file(checked_target(path));
  file.write_all(bytes);
  file.become_target();
}

bool create_file_atomically(const std::string& path, std::span<const char> bytes) {
  TemporaryFile file(path);
  file.write_all(bytes);
  return file.become_new_target();
}

void require_writable(const std::string& path) { const TemporaryFile probe(checked_target(path)); }

}  // namespace ar3d
