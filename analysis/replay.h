#pragma once

#include <string>
#include <string_view>

#include "ar3d/analysis/tally.h"

namespace ar3d {

/// The word as a POSIX shell reads it back: in quotes unless it is plain.
std::string shell_word(std::string_view word);

/// The shell line that generates the row's graph again and draws it with the same algorithm and
/// options. Words that a shell would read in another way are quoted, whatever the results file
/// holds.
std::string draw_command(const RunRecord& run);
std::string draw_command(const CurveKey& key, const DrawnGraph& graph);

/// The same line is before_n, n, " --seed ", the seed, behind_seed.
struct CommandParts {
  std::string before_n;
  std::string behind_seed;
};
CommandParts draw_command_parts(const CurveKey& key);

/// "ar3d replay RESULTS.h5 ROW" with the row's key, or with `row` (its number in /runs) if it has
/// none.
std::string replay_command(const RunRecord& run, std::size_t row);
std::string replay_command(std::size_t row);

}  // namespace ar3d
