// One pass over a study: what is kept of graphs, sizes and curves, in memory that does not grow
// with the rows.
#include "ar3d/analysis/tally.h"

#include <charconv>
#include <numbers>
#include <unordered_map>

#include "ar3d/analysis/check.h"
#include "ar3d/analysis/statistics.h"
#include "ar3d/store/columns/run_columns.h"

namespace ar3d {
namespace {

constexpr std::size_t kMostGraphs = 200000;  // kept with all their numbers
constexpr std::size_t kMostSizes = 200000;
constexpr std::size_t kMostOfASize = 4096, kLeastOfASize = 8;
constexpr std::size_t kMostCensored = 1000, kMostBatches = 10000;
constexpr std::size_t kTimed = 9;  // index of the timing phase in log_sum

// What decides whether a graph is in the sample: a fixed shuffle (SplitMix64) of seed and index, so
// that the curves keep the same graphs.
std::uint64_t priority(const DrawnGraph& graph) {
  std::uint64_t z =
      (graph.seed + static_cast<std::uint64_t>(graph.instance) + 1) * 0x9E3779B97F4A7C15;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
  return z ^ (z >> 31);
}

void keep_sample(std::size_t most, std::vector<DrawnGraph>& graphs) {
  if (graphs.size() <= most) return;
  const auto end = graphs.begin() + static_cast<std::ptrdiff_t>(most);
  std::nth_element(graphs.begin(), end, graphs.end(), [](const DrawnGraph& a, const DrawnGraph& b) {
    return std::pair(priority(a), a.row) < std::pair(priority(b), b.row);
  });
  graphs.erase(end, graphs.end());
}

// Of "name=value;…"; -1 if it is not there.
std::int64_t counter_of(const RunRecord& run, const std::string& name) {
  std::int64_t value = -1;
  const std::size_t at = (';' + run.counters).find(';' + name + '=');
  if (at == std::string::npos) return value;
  const char* text = run.counters.data();
  std::from_chars(text + at + name.size() + 1, text + run.counters.size(), value);
  return value;
}

DrawnGraph drawn_graph(const RunRecord& run, std::size_t row, std::int64_t n, bool has_own_unit) {
  DrawnGraph graph;
  graph.row = row;
  graph.n = n;
  graph.m = run.m;
  graph.seed = run.seed;
  graph.instance = run.instance_index;
  graph.name = run.graph_name;
  graph.group = run.group;
  graph.extents = run.extents;
  graph.skewed = {counter_of(run, "skew_x"), counter_of(run, "skew_y"), counter_of(run, "skew_z")};
  graph.instance_bound = run.instance_bound;
  graph.theorem_bound = run.theorem_bound;
  graph.published_bound = run.published_bound;
  graph.log2_volume = run.log2_volume;
  graph.metrics.reserve(metrics().size());
  for (const MetricValue& value : metrics_of(run)) graph.metrics.push_back(number_of(value));
  graph.log2_relative_volume = metric_of(graph, "log2_relative_volume");
  if (has_own_unit) {  // its coordinates are decimals in units of the last one
    graph.extents = graph.instance_bound = {-1, -1, -1};
    graph.theorem_bound = graph.published_bound = {kMissing, kMissing, kMissing};
    graph.log2_volume = graph.log2_relative_volume;
  }
  return graph;
}

/// The rows of one graph and curve that were read so far.
struct OpenGraph {
  std::size_t curve = 0;
  std::int64_t n = -1;
  bool censored = false, drawn = false;
  DrawnGraph graph;
  std::array<std::uint64_t, 8> bends{};
  std::vector<double> log_wall, log_timed;
};

/// Takes the rows one after the other.
class Tallying {
 public:
  explicit Tallying(const StudyIdentity& study)
      : algorithms_(side_records<AlgorithmRecord>(study)) {}
  void add(const RunRecord& run, std::size_t row, bool is_last);
  StudyTally finish();

 private:
  CurveTally* curve_for(const RunRecord& run, std::int64_t n, std::size_t& index);
  void add_to_graph(const RunRecord& run, std::size_t row, OpenGraph& open);
  void add_batch(const RunRecord& run, const CurveKey& key);
  void conclude(OpenGraph open);
  void thin_out();

