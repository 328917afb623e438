// Rows of two results that measured the same, and what changed between them that has no noise.
#include "ar3d/analysis/compare/pairing.h"

#include <fmt/format.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <map>
#include <tuple>

#include "ar3d/analysis/check.h"
#include "ar3d/analysis/statistics.h"
#include "ar3d/analysis/tally.h"
#include "ar3d/base/printable.h"
#include "ar3d/store/columns/run_columns.h"

namespace ar3d {

namespace {

auto graph_of(const RunRecord& run) {
  return std::tuple(run.requested_n, run.instance_index, run.seed);
}

auto identity(const RunRecord& run) {
  return std::tuple_cat(std::tuple(curve_of(run)), graph_of(run),
                        std::tuple(run.phase, run.workers, run.repetition));
}

using RowIndex = std::map<decltype(identity(RunRecord())), const RunRecord*>;

RowIndex index_of(const Results& results, const char* side) {
  RowIndex index;
  for (const RunRecord& run : results.runs) {
    if (!index.try_emplace(identity(run), &run).second) {
      throw InputError(
          fmt::format("{} holds the same measurement twice: {}", side, row_label(run)));
    }
  }
  return index;
}

using KeyIndex = std::map<std::string, const RunRecord*>;

KeyIndex keys_of(const Results& results) {
  KeyIndex index;
  for (const RunRecord& run : results.runs) {
    if (!run.row_key.empty()) index.try_emplace(run.row_key, &run);
  }
  return index;
}

/// The row of the same measurement; of a file of graphs under another name the row key tells it,
/// which is made from the graphs' hash. Null if there is none.
const RunRecord* partner_of(const RunRecord& run, const RowIndex& rows, const KeyIndex& keys) {
  if (const auto at = rows.find(identity(run)); at != rows.end()) return at->second;
  const auto at = keys.find(run.row_key);
  const bool is_same = at != keys.end() && at->second->algorithm == run.algorithm &&
                       at->second->graph_hash == run.graph_hash;
  return is_same ? at->second : nullptr;
}

/// The phase whose times count in the cell.
RunPhase timed_phase(const PairedCell& cell) {
  const bool timing = std::any_of(cell.rows.begin(), cell.rows.end(), [](const PairedRow& row) {
    return row[0]->phase == RunPhase::timing;
  });
  return timing ? RunPhase::timing : RunPhase::metrics;
}

/// The drawn pairs of the phase that counts.
std::vector<PairedRow> candidates(const PairedCell& cell) {
  const RunPhase phase = timed_phase(cell);
  std::vector<PairedRow> rows;
  for (const PairedRow& row : cell.rows) {
    if (row[0]->phase == phase && both_drawn(row)) rows.push_back(row);
  }
  return rows;
}

bool has_times(const PairedRow& row) {
  return std::ranges::all_of(row, [](const RunRecord* run) {
    const double seconds = drawing_time_s(*run);
    return std::isfinite(seconds) && seconds > 0;
  });
}

using Wide = boost::multiprecision::uint256_t;  // holds every product of three 64-bit numbers

/// Lattice points of the box.
Wide volume(const RunRecord& run) {
  Wide points = 1;
  for (const std::int64_t extent : run.extents) points *= Wide(extent) + 1;
  return points;
}

bool has_extents(const RunRecord& run) {
  return std::all_of(run.extents.begin(), run.extents.end(), [](auto e) { return e >= 0; });
}

bool has_bends(const RunRecord& run) {
  return std::all_of(run.bends.begin(), run.bends.end(), [](auto b) { return b >= 0; });
}

std::string box(const RunRecord& run) {
  return fmt::format("{} x {} x {}", run.extents[0], run.extents[1], run.extents[2]);
}

/// Total number of bends; edges with 7 or more count 7.
Wide total_bends(const RunRecord& run) {
  Wide total = 0;
  for (std::size_t b = 0; b < run.bends.size(); ++b) total += Wide(run.bends[b]) * b;
  return total;
}

Verdict direction(bool worse) { return worse ? Verdict::regressed : Verdict::improved; }

/// Judged right is more than drawn, and drawn more than not.
int rank_of(RunStatus status) {
  return status == RunStatus::ok ? 2 : status == RunStatus::measured ? 1 : 0;
}

void compare_status(const RunRecord& base, const RunRecord& now,
                    std::vector<FixedChange>& changes) {
  const bool violated = now.status == RunStatus::violated || now.violations > 0;
  if (violated) {
    changes.push_back({Verdict::violated, fmt::format("violated: {}", now.message)});
  } else if (base.status != now.status) {
    const int before = rank_of(base.status), after = rank_of(now.status);
    const Verdict verdict = before == after ? Verdict::pass : direction(after < before);
    const std::string why = now.message.empty() ? "" : ": " + now.message;
    changes.push_back({verdict, fmt::format("status {} became {}{}", to_string(base.status),
                                            to_string(now.status), why)});
  } else if (base.violations >= 0 && now.violations < 0 && now.status == RunStatus::ok) {
    changes.push_back({Verdict::regressed, "no longer certified"});
  } else if (is_unproved(base) != is_unproved(now)) {
    changes.push_back(
        is_unproved(now)
            ? FixedChange{Verdict::regressed,
                          fmt::format("no longer proved (certificate {})", now.certificate)}
            : FixedChange{Verdict::improved, "proved now"});
  }
}

void compare_volume(const RunRecord& base, const RunRecord& now,
                    std::vector<FixedChange>& changes) {
  if (!has_extents(base) || !has_extents(now) || base.extents == now.extents) return;
  const Wide before = volume(base), after = volume(now);
  const std::string boxes = fmt::format("box {} became {}", box(base), box(now));
  if (before == after) {
    changes.push_back({Verdict::pass, boxes});
  } else {
    changes.push_back({direction(after > before),
                       fmt::format("{} volume: {}", after > before ? "larger" : "smaller", boxes)});
  }
}

void compare_bends(const RunRecord& base, const RunRecord& now, std::vector<FixedChange>& changes) {
  if (!has_bends(base) || !has_bends(now) || base.bends == now.bends) return;
  const std::size_t most_before = most_bends(base.bends), most_after = most_bends(now.bends);
  if (most_before != most_after) {
    changes.push_back(
        {direction(most_after > most_before),
         fmt::format("most bends of an edge: {} became {}", most_before, most_after)});
    return;
  }
  const Wide before = total_bends(base), after = total_bends(now);
  changes.push_back({before == after ? Verdict::pass : direction(after > before),
                     fmt::format("bends in all: {:.0f} became {:.0f}", before.convert_to<double>(),
                                 after.convert_to<double>())});
}

/// Holds the change of volume or angle by which a drawing without a guarantee is as good.
constexpr double kMeasuredTolerance = 0.01;

bool is_measured(const PairedRow& row) {
  return std::ranges::count(row, RunStatus::measured, &RunRecord::status) > 0;
}

/// Coordinates of such a program have any unit: its volume is counted in smallest distances.
void compare_measured(const RunRecord& base, const RunRecord& now,
                      std::vector<FixedChange>& changes) {
  for (const auto& [name, what, more_is_worse, tolerance] :
       {std::tuple{"crossings", "crossings", true, 0.0},
        {"smallest_vertex_angle", "smallest angle at a vertex", false, kMeasuredTolerance},
        {"smallest_bend_angle", "smallest angle at a bend", false, kMeasuredTolerance},
        {"log2_relative_volume", "volume in smallest distances", true, kMeasuredTolerance}}) {
    double before = metric_of(base, name), after = metric_of(now, name);
    if (name == std::string_view("log2_relative_volume")) {
      before = std::exp2(before), after = std::exp2(after);
    }
    if (std::isnan(before) || std::isnan(after) || before == after) continue;
    if (std::abs(std::log(after / before)) <= tolerance) continue;
    changes.push_back({direction((after > before) == more_is_worse),
                       fmt::format("{}: {:.6g} became {:.6g}", what, before, after)});
  }
}

}  // namespace

bool both_drawn(const PairedRow& row) {
  return std::ranges::all_of(row, is_good, &RunRecord::status);
}

std::string row_label(const RunRecord& run) {
  const CurveKey key = curve_of(run);
  std::string label = algorithm_label(key);
  if (!run.family.empty()) label += fmt::format(" on {} n={}", family_label(key), run.requested_n);
  if (run.instance_index >= 0) label += fmt::format(", instance {}", run.instance_index);
  if (run.repetition >= 0) label += fmt::format(", repetition {}", run.repetition);
  return label;
}

void add_once(std::vector<std::string>& lines, const std::string& line) {
  if (std::ranges::count(lines, line) == 0) lines.push_back(line);
}

std::vector<PairedCell> pair_rows(const Results& base, const Results& now,
                                  std::vector<std::string>& incomplete,
                                  std::vector<std::string>& remarks) {
  const RowIndex new_rows = index_of(now, "NEW");
  const KeyIndex new_keys = keys_of(now);
  index_of(base, "BASE");
  std::vector<PairedCell> cells;
  std::map<std::pair<CurveKey, std::int64_t>, std::size_t> cell_of;
  std::size_t matched = 0, missing = 0, fewer = 0;
  std::string first_missing;
  for (const RunRecord& run : base.runs) {
    const RunRecord* const partner = partner_of(run, new_rows, new_keys);
    if (partner == nullptr) {
      const bool may_lack = run.phase == RunPhase::timing && run.repetition > 0;
      if (may_lack) {
        ++fewer;
      } else if (missing++ == 0) {
        first_missing = row_label(run);
      }
      continue;
    }
    ++matched;
    const std::int64_t n = run.n >= 0 ? run.n : run.requested_n;
    const auto [cell, is_new] = cell_of.try_emplace({curve_of(run), n}, cells.size());
    if (is_new) cells.push_back({curve_of(run), n, {}});
    cells[cell->second].rows.push_back({&run, partner});
  }
  if (missing > 0) {
    add_once(incomplete, fmt::format("NEW lacks {} measurements of BASE; the first: {}", missing,
                                     one_line(first_missing)));
  }
  if (fewer > 0) {
    add_once(remarks, fmt::format("{} timed repetitions of BASE have no partner", fewer));
  }
  if (const std::size_t extra = now.runs.size() - matched; extra > 0) {
    add_once(remarks, fmt::format("{} measurements of NEW are not in BASE", extra));
  }
  return cells;
}

std::vector<PairedRow> timed_rows(const PairedCell& cell) {
  std::vector<PairedRow> rows = candidates(cell);
  std::erase_if(rows, [](const PairedRow& row) { return !has_times(row); });
  return rows;
}

double round_log_time_ratio(const PairedCell& cell) {
  std::map<decltype(graph_of(RunRecord())), std::pair<double, double>> smallest;
  for (const PairedRow& row : timed_rows(cell)) {
    const std::pair<double, double> times = {drawing_time_s(*row[0]), drawing_time_s(*row[1])};
    auto& kept = smallest.try_emplace(graph_of(*row[0]), times).first->second;
    kept = {std::min(kept.first, times.first), std::min(kept.second, times.second)};
  }
  std::vector<double> ratios;
  for (const auto& [graph, times] : smallest) {
    ratios.push_back(std::log(times.second / times.first));
  }
  return median(std::move(ratios));
}

std::size_t rows_without_time(const PairedCell& cell) {
  const std::vector<PairedRow> rows = candidates(cell);
  return static_cast<std::size_t>(std::count_if(
      rows.begin(), rows.end(), [](const PairedRow& row) { return !has_times(row); }));
}

std::vector<FixedChange> fixed_changes(const PairedRow& row) {
  const RunRecord &base = *row[0], &now = *row[1];
  std::vector<FixedChange> changes;
  compare_status(base, now, changes);
  if (!base.graph_hash.empty() && !now.graph_hash.empty() && base.graph_hash != now.graph_hash) {
    changes.push_back({Verdict::regressed, "the same family, n and seed give another graph"});
    return changes;
  }
  if (is_measured(row)) {
    compare_measured(base, now, changes);
  } else {
    compare_volume(base, now, changes);
  }
  compare_bends(base, now, changes);
  const bool drawn = !base.drawing_hash.empty() && !now.drawing_hash.empty();
  if (changes.empty() && drawn && base.drawing_hash != now.drawing_hash) {
    changes.push_back({Verdict::pass, "another drawing of the same volume and bends"});
  }
  return changes;
}

double log2_volume_change(const PairedRow& row) {
  const RunRecord &base = *row[0], &now = *row[1];
  if (is_measured(row)) {
    const char* const volume = "log2_relative_volume";
    const double change = metric_of(now, volume) - metric_of(base, volume);
    return std::isfinite(change) ? change : 0;
  }
  if (!has_extents(base) || !has_extents(now)) return 0;
  double change = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    change += std::log2((static_cast<double>(now.extents[axis]) + 1) /
                        (static_cast<double>(base.extents[axis]) + 1));
  }
  return change;
}

std::vector<FixedChange> count_changes(const PairedCell& cell, const CompareOptions& options,
                                       std::array<double, 2>& logs) {
  double instructions[2] = {}, cycles[2] = {};
  logs = {kMissing, kMissing};
  for (const PairedRow& row : cell.rows) {
    if (!both_drawn(row)) continue;
    for (const std::size_t side : {0U, 1U}) {
      const RunRecord* run = row[side];
      if (run->counted_instructions <= 0) return {};
      instructions[side] += static_cast<double>(run->counted_instructions);
      cycles[side] +=
          run->estimated_cycles > 0 ? static_cast<double>(run->estimated_cycles) : kMissing;
    }
  }
  logs = {std::log(instructions[1] / instructions[0]), std::log(cycles[1] / cycles[0])};
  std::vector<FixedChange> changes;
  for (const auto& [what, log, threshold] :
       {std::tuple{"instructions", logs[0], options.instruction_threshold},
        std::tuple{"estimated cycles", logs[1], options.cycle_threshold}}) {
    if (!(std::abs(log) > std::log1p(threshold))) continue;  // a missing one is no change
    changes.push_back({direction(log > 0), fmt::format("{} x{:.4f}", what, std::exp(log))});
  }
  return changes;
}

}  // namespace ar3d
