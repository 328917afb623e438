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
std::string draw_command(const CurveKey& key, const DrawnGraph& graph);

/// The same line is the first part, n, " --seed ", the seed, the second part.
std::pair<std::string, std::string> draw_command_parts(const CurveKey& key);

/// Represents the line that shows a row of this study again: draw_command, or replay_command where
/// that needs the results: the graph is one of a file (/graph_files), which no family makes, or a
/// program of the study's own ("program_NAME" in /environments) draws it.
class ShowCommand {
 public:
  explicit ShowCommand(const RowView& rows);
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

/// "ar3d replay FILE ROW" with the row's key, or with `row` (its number in /runs) if it has none.
std::string replay_command(const std::string& file, const RunRecord& run, std::size_t row);
std::string replay_command(const std::string& file, std::size_t row);

}  // namespace ar3d
