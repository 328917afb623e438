#pragma once

#include <string>

namespace ar3d {

/// A results file ends with 40 bytes behind the end of its HDF5 part, which HDF5 does not look at:
/// "ar3d-checksum 1\n", the number of bytes before (8 bytes, little endian) and the XXH3-128 hash
/// of everything up to there (canonical: big endian).
inline constexpr std::size_t kChecksumSize = 40;

/// Appends it to an open file that is otherwise complete. @return 0, or the errno of what failed.
int append_checksum(int descriptor);

/// Reads the whole file. @return true if its checksum is right; false if another program has opened it
/// for writing, which cuts the checksum off, or has it open. @throws InputError naming `path` if it
/// cannot be read or its checksum is a wrong one.
bool has_checksum(int descriptor, const std::string& path);

}  // namespace ar3d
