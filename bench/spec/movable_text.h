#pragma once

#include <string>

#include "ar3d/bench/spec/study_spec.h"

namespace ar3d {

/// The text of the specification, to be kept in another folder: the paths of `graphs` are absolute.
/// A study without graphs of files keeps its text byte for byte.
std::string movable_text(const StudySpec& spec);

}  // namespace ar3d
