#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "ar3d/base/long_vector.h"

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

/// A text file read line by line from large blocks; knows where it stands for messages.
/// Memory: one block plus the longest line.
class TextInput {
 public:
  /// @throws InputError if the file cannot be opened ("-" is standard input; gzip and xz are
  /// unpacked).
  explicit TextInput(const std::string& path) : TextInput(display_name(path), open_bytes(path)) {}
  TextInput(std::string name, std::unique_ptr<ByteSource> bytes);

  /// The next line without its end ("\n" or "\r\n"), valid until the next call; nothing at the end.
  std::optional<std::string_view> next_line();
  /// The line just given will be given again.
  void put_back();

  /// The whole lines, ends included, that have been read from the source and not given yet, for
  /// reading many at once; valid until the next call. 8 bytes behind them can be read.
  std::string_view whole_lines() const {
    return {buffer_.data() + next_, whole_end_ > next_ ? whole_end_ - next_ : 0};
  }
  /// Gives the first `bytes` bytes of whole_lines(), which are `lines` lines.
  void take(std::size_t bytes, std::uint64_t lines);

  /// The text not yet given, as far as it can be had: at least its first line, or up to `wanted`
  /// bytes of it.
  std::string_view look_ahead(std::size_t wanted);
  std::string_view look_ahead_line();
  /// All the text not yet given, which counts as one line.
  std::string take_all();
  /// True if look_ahead() showed the text to its very end.
  bool sees_end() const { return at_end_; }

  const std::string& name() const { return name_; }
  std::uint64_t line() const { return line_; }  ///< number of the line just given, from 1
  /// Bytes of text given so far, ends of lines included.
  std::uint64_t bytes() const { return dropped_ + next_; }
  /// Bytes of text not given yet, as far as they are known; it may be wrong.
  std::uint64_t bytes_left() const { return bytes_->bytes_left() + (end_ - next_); }

  /// Throws InputError "NAME:LINE:COLUMN: message" for the line just given; column 0 is left out.
  [[noreturn]] void fail(std::size_t column, const std::string& message) const;
  /// The same for what stands behind that beginning of the text.
  [[noreturn]] void fail_behind(std::string_view before, const std::string& message) const;
  /// The same for an earlier line.
  [[noreturn]] void fail_at(std::uint64_t line, std::size_t column,
                            const std::string& message) const;

 private:
  bool read_block();  // appends to the buffer; false at the end
  std::size_t room() const;
  void make_room(std::size_t bytes);

  std::string name_;
  std::unique_ptr<ByteSource> bytes_;
  UnwrittenVector<char> buffer_;
  std::size_t begin_ = 0;      // of the line just given
  std::size_t next_ = 0;       // of the line to give next
  std::size_t end_ = 0;        // of the text in the buffer
  std::size_t whole_end_ = 0;  // behind the last end of a line in it
  std::uint64_t dropped_ = 0;
  std::uint64_t line_ = 0;
  bool at_end_ = false;
};

/// A piece of input as messages show it: in quotes, unprintable bytes escaped, long ones cut.
std::string shown(std::string_view text);

}  // namespace ar3d
