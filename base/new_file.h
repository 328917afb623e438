#pragma once

#include <unistd.h>

#include <span>
#include <string>
#include <utility>

namespace ar3d {

/// Owns a file descriptor; -1 is none.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int get() const { return number_; }
  /// Returns the descriptor, which is the caller's from now on.
  int release() { return std::exchange(number_, -1); }

 private:
  int number_;
};

/// Represents a file that appears under its name whole, or not at all. Until then its bytes are in
/// a file without a name (O_TMPFILE), of which an interrupted or killed program leaves nothing;
/// where a file system has none, in one beside the target, which the destructor removes.
class NewFile {
 public:
  /// Makes a file for `path`; a symbolic link is followed. What exists keeps its mode.
  /// @throws InputError naming the path and the system's reason: no such directory, no permission,
  /// a directory, no regular file.
  explicit NewFile(const std::string& path);
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  int descriptor() const { return descriptor_.get(); }
  /// @throws InputError naming the path and the system's reason (no space left, …).
  void write_all(std::span<const char> bytes);
  /// Replaces what exists: fsync, rename, fsync of the directory. @throws InputError as write_all.
  void become_target();
  /// Works as become_target, but what exists is left alone. @return false if it exists.
  bool become_new_target();

 private:
  bool open_nameless();
  void take_name();
  void close_checked();

  std::string path_;    // as given, for messages
  std::string target_;  // where links lead
  std::string name_;    // of the file beside the target; empty: it has none
  Descriptor descriptor_;
};

/// Replaces the file at `path` by `bytes`, or leaves everything as it was.
/// @throws InputError as NewFile.
void write_file_atomically(const std::string& path, std::span<const char> bytes);

/// Creates the file at `path` whole, or not at all: as above, but what exists is left alone.
/// @return false if it exists.  @throws InputError as NewFile.
bool create_file_atomically(const std::string& path, std::span<const char> bytes);

/// Fails now instead of after hours: tries to create (and removes) a file beside `path`.
/// @throws InputError as NewFile.
void require_writable(const std::string& path);

/// Gives a new file in the folder for temporary files ($TMPDIR, else /tmp), open to read and write,
/// whose name cannot be known before. @param path  becomes its name, which begins with `beginning`.
/// @throws InputError naming it if there can be no such file.
Descriptor new_temporary_file(const std::string& beginning, std::string& path);

/// Returns a new folder there. @return its path. @throws InputError as new_temporary_file.
std::string new_temporary_folder(const std::string& beginning);

/// Removes a folder and all in it, as far as that is possible: for the end of a scope.
void remove_folder(const std::string& path) noexcept;

/// Opens a file to read it: -1 and errno where that cannot be. A FIFO has no end yet, and who opens
/// it may wait for ever. @throws InputError naming it, unless it stands in /dev (/dev/stdin, a
/// shell's `<(…)`).
Descriptor open_input(const std::string& path);

/// Returns all bytes of a file. @throws InputError as open_input, and naming the system's reason.
std::string read_file(const std::string& path);

/// Writes all bytes to an open file. @throws InputError naming the path and the system's reason.
void write_all(int descriptor, std::span<const char> bytes, const std::string& path);

/// @throws InputError that the path cannot be written, or read, for the reason errno.
[[noreturn]] void refuse_writing(const std::string& path, int reason);
[[noreturn]] void refuse_reading(const std::string& path, int reason);

/// Returns a name beside `target` that no other process uses, be it in another container or on
/// another machine. @throws InputError if the system has no random number.
std::string name_of_new_file(const std::string& target);

/// Removes what killed processes left of new files that were to stand at `path`: files beside it
/// named as name_of_new_file() does that no NewFile has open. Others of like names stay.
void remove_leftovers(const std::string& path);

/// Gives the file `name` the name `target`, whole and at once, unless something has that name
/// already; `name` is gone afterwards in either case. By a hard link; on file systems without them
/// by a rename that replaces nothing; where that is unknown, too, by looking and then renaming.
/// @return false if something has the name. @throws InputError naming the target.
bool give_name_if_free(const std::string& name, const std::string& target);

}  // namespace ar3d
