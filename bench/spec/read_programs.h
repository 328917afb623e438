#pragma once

#include <toml++/toml.h>

#include <memory>
#include <string>
#include <vector>

#include "ar3d/bench/external/external_algorithm.h"
#include "ar3d/model/settings.h"

namespace ar3d {

/// A program of a study's `[[algorithm]]`, with the values that its options take in turn.
struct ProgramEntry {
  std::shared_ptr<const ExternalAlgorithm> program;
  std::vector<std::pair<std::string, std::vector<std::int64_t>>> options;
};

/// @throws InputError "file:line: message" on an unknown or missing key, a value out of range, a
/// name that an algorithm of the catalogue has, a command whose braces name no option.
ProgramEntry read_program(const std::string& file, const toml::node& node);

}  // namespace ar3d
