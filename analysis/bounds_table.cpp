#include "ar3d/analysis/bounds_table.h"

#include <algorithm>
#include <cmath>

#include "ar3d/analysis/check.h"
#include "ar3d/analysis/scaling/samples.h"
#include "ar3d/analysis/statistics.h"
#include "ar3d/records/algorithm_table.h"

namespace ar3d {
namespace {

double slack_of(std::int64_t extent, double bound) {
  if (extent < 0 || !std::isfinite(bound) || bound <= 0) return kMissing;
  return 1 - static_cast<double>(extent) / bound;
}

double smallest(const std::vector<double>& values) {
  return values.empty() ? kMissing : *std::min_element(values.begin(), values.end());
}

/// The first ok row of every instance.
std::vector<std::size_t> measured_rows(const Results& results, const Cell& cell) {
  std::vector<std::size_t> rows;
  for (const InstanceRows& instance : cell.instances) {
    const RunRecord* run = first_ok(results, instance);
    if (run != nullptr) rows.push_back(static_cast<std::size_t>(run - results.runs.data()));
  }
  return rows;
}

void add_slack(std::int64_t extent, double bound, std::vector<double>& slacks) {
  const double slack = slack_of(extent, bound);
  if (!std::isnan(slack)) slacks.push_back(slack);
}

AxisBounds axis_bounds(const Results& results, const std::vector<std::size_t>& rows,
                       std::size_t axis) {
  AxisBounds entry;
  std::vector<double> theorem, instance, published;
  for (const std::size_t row : rows) {
    const RunRecord& run = results.runs[row];
    const double slack = slack_of(run.extents[axis], run.theorem_bound[axis]);
    if (!std::isnan(slack) && (!entry.worst_row || slack < entry.worst_slack)) {
      entry.worst_slack = slack;
      entry.worst_row = row;
    }
    add_slack(run.extents[axis], run.theorem_bound[axis], theorem);
    add_slack(run.extents[axis], static_cast<double>(run.instance_bound[axis]), instance);
    add_slack(run.extents[axis], run.published_bound[axis], published);
  }
  entry.measured = theorem.size();
  entry.median_slack = median(theorem);
  entry.worst_instance_slack = smallest(instance);
  entry.median_instance_slack = median(instance);
  entry.worst_published_slack = smallest(published);
  entry.median_published_slack = median(published);
  return entry;
}

VolumeBound volume_bound(const Results& results, const std::vector<std::size_t>& rows) {
  VolumeBound volume;
  for (const std::size_t row : rows) volume.n = std::max(volume.n, results.runs[row].n);
  std::vector<double> volumes, shares;
  for (const std::size_t row : rows) {
    const RunRecord& run = results.runs[row];
    if (run.n != volume.n) continue;
    volumes.push_back(run.log2_volume);
    shares.push_back(std::exp(log_value(run, Quantity::volume) - log_bound(run, Quantity::volume)));
  }
  volume.log2_volume = median(std::move(volumes));
  volume.share = median(std::move(shares));
  return volume;
}

void count_rows(const Results& results, const Cell& cell, BoundsEntry& entry) {
  for (const std::size_t row : cell.rows) {
    const RunRecord& run = results.runs[row];
    ++entry.rows_of_status[static_cast<std::size_t>(run.status)];
    entry.violations += breaks_promise(run);
  }
}

void add_bends(const Results& results, const std::vector<std::size_t>& rows, BoundsEntry& entry) {
  for (const std::size_t row : rows) {
    for (std::size_t b = 0; b < entry.bends.size(); ++b) {
      const std::int64_t edges = results.runs[row].bends[b];
      if (edges > 0) entry.bends[b] += static_cast<std::uint64_t>(edges);
    }
  }
}

}  // namespace

std::vector<BoundsEntry> bounds_table(const Results& results) {
  std::vector<BoundsEntry> entries;
  const std::vector<AlgorithmRecord> algorithms = algorithm_records(results);
  for (const Cell& cell : cells(results)) {
    BoundsEntry entry;
    entry.key = cell.key;
    entry.smallest_n = cell.instances.front().n;
    entry.largest_n = cell.instances.back().n;
    entry.rows = cell.rows.size();
    entry.instances = cell.instances.size();
    count_rows(results, cell, entry);
    const std::vector<std::size_t> rows = measured_rows(results, cell);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      entry.axes[axis] = axis_bounds(results, rows, axis);
    }
    entry.volume = volume_bound(results, rows);
    const AlgorithmRecord* algorithm =
        find_algorithm_record(algorithms, results.runs[cell.rows.front()]);
    if (algorithm != nullptr) {
      entry.theorem_formula = algorithm->theorem.formula();
      if (algorithm->published) entry.published_formula = algorithm->published->formula();
    }
    add_bends(results, rows, entry);
    entries.push_back(std::move(entry));
  }
  return entries;
}

std::optional<std::size_t> worst_axis(const BoundsEntry& entry) {
  std::optional<std::size_t> worst;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (entry.axes[axis].measured == 0) continue;
    if (!worst || entry.axes[axis].worst_slack < entry.axes[*worst].worst_slack) worst = axis;
  }
  return worst;
}

}  // namespace ar3d
