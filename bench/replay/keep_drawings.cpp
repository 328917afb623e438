// Drawings are not stored while a study runs: the wanted ones are drawn again afterwards from their
// rows. A drawing is kept only if its hash is the one of its row.

#include <exception>
#include <set>
#include <tuple>

#include "ar3d/bench/plan/plan.h"
#include "ar3d/bench/replay/replay_row.h"
#include "ar3d/bench/run/row_maker.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/store/columns/run_columns.h"

namespace ar3d {
namespace {

/// Holds how bad a drawing is; what stands first decides.
using Badness = std::array<double, 3>;

Badness badness_of(const RunRecord& run) {
  const auto known = [](double value) { return std::isnan(value) ? -1 : value; };
  double share = -1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double of_axis = static_cast<double>(run.extents[axis]) / run.theorem_bound[axis];
    if (run.extents[axis] >= 0) share = std::max(share, known(of_axis));
  }
  return {share, known(metric_of(run, "angle_miss")), known(run.log2_volume)};
}

auto drawing_of(const RunRecord& run) {
  return std::tuple(run.graph_hash, run.algorithm, run.options);
}

std::vector<std::size_t> worst_rows(const Rows& rows) {
  std::map<std::array<std::string, 4>, std::pair<Badness, std::size_t>> worst;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const RunRecord& run = rows.run(row);
    if (run.phase != RunPhase::metrics || !is_drawn(run)) continue;
    const Badness badness = badness_of(run);
    const auto [at, is_new] =
        worst.try_emplace({run.algorithm, run.options, run.family, run.parameters}, badness, row);
    if (!is_new && badness > at->second.first) at->second = {badness, row};
  }
  std::vector<std::size_t> chosen;
  for (const auto& [curve, found] : worst) chosen.push_back(found.second);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

std::vector<std::size_t> rows_to_keep(const Rows& rows, KeptDrawings kept, std::size_t& repeated) {
  if (kept == KeptDrawings::none) return {};
  if (kept == KeptDrawings::worst) return worst_rows(rows);
  std::vector<std::size_t> chosen;
  std::set<decltype(drawing_of(RunRecord()))> known;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const RunRecord& run = rows.run(row);
    const bool is_wanted =
        kept == KeptDrawings::all ? is_drawn(run) : run.status == RunStatus::violated;
    if (run.phase != RunPhase::metrics || !is_wanted) continue;
    const bool is_new = known.insert(drawing_of(run)).second;
    if (is_new) chosen.push_back(row);
    repeated += !is_new;
  }
  return chosen;
}

}  // namespace

std::optional<Drawing> drawn_again(const RunRecord& run, const StudyOrigin& origin,
                                   std::string& problem) {
  try {
    Drawing drawing = redrawn(run, origin);
    if (drawing_hash(drawing) == run.drawing_hash) return drawing;
    problem = "drawn again it is another drawing, which is not kept";
  } catch (const std::exception& error) {
    problem = fmt::format("not drawn again: {}", error.what());
  }
  return std::nullopt;
}

std::tuple<std::size_t, std::size_t, std::vector<std::string>> write_kept_drawings(
    const Rows& rows, KeptDrawings kept, OutputFile& file) {
  std::size_t written = 0, repeated = 0;
  std::vector<std::string> problems;
  const StudyOrigin origin = study_origin(rows.identity());
  if (origin.study && origin.study->begun_with) corpora_of(*origin.study);
  for (const std::size_t row : rows_to_keep(rows, kept, repeated)) {
    std::string problem;
    if (const auto drawing = drawn_again(rows.run(row), origin, problem)) {
      write_drawing_line(file, *drawing);
      ++written;
    } else {
      problems.push_back(fmt::format("row {}: {}", row, problem));
    }
  }
  return {written, repeated, std::move(problems)};
}

}  // namespace ar3d
