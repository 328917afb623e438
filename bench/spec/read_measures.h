#pragma once

#include <string>

#include "ar3d/bench/spec/measures.h"
#include "ar3d/bench/spec/toml_table.h"

namespace ar3d {

/// Each reads the value of one key of a specification. @throws InputError "file:line: message".
TimedRepetitions read_timed_repetitions(const std::string& file, const toml::node& node);
Batches read_batches(const std::string& file, const toml::node& node, const std::string& what,
                     const std::string& sharers);
TimingRules read_timing_rules(const std::string& file, const toml::node& node);
Budget read_budget(const std::string& file, const toml::node& node);

}  // namespace ar3d
