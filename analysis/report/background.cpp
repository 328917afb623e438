// What changed since the reference, every metric whatever metrics there are, the environment, and
// batches that threads or ranks share.
#include <algorithm>
#include <array>
#include <cmath>

#include "ar3d/analysis/report/sections.h"
#include "ar3d/analysis/statistics.h"
#include "ar3d/store/columns/run_columns.h"

namespace ar3d::report {
namespace {

constexpr std::array kVerdicts = {Verdict::violated, Verdict::regressed, Verdict::inconclusive,
                                  Verdict::unjudged, Verdict::improved,  Verdict::pass};

double time_ratio(const CellComparison& cell) {
  return cell.time.pairs == 0 ? kMissing : std::exp(cell.time.estimate);
}

/// The one of two ratios that is farther from 1.
double farther(double a, double b) {
  if (!std::isfinite(a)) return b;
  return std::isfinite(b) && std::abs(std::log(b)) > std::abs(std::log(a)) ? b : a;
}

void add_since_settings(TableMaker& make, const Comparison& comparison) {
  std::map<std::string, std::vector<const CellComparison*>> settings;
  for (const CellComparison& cell : comparison.cells) {
    settings[algorithm_label(cell.key)].push_back(&cell);
  }
  for (const auto& [label, cells] : settings) {
    std::vector<TableCell> row = {label};
    for (const Verdict verdict : kVerdicts) {
      row.emplace_back(std::ranges::count(cells, verdict, &CellComparison::verdict));
    }
    double time = kMissing, volume = kMissing;  // ratios, the ones farthest from 1
    for (const CellComparison* cell : cells) {
      time = farther(time, time_ratio(*cell));
      volume = farther(volume, std::exp2(cell->log2_volume_change));
    }
    row.insert(row.end(), {time, volume});
    make.table("since_settings").add(std::move(row));
  }
}

/// The cells that are neither a plain pass nor merely unjudged or inconclusive, the heaviest
/// verdicts first.
void add_since_cells(TableMaker& make, const Comparison& comparison) {
  Table& table = make.table("since_cells");
  for (const Verdict verdict : kVerdicts) {
    for (const CellComparison& cell : comparison.cells) {
      const bool is_plain = verdict == Verdict::pass || verdict == Verdict::unjudged;
      if (verdict == Verdict::inconclusive || cell.verdict != verdict) continue;
      if (is_plain && cell.reason.empty()) continue;
      table.add({to_string(verdict), algorithm_label(cell.key), family_label(cell.key),
                 count_or_none(cell.n), time_ratio(cell), std::exp(cell.instructions),
                 std::exp(cell.cycles), std::exp2(cell.log2_volume_change), cell.reason});
    }
  }
}

void add_since(TableMaker& make) {
  Table& since = make.table("since");
  if (!make.since.comparison) {
    since.add({make.since.why_none, {}, {}, {}, {}, {}, {}, {}, {}});
    return;
  }
  const Comparison& comparison = *make.since.comparison;
  since.add({{},
             make.since.file,
             make.since.created,
             comparison.word(),
             comparison.judged(),
             comparison.rows,
             comparison.cells.size(),
             comparison.is_copy,
             comparison.time_judged});
  Table& environment = make.table("since_environment");
  for (const EnvironmentChange& change : comparison.environment) {
    environment.add({change.name, change.base, change.now, change.differs()});
  }
  Table& remarks = make.table("since_remarks");
  for (const std::string& line : comparison.incomplete) remarks.add({true, line});
  for (const std::string& line : comparison.remarks) remarks.add({false, line});
  add_since_settings(make, comparison);
  add_since_cells(make, comparison);
}

void add_metrics(TableMaker& make) {
  Table& names = make.table("metrics");
  for (const Metric& metric : metrics()) names.add({metric.name, metric.unit, metric.definition});
  Table& values = make.table("metric_values");
  for (std::size_t i = 0; i < make.sections.size(); ++i) {
    std::int64_t n = -1;
    std::vector<const DrawnGraph*> graphs;
    for (const SectionCurve& curve : make.sections[i].curves) {
      for (const auto& [size_n, size] : curve.tally->sizes) {
        if (size.drawn == 0 || size_n < n) continue;
        if (size_n > n) graphs.clear();
        n = size_n;
        for (const DrawnGraph& graph : size.graphs) graphs.push_back(&graph);
      }
    }
    for (std::size_t metric = 0; metric < metrics().size(); ++metric) {
      std::vector<double> of;
      for (const DrawnGraph* graph : graphs) {
        if (!std::isnan(graph->metrics[metric])) of.push_back(graph->metrics[metric]);
      }
      if (of.empty()) continue;
      const auto [least, largest] = std::ranges::minmax(of);
      values.add({metric, i, n, median(of), least, largest});
    }
  }
}

/// Returns how many threads could run at the same time where the study was made; 0: not known.
std::int64_t cores_of(const std::vector<EnvironmentEntry>& environment) {
  std::int64_t cores = 0;
  for (const EnvironmentEntry& entry : environment) {
    if (entry.name == "affinity" && std::isdigit(static_cast<unsigned char>(entry.value[0])) != 0)
      cores = std::ranges::count(entry.value, ',') + 1;
  }
  for (const EnvironmentEntry& entry : environment) {
    if (entry.name != "cpu_quota") continue;
    cores = std::min(cores, static_cast<std::int64_t>(std::ceil(std::atof(entry.value.c_str()))));
  }
  return cores;
}

/// The part of the work that is not shared, by the law of Amdahl (1967), of a batch that took so
/// many times its ideal time.
double serial_part(double slower, double workers) { return (slower - 1) / (workers - 1); }

void add_scaling(TableMaker& make) {
  Table& table = make.table("scaling");
  const std::int64_t cores = cores_of(make.analysis.rows.environment());
  for (const auto& [key, batch] : make.analysis.tally.batches) {
    const auto& [phase, algorithm, family, n, count] = key;
    const auto workers = static_cast<double>(count);
    const double batch_s = median(batch[0]), ideal_s = median(batch[1]);
    const auto [low, high] = median_interval(batch[0]);
    std::vector<TableCell> row = {algorithm,
                                  is_strong(phase) ? "strong" : "weak",
                                  is_over_ranks(phase) ? "ranks" : "threads",
                                  family,
                                  n,
                                  count,
                                  batch_s,
                                  ideal_s,
                                  ideal_s / batch_s,
                                  ideal_s / batch_s * workers,
                                  low,
                                  high,
                                  !is_over_ranks(phase) && cores > 0 && count > cores};
    if (is_strong(phase) && count > 1) {
      for (const double seconds : {batch_s, low, high}) {
        row.emplace_back(serial_part(seconds / ideal_s, workers));
      }
    }
    row.resize(table.columns.size());
    table.add(std::move(row));
  }
}

}  // namespace

void add_background(TableMaker& make) {
  add_since(make);
  add_metrics(make);
  add_scaling(make);
  Table& table = make.table("environment");
  for (const EnvironmentEntry& entry : make.analysis.rows.environment()) {
    table.add({entry.name, entry.value});
  }
}

}  // namespace ar3d::report
