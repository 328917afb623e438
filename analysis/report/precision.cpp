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

/// The drawings that were judged without tolerance: first repetitions of the metrics phase.
class RealDrawings {
 public:
  explicit RealDrawings(TableMaker& make) : make_(make) {
    for (const CurveTally& curve : make.analysis.tally.curves) {
      indices_.emplace(curve.key, indices_.size());
    }
  }

  void add(const RunRecord& run, std::size_t row) {
    if (run.repetition > 0) return;
    const std::vector<char> record = metrics_record(run);
    const auto value = [&](const Column& of) { return column_number(of, record.data()); };
    if (!(value(miss_) >= 0)) return;
    const auto curve = indices_.find(curve_of(run));
    if (table_.size() == (make_.all ? kMostReal : kMostRealOfPage) || curve == indices_.end()) {
      ++left_out_;
      return;
    }
    rows_of_[family_label(curve->first)].push_back(row);
    const std::int64_t about = bin_of(make_.bins, run.n).n;
    std::vector<TableCell> cells = {row,   curve->second, about,
                                    run.n, value(miss_),  value(condition_)};
    for (const Column& within : within_) cells.emplace_back(value(within));
    cells.emplace_back(value(collapsed_) > 0 || value(crossings_) > 0);
    cells.emplace_back(run.cpu_s);
    table_.add(std::move(cells));
  }

  /// Adds, of the family with most drawings, which figures show, the graphs.
  void finish() {
    const auto most = std::ranges::max_element(
        rows_of_, {}, [](const auto& of_family) { return of_family.second.size(); });
    if (most == rows_of_.end()) return;
    make_.table("precision").add({table_.size(), left_out_});
    for (const auto& [key, index] : indices_) {
      if (family_label(key) == most->first) add_graphs(index, most->second);
    }
  }

 private:
  void add_graphs(std::size_t curve, const std::vector<std::size_t>& rows) {
    std::size_t added = 0;
    for (const auto& [n, size] : make_.analysis.tally.curves[curve].sizes) {
      for (const DrawnGraph& graph : size.graphs) {
        if (!std::ranges::binary_search(rows, graph.row)) continue;
        if (!make_.all && ++added > kMostPointsOfCurve) return;
        make_.add_graph(curve, graph);
      }
    }
  }

  TableMaker& make_;
  std::map<CurveKey, std::size_t> indices_;
  std::map<std::string, std::vector<std::size_t>> rows_of_;  // by family, ascending
  std::size_t left_out_ = 0;
  Table& table_ = make_.table("real_drawings");
  const Column miss_ = run_column("angle_miss"), condition_ = run_column("condition"),
               collapsed_ = run_column("collapsed_segments"), crossings_ = run_column("crossings");
  const std::array<Column, 4> within_ = {run_column("within_1e_12"), run_column("within_1e_9"),
                                         run_column("within_1e_6"), run_column("within_1e_3")};
};

}  // namespace

void add_precision(TableMaker& make) {
  const Rows& rows = make.analysis.rows;
  const bool is_all_proved = make.analysis.verdict.unproved == 0;  // then only levels are sought
  const std::size_t count = is_all_proved ? std::min(rows.size(), kMostLookedAt) : rows.size();
  RealDrawings real(make);
  Judged judged;
  for (std::size_t row = 0; row < count; ++row) {
    const RunRecord& run = rows.run(row);
    const bool is_judged = run.status == RunStatus::ok || run.status == RunStatus::violated;
    if (run.n < 1 || run.phase != RunPhase::metrics) continue;
    if (is_judged) add_judgement(run, judged);
    if (is_judged || run.status == RunStatus::measured) real.add(run, row);
  }
  real.finish();
  add_judgements(make, in_bins(std::move(judged)));
}

}  // namespace ar3d::report
