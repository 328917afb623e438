#pragma once

#include <span>
#include <string>

namespace ar3d {

/// Replaces the file at `path` by `bytes`, or leaves everything as it was (base/new_file.h).
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
