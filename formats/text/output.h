#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "ar3d/base/new_file.h"

namespace ar3d {

/// A file being written. A regular file appears under its name only when commit() has succeeded
/// (base/new_file.h). "-" is standard output; devices and pipes are written directly.
class OutputFile {
 public:
  /// @throws InputError if the file cannot be written (directory, no permission, no such folder).
  explicit OutputFile(std::string path);

  void append(std::string_view text) {
    pending_.append(text);
    flush_if_full();
  }
  /// The text not yet passed on, for writers that format into it; call flush_if_full() now and
  /// then.
  std::string& pending() { return pending_; }
  /// @throws InputError if the text cannot be written (full disk, closed pipe).
  void flush_if_full() {
    if (pending_.size() >= kBlock) flush();
  }
  /// Passes on all text so far. @throws InputError as above.
  void flush();
  /// Writes everything and gives the file its name. @throws InputError if it cannot; the old file
  /// then stays.
  void commit();

 private:
  static constexpr std::size_t kBlock = std::size_t{1} << 16;

  std::string path_;  // for messages
  std::optional<NewFile> regular_;
  Descriptor device_;
  std::string pending_;
  int file_ = -1;
};

/// Appends texts and characters as they are and integers in decimal; faster than a format string
/// where millions are written.
template <class... Parts>
void append_all(std::string& out, const Parts&... parts) {
  const auto append = [&out](const auto& part) {
    using Part = std::decay_t<decltype(part)>;
    if constexpr (std::is_integral_v<Part> && !std::is_same_v<Part, char>) {
      const fmt::format_int text(part);
      out.append(text.data(), text.size());
    } else {
      out += part;
    }
  };
  (append(parts), ...);
}

}  // namespace ar3d
