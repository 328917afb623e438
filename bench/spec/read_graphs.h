#pragma once

#include <toml++/toml.h>

#include <string>
#include <vector>

#include "ar3d/bench/spec/study_spec.h"

namespace ar3d {

/// The entries of the key `graphs` of a sweep: paths, patterns, or tables { file = …, … }. No file
/// is looked at.
/// @throws InputError "file:line: message" on an unknown key or format or a value out of range.
std::vector<GraphsEntry> read_graphs(const std::string& file, const toml::node& node);

inline constexpr std::size_t kLongestGraphsName = 47;

/// True if a study and its results can know graphs by this name: 1 to 47 letters, digits, '.', '-'
/// and '_', of which the first is none of '.' and '-'.
bool is_graphs_name(const std::string& name);

}  // namespace ar3d
