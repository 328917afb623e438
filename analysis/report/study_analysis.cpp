// Bounds beside what was measured, and all else that report and exports show, computed once.
#include <algorithm>

#include "ar3d/analysis/report/report.h"

namespace ar3d {
namespace {

/// Every kept graph of the curve.
template <class Use>
void for_each_graph(const CurveTally& curve, const Use& use) {
  for (const auto& [n, size] : curve.sizes) {
    for (const DrawnGraph& graph : size.graphs) use(graph);
  }
}

void add_slack(std::int64_t extent, double bound, std::vector<double>& slacks) {
  const double slack = slack_of(extent, bound);
  if (!std::isnan(slack)) slacks.push_back(slack);
}

void add_medians(std::size_t axis, CurveTally& curve) {
  AxisBounds& entry = curve.axes[axis];
  std::vector<double> theorem, instance, published;
  for_each_graph(curve, [&](const DrawnGraph& graph) {
    const std::int64_t extent = graph.extents[axis];
    add_slack(extent, graph.theorem_bound[axis], theorem);
    add_slack(extent, static_cast<double>(graph.instance_bound[axis]), instance);
    add_slack(extent, graph.published_bound[axis], published);
  });
  entry.measured = theorem.size();
  entry.median_slack = median(theorem);
  entry.median_instance_slack = median(instance);
  entry.median_published_slack = median(published);
}

void add_volume(CurveTally& curve) {
  std::vector<double> over_optimum;
  for_each_graph(curve, [&](const DrawnGraph& graph) {
    const double times = metric_of(graph, "times_the_optimum");
    if (times > 0) over_optimum.push_back(times);
  });
  curve.times_the_optimum = median(std::move(over_optimum));
  const auto last = std::find_if(curve.sizes.rbegin(), curve.sizes.rend(),
                                 [](const auto& size) { return size.second.drawn > 0; });
  if (last == curve.sizes.rend()) return;
  std::vector<double> volumes, shares, over_least;
  for (const DrawnGraph& graph : last->second.graphs) {
    volumes.push_back(graph.log2_volume);
    const double log_volume = log_value(graph, Quantity::volume, false);
    shares.push_back(std::exp(log_volume - log_bound(graph, Quantity::volume)));
    over_least.push_back(std::exp(log_volume - log_volume_at_least(graph)));
  }
  curve.log2_volume = median(std::move(volumes));
  curve.volume_share = median(std::move(shares));
  curve.volume_over_least = median(std::move(over_least));
}

/// Sets what was measured of every curve beside what its theorem promises.
void add_bounds(const StudyIdentity& study, StudyTally& tally) {
  const std::vector<AlgorithmRecord> algorithms = side_records<AlgorithmRecord>(study);
  for (CurveTally& curve : tally.curves) {
    for (std::size_t axis = 0; axis < 3; ++axis) add_medians(axis, curve);
    add_volume(curve);
    const AlgorithmRecord* algorithm =
        find_algorithm_record(algorithms, curve.key.algorithm, curve.key.options);
    if (algorithm != nullptr && algorithm->theorem.promises_box()) {
      curve.theorem_formula = algorithm->theorem.formula();
      if (algorithm->published) curve.published_formula = algorithm->published->formula();
    }
  }
}

void refuse_laws_above_theorems(const StudyIdentity& identity, std::vector<ScalingEntry>& scaling) {
  const std::vector<AlgorithmRecord> records = side_records<AlgorithmRecord>(identity);
  for (ScalingEntry& entry : scaling) {
    const AlgorithmRecord* record =
        find_algorithm_record(records, entry.key.algorithm, entry.key.options);
    if (record == nullptr) continue;
    if (const auto order = theorem_order(record->theorem, entry.quantity)) {
      refuse_law_above(*order, entry);
    }
  }
}

}  // namespace

std::optional<std::size_t> worst_axis(const CurveTally& curve) {
  std::optional<std::size_t> worst;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (curve.axes[axis].measured == 0) continue;
    if (!worst || curve.axes[axis].worst_slack < curve.axes[*worst].worst_slack) worst = axis;
  }
  return worst;
}

StudyAnalysis analyse(const Rows& rows, CheckVerdict verdict) {
  StudyTally tally = tally_of(rows, verdict.is_last_repetition);
  StudyAnalysis analysis{rows, std::move(verdict), std::move(tally), {}};
  add_bounds(rows.identity(), analysis.tally);
  analysis.scaling = scaling(analysis.tally);
  refuse_laws_above_theorems(rows.identity(), analysis.scaling);
  return analysis;
}

StudyAnalysis analyse(const Rows& rows) { return analyse(rows, check(rows)); }

}  // namespace ar3d