  std::vector<AlgorithmRecord> algorithms_;
  StudyTally tally_;
  std::map<CurveKey, std::size_t> index_of_;
  std::unordered_map<std::string, OpenGraph> open_;
  std::size_t sizes_ = 0, kept_ = 0, most_ = kMostOfASize;
};

// Null if there is no room for another curve or size.
CurveTally* Tallying::curve_for(const RunRecord& run, std::int64_t n, std::size_t& index) {
  const CurveKey key = curve_of(run);
  const auto at = index_of_.find(key);
  if (at == index_of_.end()) {
    if (sizes_ >= kMostSizes) return nullptr;
    index = tally_.curves.size();
    index_of_.emplace(key, index);
    const AlgorithmRecord* record = find_algorithm_record(algorithms_, key.algorithm, key.options);
    const bool has_own_unit = record != nullptr && !record->theorem.promises_box();
    CurveTally& curve = tally_.curves.emplace_back();
    curve.key = key;
    curve.has_own_unit = has_own_unit;
  } else {
    index = at->second;
  }
  CurveTally& curve = tally_.curves[index];
  if (!curve.sizes.contains(n)) {
    if (sizes_ >= kMostSizes) return nullptr;
    ++sizes_;
    curve.sizes[n].n = n;
    curve.sizes[n].requested_n = run.requested_n;
  }
  return &curve;
}

void Tallying::add(const RunRecord& run, std::size_t row, bool is_last) {
  const std::string key = repetition_key(run);
  auto at = open_.find(key);
  if (at == open_.end()) {
    OpenGraph open;
    open.n = run.n >= 0 ? run.n : run.requested_n;
    CurveTally* curve = curve_for(run, open.n, open.curve);
    if (curve == nullptr) {
      ++tally_.left_out_rows;
      return;
    }
    ++curve->instances;
    curve->smallest_n = curve->rows == 0 ? open.n : std::min(curve->smallest_n, open.n);
    curve->largest_n = std::max(curve->largest_n, open.n);
    at = open_.emplace(key, std::move(open)).first;
  }
  add_to_graph(run, row, at->second);
  if (!is_last) return;
  OpenGraph whole = std::move(at->second);
  open_.erase(at);
  conclude(std::move(whole));
}

void Tallying::add_to_graph(const RunRecord& run, std::size_t row, OpenGraph& open) {
  CurveTally& curve = tally_.curves[open.curve];
  ++curve.rows;
  ++curve.rows_of_status[static_cast<std::size_t>(run.status)];
  curve.violations += breaks_promise(run);
  curve.unproved += run.status == RunStatus::ok && run.violations <= 0 &&
                    (run.violations < 0 || !run.certificate.empty());
  if (is_batched(run.phase)) add_batch(run, curve.key);
  if (is_unfinished(run.status)) {
    open.censored = true;
    if (open.n >= 1 && curve.censored.size() < kMostCensored) {
      DrawnGraph& ended = curve.censored.emplace_back();
      ended.row = row, ended.status = run.status, ended.n = open.n;
      ended.m = run.m, ended.seed = run.seed;
    }
  }
  if (!is_good(run.status)) return;
  curve.has_own_unit |= run.status == RunStatus::measured;
  if (!open.drawn) {
    open.drawn = true;
    open.graph = drawn_graph(run, row, open.n, curve.has_own_unit);
    for (std::size_t b = 0; b < open.bends.size(); ++b) {
      open.bends[b] = static_cast<std::uint64_t>(std::max<std::int64_t>(0, run.bends[b]));
    }
  }
  const double log_time = log_positive(run.wall_s);
  curve.has_timing_rows |= run.phase == RunPhase::timing;
  if (std::isnan(log_time)) return;
  if (run.phase == RunPhase::timing) open.log_timed.push_back(log_time);
  if (run.phase == RunPhase::metrics) open.log_wall.push_back(log_time);
}

void Tallying::add_batch(const RunRecord& run, const CurveKey& key) {
  if (run.workers < 1 || !(run.efficiency > 0) || !(run.batch_s > 0)) return;
  auto& [batch_s, ideal_s] =
      tally_.batches[{run.phase, algorithm_label(key), family_label(key), run.n, run.workers}];
  if (batch_s.size() == kMostBatches) return;
  batch_s.push_back(run.batch_s);
  ideal_s.push_back(run.ideal_batch_s);
}

void add_slacks(const DrawnGraph& graph, std::array<AxisBounds, 3>& axes) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    AxisBounds& tally = axes[axis];
    const std::int64_t extent = graph.extents[axis];
    const double slack = slack_of(extent, graph.theorem_bound[axis]);
    if (!std::isnan(slack) && !(slack >= tally.worst_slack)) {
      tally.worst_slack = slack;
      tally.worst = graph;
    }
    tally.worst_instance_slack =
        std::fmin(tally.worst_instance_slack,
                  slack_of(extent, static_cast<double>(graph.instance_bound[axis])));
    tally.worst_published_slack =
        std::fmin(tally.worst_published_slack, slack_of(extent, graph.published_bound[axis]));
  }
}

void add_logs(const DrawnGraph& graph, SizeTally& size) {
  for (std::size_t index = 0; index <= kTimed; ++index) {
    const bool timed = index == kTimed;
    const double log = log_value(graph, timed ? Quantity::wall_s : kQuantities[index], timed);
    if (std::isnan(log)) continue;
    size.log_sum[index] += log;
    ++size.log_count[index];
  }
}

