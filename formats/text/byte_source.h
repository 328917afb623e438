#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace ar3d {

/// Bytes of a file, read in blocks.
class ByteSource {
 public:
  ByteSource() = default;
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;
  virtual ~ByteSource() = default;
  /// Reads up to `size` >= 1 bytes to `to`; 0 only at the end. A pipe gives what it has.
  /// @throws InputError if the file cannot be read or its compressed data are corrupt or cut.
  virtual std::size_t read(char* to, std::size_t size) = 0;
  /// Returns how many bytes are left if that is known beforehand, else 0. May be wrong.
  virtual std::uint64_t bytes_left() const { return 0; }
};

/// The file at `path` ("-": standard input), decompressed if it begins like gzip or xz.
/// @throws InputError if it cannot be opened.
std::unique_ptr<ByteSource> open_bytes(const std::string& path);

/// The bytes without a mark at their beginning. A mark of UTF-16 makes UTF-8 of them, which is then
/// held in memory. Waits for the first three bytes. @throws InputError "NAME: …" if it is none.
std::unique_ptr<ByteSource> without_mark(std::unique_ptr<ByteSource> bytes,
                                         const std::string& name);

/// Bytes in memory.
std::unique_ptr<ByteSource> bytes_of(std::string text);

/// The path as messages name it: itself, or "<stdin>" for "-".
std::string display_name(const std::string& path);

}  // namespace ar3d
