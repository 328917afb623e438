#pragma once

#include <toml++/toml.h>

#include <string>

#include "ar3d/bench/spec/study_spec.h"

namespace ar3d {

/// Refuses a sweep with strong or weak batches of what has none: programs, levels that store, and
/// more than one certificate. @param node  the sweep, in `file`.
/// @throws InputError naming file and line.
void refuse_bad_batches(const std::string& file, const toml::node& node, const Sweep& sweep);

}  // namespace ar3d