void Tallying::conclude(OpenGraph open) {
  CurveTally& curve = tally_.curves[open.curve];
  SizeTally& size = curve.sizes[open.n];
  size.censored |= open.censored;
  if (!open.drawn) return;
  DrawnGraph& graph = open.graph;
  graph.log_wall_s = median(std::move(open.log_wall));
  graph.log_timed_s = median(std::move(open.log_timed));
  for (std::size_t b = 0; b < open.bends.size(); ++b) curve.bends[b] += open.bends[b];
  add_slacks(graph, curve.axes);
  add_logs(graph, size);
  if (size.drawn == 0 || graph.share() > size.closest.share() ||
      (std::isnan(size.closest.share()) && !std::isnan(graph.share()))) {
    size.closest = graph;
  }
  ++size.drawn;
  size.graphs.push_back(std::move(graph));
  ++kept_;
  if (size.graphs.size() >= 2 * most_) {
    kept_ -= size.graphs.size() - most_;
    keep_sample(most_, size.graphs);
  }
  if (kept_ > kMostGraphs && most_ > kLeastOfASize) thin_out();
}

void Tallying::thin_out() {
  most_ /= 2;
  kept_ = 0;
  for (CurveTally& curve : tally_.curves) {
    for (auto& [n, size] : curve.sizes) {
      keep_sample(most_, size.graphs);
      kept_ += size.graphs.size();
    }
  }
}

StudyTally Tallying::finish() {
  for (auto& [key, open] : open_) conclude(std::move(open));
  bool is_sampled = false;
  for (CurveTally& curve : tally_.curves) {
    std::ranges::stable_sort(curve.censored, {}, &DrawnGraph::n);
    for (auto& [n, size] : curve.sizes) {
      keep_sample(most_, size.graphs);
      std::sort(size.graphs.begin(), size.graphs.end(),
                [](const DrawnGraph& a, const DrawnGraph& b) { return a.row < b.row; });
      is_sampled |= size.graphs.size() < size.drawn;
    }
  }
  tally_.kept_graphs = is_sampled ? most_ : 0;
  return std::move(tally_);
}

}  // namespace

double log_positive(double value) {
  return value > 0 && std::isfinite(value) ? std::log(value) : kMissing;
}

double slack_of(std::int64_t extent, double bound) {
  if (extent < 0 || !std::isfinite(bound) || bound <= 0) return kMissing;
  return 1 - static_cast<double>(extent) / bound;
}

double DrawnGraph::share() const {
  double share = kMissing;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    share = std::fmax(share, 1 - slack_of(extents[axis], theorem_bound[axis]));
  }
  return share;
}

double log_value(const DrawnGraph& graph, Quantity quantity, bool timed) {
  const auto index = static_cast<std::size_t>(quantity);
  constexpr auto x = static_cast<std::size_t>(Quantity::extent_x);
  constexpr auto skewed_x = static_cast<std::size_t>(Quantity::skewed_x);
  const auto log = [](std::int64_t extent) { return log_positive(static_cast<double>(extent)); };
  if (quantity == Quantity::wall_s) return timed ? graph.log_timed_s : graph.log_wall_s;
  if (quantity == Quantity::longest_side) return log(std::ranges::max(graph.extents));
  if (quantity == Quantity::volume) {
    const double log_volume = graph.log2_volume * std::numbers::ln2;
    return std::isfinite(log_volume) ? log_volume : kMissing;
  }
  return log(index >= skewed_x ? graph.skewed[index - skewed_x] : graph.extents[index - x]);
}

double metric_of(const DrawnGraph& graph, std::string_view name) {
  const auto at = std::ranges::find(metrics(), name, &Metric::name);
  const auto index = static_cast<std::size_t>(at - metrics().begin());
  return index < graph.metrics.size() ? graph.metrics[index] : kMissing;
}

double log_volume_at_least(const DrawnGraph& graph) {
  return log_positive(metric_of(graph, "volume_at_least"));
}

double SizeTally::mean_log(Quantity quantity, bool timed) const {
  const std::size_t index =
      quantity == Quantity::wall_s && timed ? kTimed : static_cast<std::size_t>(quantity);
  return log_count[index] == 0 ? kMissing : log_sum[index] / static_cast<double>(log_count[index]);
}

StudyTally tally_of(const Rows& rows, const std::vector<bool>& is_last_repetition) {
  Tallying tallying(rows.identity());
  for (std::size_t row = 0; row < rows.size(); ++row) {
    tallying.add(rows.run(row), row, is_last_repetition[row]);
  }
  return tallying.finish();
}

}  // namespace ar3d
