#pragma once

#include <string>

#include "ar3d/bench/external/external_algorithm.h"

namespace ar3d {

/// The hash of a program whose executable cannot be read.
inline constexpr const char* kAbsentProgram = "absent";

/// XXH3-128 of what the program is made of, as far as its command shows: the contents of the
/// executable (a path, or looked up in $PATH) and of every further word that names a regular file,
/// such as a script. kAbsentProgram if the executable cannot be read. Cost: reading these files.
std::string program_hash(const ExternalAlgorithm& program);

}  // namespace ar3d
