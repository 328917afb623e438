#pragma once

#include <toml++/toml.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "ar3d/bench/external/external_algorithm.h"
#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/bench/spec/toml_table.h"
#include "ar3d/model/settings.h"

namespace ar3d {

/// Returns the entries of the key `graphs` of a sweep: paths, patterns, or tables { file = …, … }.
/// No file is looked at.
/// @throws InputError "file:line: message" on an unknown key or format or a value out of range.
std::vector<GraphsEntry> read_graphs(const toml::node& node);

inline constexpr std::size_t kLongestGraphsName = 47;

/// Returns true if a study and its results can know graphs by this name: 1 to 47 letters, digits,
/// '.', '-' and '_', of which the first is none of '.' and '-'.
bool is_graphs_name(const std::string& name);
/// Returns true if a family of the catalogue has this name.
bool is_family(const std::string& name);
/// Returns what the graphs of a file or folder are called: its name, cut where it is too long; what
/// no name may have becomes '_', which also stands before the name of a family of the catalogue.
std::string own_graphs_name(const std::string& path);

/// Reads the value of one key of a specification. @throws InputError "file:line: message".
void read_timed_repetitions(const toml::node& node, Sweep& into);
BatchRules read_batches(const toml::node& node, const std::string& what,
                        const std::string& workers);
TimingRules read_timing_rules(const toml::node& node);
Budget read_budget(const toml::node& node);

/// Reads a program of a study's `[[algorithm]]`.
/// @throws InputError "file:line: message" on an unknown or missing key, a value out of range, a
/// name that an algorithm of the catalogue has, a command whose braces name no option.
std::shared_ptr<const ExternalAlgorithm> read_program(const toml::node& node);

/// Returns every combination of the settings, the last one fastest.
/// @throws InputError if there are more than 100,000.
std::vector<Settings> combinations(const std::vector<SettingChoices>& settings);

/// Refuses a sweep with strong or weak batches of what has none: programs, levels that store, and
/// more than one certificate. @param node  the sweep. @throws InputError naming file and line.
void refuse_bad_batches(const toml::node& node, const Sweep& sweep);

}  // namespace ar3d
