#pragma once

#include <set>
#include <string>
#include <utility>

#include "ar3d/analysis/tally.h"
#include "ar3d/base/printable.h"  // shell_word

namespace ar3d {

/// Returns the shell line that generates the row's graph again and draws it with the same algorithm
/// and options. Words that a shell would read in another way are quoted, whatever the results file
/// holds.
std::string draw_command(const RunRecord& run);
std::string draw_command(const CurveKey& key, std::int64_t n, std::uint64_t seed);

/// Returns the parts of that line: it is the first one, n, " --seed ", the seed, the second one.
std::pair<std::string, std::string> draw_command_parts(const CurveKey& key);

/// Represents the line that shows a row of this study again: draw_command, or "ar3d replay FILE ROW"
/// with the row's key or number where that needs the results. It does where the graph is one of a
/// file (/graph_files), or where a program of the study's own ("program_NAME") draws it.
class ShowCommand {
 public:
  explicit ShowCommand(const Rows& rows);
  bool is_of_file(const std::string& family) const { return families_.contains(family); }
  bool needs_results(const CurveKey& key) const {
    return is_of_file(key.family) || programs_.contains(key.algorithm);
  }
  std::string operator()(const CurveKey& key, const DrawnGraph& graph) const;
  std::string operator()(const RunRecord& run, std::size_t row) const;

 private:
  std::string file_;
  std::set<std::string> families_;  // of files
  std::set<std::string> programs_;
};

}  // namespace ar3d
