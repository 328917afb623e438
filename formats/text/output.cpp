#include "ar3d/formats/text/output.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "ar3d/model/error.h"

namespace ar3d {
namespace {

constexpr mode_t kNewFileMode = 0666;  // the umask takes away from it
constexpr int kTemporaryNames = 1000;

}  // namespace

OutputFile::OutputFile(std::string path) : path_(std::move(path)), target_(path_) {
  if (path_ == "-") {
    file_ = STDOUT_FILENO;
    return;
  }
  struct stat status {};
  const bool exists = ::stat(path_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) fail(EISDIR);
  if (exists && ::access(path_.c_str(), W_OK) != 0) fail(errno);
  if (exists && !S_ISREG(status.st_mode)) {
    file_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (file_ < 0) fail(errno);
    return;
  }
  std::error_code ignored;  // a link to nowhere, or a path that open_temporary() will refuse
  const std::filesystem::path real = std::filesystem::weakly_canonical(path_, ignored);
  if (!ignored) target_ = real.string();
  open_temporary();
  if (exists)
    (void)::fchmod(file_, status.st_mode & 07777);  // a file keeps its mode when it is replaced
}

/// A file without a name in the target's folder; false if there is no such thing.
bool OutputFile::open_nameless() {
  if (::access("/proc/self/fd", X_OK) != 0) return false;  // name_temporary needs it
  const std::string folder = std::filesystem::path(target_).parent_path().string();
  file_ =
      ::open(folder.empty() ? "." : folder.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, kNewFileMode);
  return file_ >= 0;
}

/// Gives the file without a name one beside the target.
void OutputFile::name_temporary() {
  const std::string self = fmt::format("/proc/self/fd/{}", file_);
  int error = EEXIST;
  for (int i = 0; i < kTemporaryNames && error == EEXIST; ++i) {
    const std::string name = fmt::format("{}.part-{}-{}", target_, ::getpid(), i);
    if (::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0) {
      temporary_ = name;
      nameless_ = false;
      return;
    }
    error = errno;
  }
  fail(error);
}

void OutputFile::open_temporary() {
  nameless_ = open_nameless();
  if (nameless_) return;
  int error = EEXIST;
  for (int i = 0; i < kTemporaryNames && error == EEXIST; ++i) {
    temporary_ = fmt::format("{}.part-{}-{}", target_, ::getpid(), i);
    file_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kNewFileMode);
    if (file_ >= 0) return;
    error = errno;
  }
  temporary_.clear();
  fail(error);
}

OutputFile::~OutputFile() {
  if (file_ > STDERR_FILENO) ::close(file_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void OutputFile::flush() {
  const char* from = pending_.data();
  std::size_t left = pending_.size();
  while (left > 0) {
    const ssize_t written = ::write(file_, from, left);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    from += written;
    left -= static_cast<std::size_t>(written);
  }
  pending_.clear();
}

void OutputFile::commit() {
  flush();
  if (file_ <= STDERR_FILENO) return;
  const bool regular = nameless_ || !temporary_.empty();
  if (regular && ::fsync(file_) != 0) fail(errno);
  if (nameless_) name_temporary();
  if (::close(std::exchange(file_, -1)) != 0) fail(errno);
  if (regular && std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
}

void OutputFile::fail(int error) const {
  throw InputError(fmt::format("cannot write {}: {}", path_ == "-" ? "standard output" : path_,
                               std::strerror(error)));
}

}  // namespace ar3d
