// What accuracy costs: the drawings in real types with their misses, of which the page makes its
// statistics, and what certificates and levels of detail take.
#include <tuple>

#include "ar3d/analysis/report/sections.h"
#include "ar3d/analysis/statistics.h"
#include "ar3d/store/columns/run_columns.h"

namespace ar3d::report {
namespace {

constexpr std::size_t kMostLookedAt = 200000, kMostReal = 200000, kMostRealOfPage = 40000;
constexpr std::size_t kMostJudged = 2000, kMostJudgedSizes = 16, kMostPointsOfCurve = 3000;

/// Algorithm with its options, n, certificate and level.
using JudgedKey = std::tuple<std::string, std::int64_t, std::string, std::string>;
/// By a vertex: seconds of drawing, storing and certifying, and bytes; then 1 if it is violated.
using Costs = std::array<double, 5>;
using Judged = std::map<JudgedKey, std::vector<Costs>>;

void add_judgement(const RunRecord& run, Judged& judged) {
  const JudgedKey key{algorithm_label({run.algorithm, run.options, {}, {}, {}}), run.n,
                      asked_certificate(run), run.level.empty() ? "extents" : run.level};
  if (judged.size() == kMostJudged && !judged.contains(key)) return;
  const auto n = static_cast<double>(run.n);
  const bool has_own_peak = (run.peak_scope == "row" || run.peak_scope == "worker") &&
                            run.base_bytes >= 0 && run.peak_bytes > run.base_bytes;
  judged[key].push_back(
      {run.cpu_s / n, run.store_s / n, run.certify_s / n,
       has_own_peak ? static_cast<double>(run.peak_bytes - run.base_bytes) / n : kMissing,
       run.status == RunStatus::violated ? 1.0 : 0.0});
}

/// Puts many n together by bins, under the largest n of each.
Judged in_bins(Judged judged) {
  std::set<std::int64_t> sizes;
  for (const auto& [key, costs] : judged) sizes.insert(std::max<std::int64_t>(1, std::get<1>(key)));
  if (sizes.size() <= kMostJudgedSizes) return judged;
  const std::vector<SizeBin> bins = size_bins(sizes, kMostJudgedSizes);
  Judged merged;
  for (const auto& [key, costs] : judged) {
    JudgedKey binned = key;
    std::int64_t& n = std::get<1>(binned);
    n = std::ranges::find_if(bins, [&](const SizeBin& bin) { return n <= bin.last; })->last;
    std::ranges::copy(costs, std::back_inserter(merged[binned]));
  }
  return merged;
}

std::vector<double> part_of(const std::vector<Costs>& costs, std::size_t part) {
  std::vector<double> values;
  for (const Costs& one : costs) values.push_back(one[part]);
  return values;
}

void add_judgements(TableMaker& make, const Judged& judged) {
  Table& table = make.table("judgements");
  std::map<std::pair<std::string, std::int64_t>, std::set<std::string>> levels;
  std::set<std::string> modes = {"exact"};
  for (const auto& [key, costs] : judged) {
    const auto& [algorithm, n, certificate, level] = key;
    levels[{algorithm, n}].insert(level);
    if (certificate != "measured") modes.insert(certificate);
  }
  const bool has_levels =
      std::ranges::any_of(levels, [](const auto& entry) { return entry.second.size() > 1; });
  if (modes.size() == 1 && !has_levels) return;
  for (const auto& [key, costs] : judged) {
    const auto& [algorithm, n, certificate, level] = key;
    std::vector<TableCell> row = {algorithm,
                                  n,
                                  certificate,
                                  level,
                                  costs.size(),
                                  std::ranges::count(part_of(costs, 4), 1.0),
                                  levels[{algorithm, n}].size() > 1,
                                  median(part_of(costs, 3))};
    for (const std::size_t part : {0U, 1U, 2U}) {
      for (const double share : {0.5, 0.1, 0.9}) {
        row.emplace_back(quantile(part_of(costs, part), share));
      }
    }
    table.add(std::move(row));
  }
}

/// Rows of drawings that were judged without tolerance, ascending, by family.
using RealRows = std::map<std::string, std::vector<std::size_t>>;

/// Adds, of the family with most of these drawings, which figures show, the graphs.
void add_real_graphs(const RealRows& rows_of, TableMaker& make) {
  const auto most = std::ranges::max_element(
      rows_of, {}, [](const auto& of_family) { return of_family.second.size(); });
  for (std::size_t i = 0; i < make.analysis.tally.curves.size(); ++i) {
    const CurveTally& curve = make.analysis.tally.curves[i];
    if (family_label(curve.key) != most->first) continue;
    std::size_t added = 0;
    for (const auto& [n, size] : curve.sizes) {
      for (const DrawnGraph& graph : size.graphs) {
        if (!std::ranges::binary_search(most->second, graph.row)) continue;
        if (!make.all && ++added > kMostPointsOfCurve) break;
        make.add_graph(i, graph);
      }
    }
  }
}

}  // namespace

void add_precision(TableMaker& make) {
  const Rows& rows = make.analysis.rows;
  const bool is_all_proved = make.analysis.verdict.unproved == 0;  // then only levels are sought
  const std::size_t count = is_all_proved ? std::min(rows.size(), kMostLookedAt) : rows.size();
  std::map<CurveKey, std::size_t> indices;
  for (const CurveTally& curve : make.analysis.tally.curves) {
    indices.emplace(curve.key, indices.size());
  }
  Table& real = make.table("real_drawings");
  RealRows rows_of;
  std::size_t left_out = 0;
  const auto add_real = [&](const RunRecord& run, std::size_t row) {
    const auto value = [&run](const char* metric) { return metric_of(run, metric); };
    if (run.repetition > 0 || !(value("angle_miss") >= 0)) return;
    const auto curve = indices.find(curve_of(run));
    if (real.size() == (make.all ? kMostReal : kMostRealOfPage) || curve == indices.end()) {
      ++left_out;
      return;
    }
    rows_of[family_label(curve->first)].push_back(row);
    real.add({row, curve->second, bin_of(make.bins, run.n).n, run.n, value("angle_miss"),
              value("condition"), value("within_1e_12"), value("within_1e_9"), value("within_1e_6"),
              value("within_1e_3"), value("collapsed_segments") > 0 || value("crossings") > 0,
              run.cpu_s});
  };
  Judged judged;
  for (std::size_t row = 0; row < count; ++row) {
    const RunRecord& run = rows.run(row);
    const bool is_judged = run.status == RunStatus::ok || run.status == RunStatus::violated;
    if (run.n < 1 || run.phase != RunPhase::metrics) continue;
    if (is_judged) add_judgement(run, judged);
    if (is_judged || run.status == RunStatus::measured) add_real(run, row);
  }
  if (!rows_of.empty()) {
    make.table("precision").add({real.size(), left_out});
    add_real_graphs(rows_of, make);
  }
  add_judgements(make, in_bins(std::move(judged)));
}

}  // namespace ar3d::report
