// The shell line that draws a row again. Names and options come from results files, which anybody
// may have written, so every word is quoted for the shell.
#include <fmt/format.h>

#include "ar3d/analysis/tally.h"

namespace ar3d {
namespace {

/// "a=1;b=2" -> " --set a=1 --set b=2".
std::string settings(std::string_view list) {
  std::string arguments;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(';'), list.size());
    if (end > 0) arguments += fmt::format(" --set {}", shell_word(list.substr(0, end)));
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return arguments;
}

}  // namespace

std::pair<std::string, std::string> draw_command_parts(const CurveKey& key) {
  return {fmt::format("ar3d generate {} -n ", shell_word(key.family)),
          fmt::format("{} | ar3d draw - --algorithm {}{}", settings(key.parameters),
                      shell_word(key.algorithm), settings(key.options))};
}

std::string draw_command(const CurveKey& key, std::int64_t n, std::uint64_t seed) {
  const auto [before_n, behind_seed] = draw_command_parts(key);
  return fmt::format("{}{} --seed {}{}", before_n, n, seed, behind_seed);
}

std::string draw_command(const RunRecord& run) {
  return draw_command(curve_of(run), run.n >= 0 ? run.n : run.requested_n, run.seed);
}

ShowCommand::ShowCommand(const Rows& rows) : file_(rows.file) {
  for (const GraphFileRecord& file : side_records<GraphFileRecord>(rows.identity())) {
    families_.insert(file.name);
  }
  constexpr std::string_view kProgram = "program_";
  for (const EnvironmentEntry& entry : rows.environment()) {
    if (entry.name.starts_with(kProgram)) programs_.insert(entry.name.substr(kProgram.size()));
  }
}

std::string ShowCommand::operator()(const CurveKey& key, const DrawnGraph& graph) const {
  return needs_results(key) ? fmt::format("ar3d replay {} {}", shell_word(file_), graph.row)
                            : draw_command(key, graph.n, graph.seed);
}

std::string ShowCommand::operator()(const RunRecord& run, std::size_t row) const {
  if (!needs_results(curve_of(run))) return draw_command(run);
  return fmt::format("ar3d replay {} {}", shell_word(file_),
                     run.row_key.empty() ? std::to_string(row) : shell_word(run.row_key));
}

}  // namespace ar3d
