// One pass over a results file makes one value of each measure for each cell. The graphs of a cell
// are part of its key, so that values of different graphs never stand in one line.
#include <fmt/format.h>

#include <numbers>

#include "ar3d/analysis/history/history.h"
#include "ar3d/store/columns/run_columns.h"

namespace ar3d {
namespace {

/// Holds what the rows of one graph in a cell say together.
struct GraphValues {
  std::string graph_hash;
  bool is_unfinished = false;
  // log_corrected_time() with its round, of the metrics phase and of the timing phase.
  std::vector<std::pair<std::int64_t, double>> times, timing;
  std::array<double, kMeasures.size()> logs;  // by Measure; plain from bends on
  std::array<std::int64_t, 3> extents{-1, -1, -1};
  double m = kMissing;
  bool is_measured = false;
  GraphValues() { logs.fill(kMissing); }
};

using GraphTable = std::map<GraphRounds::key_type, GraphValues>;

double bends_of(const RunRecord& run) {
  double bends = 0;
  for (std::size_t b = 0; b < run.bends.size(); ++b) {
    if (run.bends[b] < 0) return kMissing;
    bends += static_cast<double>(b) * static_cast<double>(run.bends[b]);
  }
  return bends;
}

double log_count(std::int64_t count) {
  return count > 0 ? std::log(static_cast<double>(count)) : kMissing;
}

void add_row(const RunRecord& run, GraphValues& graph) {
  graph.graph_hash = std::max(graph.graph_hash, run.graph_hash);
  if (!is_good(run.status)) {
    graph.is_unfinished = true;
    return;
  }
  auto& times = run.phase == RunPhase::timing ? graph.timing : graph.times;
  if (drawing_time_s(run) > 0) times.emplace_back(run.repetition, log_corrected_time(run));
  auto& [time, instructions, cycles, volume, bends, crossings, angle] = graph.logs;
  instructions = std::fmax(instructions, log_count(run.counted_instructions));
  cycles = std::fmax(cycles, log_count(run.estimated_cycles));
  if (run.extents[0] < 0) return;
  graph.extents = run.extents;
  volume = run.log2_volume * std::numbers::ln2;
  bends = bends_of(run);
  graph.m = run.m < 0 ? kMissing : static_cast<double>(run.m);
  if (run.status != RunStatus::measured) return;
  graph.is_measured = true;  // coordinates have any unit
  volume = metric_of(run, "log2_relative_volume") * std::numbers::ln2;
  crossings = metric_of(run, "crossings");
  angle = std::fmin(metric_of(run, "smallest_vertex_angle"), metric_of(run, "smallest_bend_angle"));
}

CellValues values_of(const GraphTable& graphs) {
  CellValues values;
  GraphRounds rounds, timing;
  std::array<double, kMeasures.size()> sums{};
  std::array<std::string, kMeasures.size()> exact;
  double edges = 0;
  for (const auto& [key, graph] : graphs) {
    if (graph.is_unfinished) return {};
    if (!graph.times.empty()) rounds[key] = graph.times;
    if (!graph.timing.empty()) timing[key] = graph.timing;
    for (std::size_t i = 0; i < sums.size(); ++i) {
      sums[i] += graph.logs[i];
      exact[i] += fmt::format("{:.3g} ", i == 3 ? std::exp(graph.logs[i]) : graph.logs[i]);
    }
    if (!graph.is_measured) exact[3] += fmt::format("{} ", fmt::join(graph.extents, " "));
    for (const std::size_t i : {4U, 5U}) exact[i] += fmt::format("{} ", graph.logs[i]);
    edges += graph.m;
  }
  for (std::size_t i = 1; i < sums.size(); ++i) {
    const double mean = sums[i] / static_cast<double>(graphs.size());
    values.means[i] = i < 4 ? std::exp(mean) : mean;
    if (i >= 3) values.exact[i] = content_hash(exact[i]);
  }
  values.means[4] = edges > 0 ? sums[4] / edges : kMissing;
  if (!timing.empty()) rounds = std::move(timing);
  if (rounds.size() == graphs.size()) values.times = side_times(rounds);
  return values;
}

}  // namespace

const char* to_string(Measure measure) {
  constexpr const char* kNames[] = {"time",  "instructions", "cycles", "volume",
                                    "bends", "crossings",    "angle"};
  return kNames[static_cast<std::size_t>(measure)];
}

void take_rows(const Rows& rows, CommitResults& into) {
  into.settings = lasting_settings(rows.environment());
  into.graph_files = side_records<GraphFileRecord>(rows.identity());
  std::map<std::pair<CurveKey, std::int64_t>, GraphTable> cells;
  std::array<std::vector<double>, 3> yardsticks;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const RunRecord& run = rows.run(row);
    if (is_batched(run.phase)) continue;
    into.unfinished += !is_good(run.status);
    into.rows_at_a_time = std::max(into.rows_at_a_time, static_cast<double>(run.concurrency));
    for (std::size_t i = 0; i < yardsticks.size(); ++i) {
      if (run.yardsticks_s[i] > 0) yardsticks[i].push_back(std::log(run.yardsticks_s[i]));
    }
    if (into.build_kind.empty()) into.build_kind = run.build_kind;
    const std::int64_t n = run.n >= 0 ? run.n : run.requested_n;
    add_row(run, cells[{curve_of(run), n}][{run.requested_n, run.instance_index, run.seed}]);
  }
  for (std::size_t i = 0; i < yardsticks.size(); ++i) {
    into.yardsticks[i] = median(std::move(yardsticks[i]));
  }
  for (const auto& [key, graphs] : cells) {
    std::string names;
    for (const auto& [graph, values] : graphs) {
      names += fmt::format("{} {} {} ", std::get<0>(graph), std::get<1>(graph), values.graph_hash);
    }
    into.cells[{key.first, key.second, content_hash(names)}] = values_of(graphs);
  }
}

}  // namespace ar3d
