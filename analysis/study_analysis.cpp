// The bounds table, and everything else that report and exports show of a study, computed once.
#include "ar3d/analysis/report.h"

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

AxisBounds axis_bounds(const CurveTally& curve, std::size_t axis) {
  AxisBounds entry = curve.axes[axis];
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
  return entry;
}

void add_volume(const CurveTally& curve, BoundsEntry& entry) {
  const auto last = std::find_if(curve.sizes.rbegin(), curve.sizes.rend(),
                                 [](const auto& size) { return size.second.drawn > 0; });
  if (last == curve.sizes.rend()) return;
  entry.volume_n = last->first;
  std::vector<double> volumes, shares, over_least;
  for (const DrawnGraph& graph : last->second.graphs) {
    volumes.push_back(graph.log2_volume);
    const double log_volume = log_value(graph, Quantity::volume, false);
    shares.push_back(std::exp(log_volume - log_bound(graph, Quantity::volume)));
    over_least.push_back(std::exp(log_volume - log_volume_at_least(graph)));
  }
  entry.log2_volume = median(std::move(volumes));
  entry.volume_share = median(std::move(shares));
  entry.volume_over_least = median(std::move(over_least));
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

std::vector<BoundsEntry> bounds_table(const StudyTally& tally, const StudyIdentity& study) {
  std::vector<BoundsEntry> entries;
  const std::vector<AlgorithmRecord> algorithms = side_records<AlgorithmRecord>(study);
  for (const CurveTally& curve : tally.curves) {
    BoundsEntry entry;
    static_cast<CurveCounts&>(entry) = static_cast<const CurveCounts&>(curve);
    for (std::size_t axis = 0; axis < 3; ++axis) entry.axes[axis] = axis_bounds(curve, axis);
    add_volume(curve, entry);
    const AlgorithmRecord* algorithm =
        find_algorithm_record(algorithms, curve.key.algorithm, curve.key.options);
    if (algorithm != nullptr && algorithm->theorem.promises_box()) {
      entry.theorem_formula = algorithm->theorem.formula();
      if (algorithm->published) entry.published_formula = algorithm->published->formula();
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

std::vector<BoundsEntry> bounds_table(const Results& results) {
  return bounds_table(tally_of(results), results);
}

std::optional<std::size_t> worst_axis(const BoundsEntry& entry) {
  std::optional<std::size_t> worst;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (entry.axes[axis].measured == 0) continue;
    if (!worst || entry.axes[axis].worst_slack < entry.axes[*worst].worst_slack) worst = axis;
  }
  return worst;
}

StudyAnalysis analyse(const RowView& rows, CheckedRows examination) {
  StudyAnalysis analysis{rows, std::move(examination.verdict), {}, {}, {}};
  analysis.tally = tally_of(rows, examination.is_last_repetition);
  analysis.bounds = bounds_table(analysis.tally, *rows.identity);
  analysis.scaling = scaling(analysis.tally);
  refuse_laws_above_theorems(*rows.identity, analysis.scaling);
  return analysis;
}

StudyAnalysis analyse(const RowView& rows) { return analyse(rows, examine(rows)); }

}  // namespace ar3d
