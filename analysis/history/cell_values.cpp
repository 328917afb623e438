// One pass over a results file makes one value of each measure for each cell. The graphs of a cell
// are part of its key, so that values of different graphs never stand in one line.
#include "ar3d/analysis/history/cell_values.h"

#include <fmt/format.h>

#include <numbers>

#include "ar3d/store/columns/run_columns.h"

namespace ar3d {
namespace {

/// What the rows of one graph in a cell say together.
struct GraphValues {
  std::string graph_hash;
  bool is_unfinished = false;
  // log_corrected_time() with its round, of the metrics phase and of the timing phase.
  std::vector<std::pair<std::int64_t, double>> times, timing;
  std::int64_t instructions = -1;
  std::int64_t cycles = -1;
  std::array<std::int64_t, 3> extents{-1, -1, -1};
  double log_volume = kMissing;
  std::int64_t bends = -1;
  std::int64_t m = -1;
  double crossings = kMissing;  // of measured drawings, as the next
  double angle = kMissing;      // the smallest one
  bool is_measured = false;
};

using GraphKey = std::tuple<std::int64_t, std::int64_t, std::uint64_t>;  // requested n, index, seed
using GraphTable = std::map<GraphKey, GraphValues>;

std::int64_t bends_of(const RunRecord& run) {
  std::int64_t bends = 0;
  for (std::size_t b = 0; b < run.bends.size(); ++b) {
    if (run.bends[b] < 0 || run.bends[b] > std::numeric_limits<std::int32_t>::max()) return -1;
    bends += static_cast<std::int64_t>(b) * run.bends[b];
  }
  return bends;
}

/// Of a drawing without a guarantee, whose coordinates have any unit.
void add_measured(const RunRecord& run, GraphValues& graph) {
  const auto number = [&run](const char* column) { return column_number(run_column(column), run); };
  graph.is_measured = true;
  graph.log_volume = number("log2_relative_volume") * std::numbers::ln2;
  graph.crossings = number("crossings");
  graph.angle = std::fmin(number("smallest_vertex_angle"), number("smallest_bend_angle"));
}

void add_row(const RunRecord& run, GraphValues& graph) {
  graph.graph_hash = std::max(graph.graph_hash, run.graph_hash);
  if (run.status != RunStatus::ok && run.status != RunStatus::measured) {
    graph.is_unfinished = true;
    return;
  }
  auto& times = run.phase == RunPhase::timing ? graph.timing : graph.times;
  if (drawing_time_s(run) > 0) times.emplace_back(run.repetition, log_corrected_time(run));
  graph.instructions = std::max(graph.instructions, run.counted_instructions);
  graph.cycles = std::max(graph.cycles, run.estimated_cycles);
  if (run.extents[0] < 0) return;
  graph.extents = run.extents;
  graph.log_volume = run.log2_volume * std::numbers::ln2;
  if (run.status == RunStatus::measured) add_measured(run, graph);
  graph.bends = bends_of(run);
  graph.m = run.m;
}

/// exp of the mean of the logarithms that `of` gives; missing if one is.
template <class Of>
double geometric_mean(const GraphTable& graphs, Of of) {
  double sum = 0;
  for (const auto& [key, graph] : graphs) sum += of(graph);
  const double mean = std::exp(sum / static_cast<double>(graphs.size()));
  return std::isfinite(mean) && mean > 0 ? mean : kMissing;
}

/// Missing if one is.
template <class Of>
double arithmetic_mean(const GraphTable& graphs, Of of) {
  double sum = 0;
  for (const auto& [key, graph] : graphs) sum += of(graph);
  return sum / static_cast<double>(graphs.size());
}

double bends_per_edge(const GraphTable& graphs) {
  double bends = 0, edges = 0;
  for (const auto& [key, graph] : graphs) {
    if (graph.bends < 0 || graph.m < 0) return kMissing;
    bends += static_cast<double>(graph.bends);
    edges += static_cast<double>(graph.m);
  }
  return edges > 0 ? bends / edges : kMissing;
}

CellValues values_of(const GraphTable& graphs) {
  const bool is_unfinished = std::any_of(graphs.begin(), graphs.end(),
                                         [](const auto& at) { return at.second.is_unfinished; });
  if (is_unfinished) return {};
  const bool is_timed = std::any_of(graphs.begin(), graphs.end(),
                                    [](const auto& at) { return !at.second.timing.empty(); });
  std::string boxes, bends, crossings, angles;
  for (const auto& [key, graph] : graphs) {
    boxes += graph.is_measured ? fmt::format("{:.3g} ", std::exp(graph.log_volume))
                               : fmt::format("{} ", fmt::join(graph.extents, " "));
    bends += fmt::format("{} ", graph.bends);
    crossings += fmt::format("{} ", graph.crossings);
    angles += fmt::format("{:.3g} ", graph.angle);
  }
  GraphRounds rounds;
  for (const auto& [key, graph] : graphs) {
    const auto& of_graph = is_timed ? graph.timing : graph.times;
    if (!of_graph.empty()) rounds[key] = of_graph;
  }
  const auto log_of = [](std::int64_t count) {
    return count > 0 ? std::log(static_cast<double>(count)) : kMissing;
  };
  CellValues values;
  if (rounds.size() == graphs.size()) {
    values.times = side_times(rounds);
    values.of[0].value = std::exp(values.times.level);
  }
  values.of[1].value =
      geometric_mean(graphs, [&](const GraphValues& graph) { return log_of(graph.instructions); });
  values.of[2].value =
      geometric_mean(graphs, [&](const GraphValues& graph) { return log_of(graph.cycles); });
  values.of[3] = {geometric_mean(graphs, [](const GraphValues& graph) { return graph.log_volume; }),
                  content_hash(boxes)};
  values.of[4] = {bends_per_edge(graphs), content_hash(bends)};
  values.of[5] = {arithmetic_mean(graphs, [](const GraphValues& graph) { return graph.crossings; }),
                  content_hash(crossings)};
  values.of[6] = {arithmetic_mean(graphs, [](const GraphValues& graph) { return graph.angle; }),
                  content_hash(angles)};
  return values;
}

}  // namespace

const char* to_string(Measure measure) {
  constexpr const char* kNames[] = {"time",  "instructions", "cycles", "volume",
                                    "bends", "crossings",    "angle"};
  return kNames[static_cast<std::size_t>(measure)];
}

CellTable cell_values(const RowView& rows) {
  CellTable table;
  std::map<std::pair<CurveKey, std::int64_t>, GraphTable> cells;
  std::array<std::vector<double>, 3> yardsticks;
  for (std::size_t row = 0; row < rows.count; ++row) {
    const RunRecord& run = rows.read(row);
    if (is_batched(run.phase)) continue;
    if (run.status != RunStatus::ok && run.status != RunStatus::measured) ++table.unfinished;
    table.rows_at_a_time = std::max(table.rows_at_a_time, static_cast<double>(run.concurrency));
    for (std::size_t i = 0; i < yardsticks.size(); ++i) {
      if (run.yardsticks_s[i] > 0) yardsticks[i].push_back(std::log(run.yardsticks_s[i]));
    }
    if (table.build_kind.empty()) table.build_kind = run.build_kind;
    const std::int64_t n = run.n >= 0 ? run.n : run.requested_n;
    add_row(run, cells[{curve_of(run), n}][{run.requested_n, run.instance_index, run.seed}]);
  }
  for (std::size_t i = 0; i < yardsticks.size(); ++i) {
    table.yardsticks[i] = median(std::move(yardsticks[i]));
  }
  for (const auto& [key, graphs] : cells) {
    std::string names;
    for (const auto& [graph, values] : graphs) {
      names += fmt::format("{} {} {} ", std::get<0>(graph), std::get<1>(graph), values.graph_hash);
    }
    table.cells[{key.first, key.second, content_hash(names)}] = values_of(graphs);
  }
  return table;
}

}  // namespace ar3d
