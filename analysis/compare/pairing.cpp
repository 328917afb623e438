#include "ar3d/analysis/compare/pairing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "ar3d/analysis/statistics.h"
#include "ar3d/base/error.h"

namespace ar3d {
namespace {

auto graph_of(const RunRecord& run) {
  return std::tuple(run.requested_n, run.instance_index, run.seed);
}

auto identity(const RunRecord& run) {
  return std::tuple_cat(std::tuple(curve_of(run)), graph_of(run),
                        std::tuple(run.phase, run.scale, run.repetition));
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

bool is_time(double seconds) { return std::isfinite(seconds) && seconds > 0; }

/// The phase whose times count in the cell.
RunPhase timed_phase(const PairedCell& cell) {
  const bool timing = std::any_of(cell.rows.begin(), cell.rows.end(), [](const PairedRow& row) {
    return row.base->phase == RunPhase::timing;
  });
  return timing ? RunPhase::timing : RunPhase::metrics;
}

/// The drawn pairs of the phase that counts.
std::vector<PairedRow> candidates(const PairedCell& cell) {
  const RunPhase phase = timed_phase(cell);
  std::vector<PairedRow> rows;
  for (const PairedRow& row : cell.rows) {
    if (row.base->phase == phase && both_drawn(row)) rows.push_back(row);
  }
  return rows;
}

bool has_times(const PairedRow& row) {
  return is_time(row.base->wall_s) && is_time(row.now->wall_s);
}

}  // namespace

bool both_drawn(const PairedRow& row) {
  const auto is_drawn = [](const RunRecord& run) {
    return run.status == RunStatus::ok || run.status == RunStatus::measured;
  };
  return is_drawn(*row.base) && is_drawn(*row.now);
}

std::string row_label(const RunRecord& run) {
  const CurveKey key = curve_of(run);
  std::string label = algorithm_label(key);
  if (!run.family.empty()) label += fmt::format(" on {} n={}", family_label(key), run.requested_n);
  if (run.instance_index >= 0) label += fmt::format(", instance {}", run.instance_index);
  if (run.repetition >= 0) label += fmt::format(", repetition {}", run.repetition);
  return label;
}

Pairing pair_rows(const Results& base, const Results& now) {
  const RowIndex new_rows = index_of(now, "NEW");
  const KeyIndex new_keys = keys_of(now);
  index_of(base, "BASE");
  Pairing pairing;
  std::map<std::pair<CurveKey, std::int64_t>, std::size_t> cell_of;
  std::size_t matched = 0;
  for (const RunRecord& run : base.runs) {
    const RunRecord* const partner = partner_of(run, new_rows, new_keys);
    if (partner == nullptr) {
      const bool may_lack = run.phase == RunPhase::timing && run.repetition > 0;
      if (may_lack) {
        ++pairing.fewer;
      } else if (pairing.missing++ == 0) {
        pairing.first_missing = row_label(run);
      }
      continue;
    }
    ++matched;
    const std::int64_t n = run.n >= 0 ? run.n : run.requested_n;
    const auto [place, is_new] = cell_of.try_emplace({curve_of(run), n}, pairing.cells.size());
    if (is_new) pairing.cells.push_back({curve_of(run), n, {}});
    pairing.cells[place->second].rows.push_back({&run, partner});
  }
  pairing.extra = now.runs.size() - matched;
  return pairing;
}

std::vector<double> log_time_ratios(const PairedCell& cell) {
  std::vector<double> ratios;
  for (const PairedRow& row : candidates(cell)) {
    if (has_times(row)) ratios.push_back(std::log(row.now->wall_s / row.base->wall_s));
  }
  return ratios;
}

double round_log_time_ratio(const PairedCell& cell) {
  std::map<decltype(graph_of(RunRecord())), std::pair<double, double>> smallest;
  for (const PairedRow& row : candidates(cell)) {
    if (!has_times(row)) continue;
    const std::pair<double, double> times = {row.base->wall_s, row.now->wall_s};
    auto& kept = smallest.try_emplace(graph_of(*row.base), times).first->second;
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

}  // namespace ar3d
