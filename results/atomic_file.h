#pragma once

#include <span>
#include <string>

#include "ar3d/results/descriptor.h"

namespace ar3d {

/// A new file beside the one that it is to become; it disappears unless it becomes that.
class NewFile {
 public:
  /// @throws InputError as write_file_atomically.
  explicit NewFile(const std::string& target);
  /// To become the file at `path`, as write_file_atomically. @throws InputError
  static NewFile to_replace(const std::string& path);
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  int descriptor() const { return descriptor_.get(); }
  /// @throws InputError naming the target and the system's reason.
  void write_all(std::span<const char> bytes);
  /// fsync, rename, fsync of the directory. @throws InputError as write_all.
  void become_target();
  /// As become_target, but what exists is left alone. @return false if it exists.
  bool become_new_target();

 private:
  std::string target_;
  std::string name_;
  Descriptor descriptor_;
  bool renamed_ = false;
};

/// A name beside `target` that no other process uses, be it in another container or on another
/// machine. @throws InputError if the system has no random number.
std::string name_of_new_file(const std::string& target);

/// Gives the file `name` the name `target`, whole and at once, unless something has that name
/// already; `name` is gone afterwards in either case. By a hard link; on file systems without them
/// by a rename that replaces nothing; where that is unknown, too, by looking and then renaming.
/// @return false if something has the name. @throws InputError naming the target.
bool give_name_if_free(const std::string& name, const std::string& target);

/// Replaces the file at `path` by `bytes`, or leaves everything as it was: writes a new file beside
/// it, fsync, rename, fsync of the directory. A symbolic link is followed; what exists and is no
/// regular file is refused.
/// @throws InputError naming the path and the system's reason (no such directory, no space left,
/// …).
void write_file_atomically(const std::string& path, std::span<const char> bytes);

/// Creates the file at `path` whole, or not at all: as above, but what exists is left alone.
/// @return false if it exists.  @throws InputError as write_file_atomically.
bool create_file_atomically(const std::string& path, std::span<const char> bytes);

/// Fails now instead of after hours: tries to create (and removes) a file beside `path`.
/// @throws InputError as write_file_atomically.
void require_writable(const std::string& path);

}  // namespace ar3d
