// A regular file is written under another name and takes its own when it is whole; devices and
// pipes directly.
#include "ar3d/formats/text/output.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>

namespace ar3d {

OutputFile::OutputFile(std::string path) : path_(std::move(path)) {
  if (path_ == "-") {
    path_ = "standard output";
    file_ = STDOUT_FILENO;
    return;
  }
  struct stat status {};
  const bool exists = ::stat(path_.c_str(), &status) == 0;
  if (exists && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)) {
    device_ = Descriptor(::open(path_.c_str(), O_WRONLY | O_CLOEXEC));
    if (device_.get() < 0) refuse_writing(path_, errno);
    file_ = device_.get();
    return;
  }
  regular_.emplace(path_);
  file_ = regular_->descriptor();
}

void OutputFile::flush() {
  write_all(file_, pending_, path_);
  pending_.clear();
}

void OutputFile::commit() {
  flush();
  if (regular_) regular_->become_target();
  if (device_.get() >= 0 && ::close(device_.release()) != 0) refuse_writing(path_, errno);
}

}  // namespace ar3d
