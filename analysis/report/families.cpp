// The tables with a row a curve: bounds and growth (their first columns are `--csv` and
// `--growth`), the share of the bound by family and n, edges by bends.
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "ar3d/analysis/report/sections.h"
#include "ar3d/analysis/scaling/scaling.h"
#include "ar3d/analysis/tally.h"

namespace ar3d::report {
namespace {

constexpr std::size_t kEndsNamed = 2;  // families with the largest values, and with the least
constexpr std::size_t kAllNamed = 6;   // so few families are all drawn and named
constexpr std::size_t kMostShareBins = 16;

std::vector<TableCell> key_cells(const CurveKey& key) {
  return {key.algorithm, options_and_level(key), key.family, key.parameters};
}

/// The smallest slack over the axes.
double worst_of(const CurveTally& entry, double AxisBounds::*slack) {
  double worst = kMissing;
  for (const AxisBounds& axis : entry.axes) worst = std::fmin(worst, axis.*slack);
  return worst;
}

constexpr std::array kSlacks = {
    &AxisBounds::worst_slack,           &AxisBounds::median_slack,
    &AxisBounds::worst_instance_slack,  &AxisBounds::median_instance_slack,
    &AxisBounds::worst_published_slack, &AxisBounds::median_published_slack};
void add_page_cells(const SectionCurve& curve, const ShowCommand& show,
                    std::vector<TableCell>& row) {
  const CurveTally& entry = *curve.tally;
  row.insert(row.end(),
             {curve.setting, curve.family, curve.name, curve.is_shown, curve.is_collection});
  for (const RunStatus status :
       {RunStatus::ok, RunStatus::violated, RunStatus::refused, RunStatus::timeout,
        RunStatus::out_of_memory, RunStatus::crashed, RunStatus::measured}) {
    row.emplace_back(entry.count(status));
  }
  for (const AxisBounds& axis : entry.axes) row.emplace_back(1 - axis.worst_slack);
  for (const AxisBounds& axis : entry.axes) row.emplace_back(1 - axis.median_slack);
  row.emplace_back(1 - worst_of(entry, &AxisBounds::worst_instance_slack));
  row.emplace_back(1 - worst_of(entry, &AxisBounds::worst_published_slack));
  const auto worst = worst_axis(entry);
  row.push_back(worst ? TableCell(entry.axes[*worst].worst.n) : TableCell());
  row.push_back(worst ? TableCell(entry.axes[*worst].worst.row) : TableCell());
  std::pair<std::string, std::string> parts;
  if (!show.needs_results(entry.key)) parts = draw_command_parts(entry.key);
  row.insert(row.end(), {parts.first, parts.second});
}

/// Returns which lines a figure names: all if they are few, else those with the largest and the
/// least last values. By curve: 1, 2, …
std::map<std::size_t, std::size_t> named_lines(const Section& section, Quantity quantity,
                                               const std::vector<SizeBin>& bins) {
  using Line = std::tuple<std::size_t, std::int64_t, double>;  // curve, its last n, value there
  std::vector<Line> lines, to_the_end;
  std::int64_t largest = 0;
  const double order = order_of(section, quantity);
  for (const SectionCurve& curve : section.shown) {
    const ScalingEntry* entry = curve.growth(quantity);
    if (entry == nullptr || entry->reason == kUntimed) continue;
    const SizeSample& last = entry->all.back();
    const std::int64_t last_n = bin_of(bins, last.n).n;
    lines.emplace_back(curve.index, last_n,
                       median(last.log_values()) - order * std::log(static_cast<double>(last.n)));
    largest = std::max(largest, last_n);
  }
  if (lines.size() > kAllNamed) {
    std::ranges::copy_if(lines, std::back_inserter(to_the_end),
                         [&](const Line& line) { return std::get<1>(line) == largest; });
    if (to_the_end.size() >= 2 * kEndsNamed) lines = std::move(to_the_end);
    std::ranges::stable_sort(lines, std::greater(),
                             [](const Line& line) { return std::get<2>(line); });
    lines.erase(lines.begin() + kEndsNamed, lines.end() - kEndsNamed);
  }
  std::map<std::size_t, std::size_t> named;
  for (const Line& line : lines) named.emplace(std::get<0>(line), named.size() + 1);
  return named;
}

void add_growth_row(const ScalingEntry& entry, std::size_t curve, std::size_t named, Table& table) {
  const auto& used = entry.used;
  const CurveFit &power = entry.power, &log = entry.with_log;
  const Interval shown = shown_interval(entry);
  std::vector<TableCell> row = key_cells(entry.key);
  row.insert(row.end(), {name_of(entry.quantity),
                         used.size(),
                         used.empty() ? TableCell() : TableCell(used.front().n),
                         used.empty() ? TableCell() : TableCell(used.back().n),
                         power.fitted ? power.exponent : kMissing,
                         power.exponent_interval.low,
                         power.exponent_interval.high,
                         entry.law_interval.low,
                         entry.law_interval.high,
                         log.fitted ? log.log_exponent : kMissing,
                         log.log_exponent_interval.low,
                         log.log_exponent_interval.high,
                         entry.log_weight,
                         to_string(entry.growth),
                         entry.reason,
                         entry.next,
                         curve,
                         shown.low,
                         shown.high,
                         entry.all.size(),
                         entry.censored,
                         entry.reason == kUntimed,
                         named == 0 ? TableCell() : TableCell(named)});
  table.add(std::move(row));
}

void add_shares(TableMaker& make) {
  Table& table = make.table("shares");
  const std::vector<SizeBin> bins = bins_of_study(make.sections, kMostShareBins);
  for (std::size_t i = 0; i < make.sections.size(); ++i) {
    for (const SectionCurve& curve : make.sections[i].shown) {
      const auto shares = worst_by_size(*curve.tally);
      for (const auto& [first, last, n] : bins) {
        const DrawnGraph* closest = nullptr;
        for (auto at = shares.lower_bound(first); at != shares.end() && at->first <= last; ++at) {
          if (closest == nullptr || at->second->share() > closest->share()) closest = at->second;
        }
        if (closest == nullptr) continue;
        table.add(
            {i, curve.index, first, last, closest->share(), make.add_graph(curve.index, *closest)});
      }
    }
  }
}

void add_bends(TableMaker& make) {
  Table& table = make.table("bends");
  for (std::size_t i = 0; i < make.sections.size(); ++i) {
    std::array<std::uint64_t, 8> bends{};
    double edges = 0;
    for (const SectionCurve& curve : make.sections[i].curves) {
      for (std::size_t b = 0; b < bends.size(); ++b) {
        bends[b] += curve.tally->bends[b];
        edges += static_cast<double>(curve.tally->bends[b]);
      }
    }
    for (std::size_t b = 0; b < bends.size(); ++b) {
      if (bends[b] > 0) table.add({i, b, bends[b], static_cast<double>(bends[b]) / edges});
    }
  }
}

/// The bends per edge of the graphs of every curve and n that have edges; over bins of n what a
/// figure shows of them.
void add_bends_by_n(TableMaker& make) {
  Table& table = make.table("bends_by_n");
  for (std::size_t i = 0; i < make.sections.size(); ++i) {
    std::map<std::int64_t, std::map<std::size_t, std::vector<double>>> bands;  // by bin, by curve
    for (const SectionCurve& curve : make.sections[i].shown) {
      for (const auto& [n, size] : curve.tally->sizes) {
        std::vector<double> bends;
        for (const DrawnGraph& graph : size.graphs) {
          const double per_edge = bends_of(graph) / static_cast<double>(graph.m);
          if (graph.m > 0 && !std::isnan(per_edge)) bends.push_back(per_edge);
        }
        if (bends.empty()) continue;
        const auto [least, largest] = std::ranges::minmax(bends);
        const double middle = median(bends);
        table.add({i, curve.index, n, bends.size(), least, middle, largest});
        bands[bin_of(make.bins, n).n][curve.index].push_back(middle);
      }
    }
    if (!bands.empty()) add_band(make, i, kBendsPerEdge, bands);
  }
}

}  // namespace

void fill_bounds(const StudyAnalysis& analysis, const std::vector<Section>& sections,
                 Table& table) {
  const ShowCommand show(analysis.rows);
  const auto indices = curves_by_index(sections);
  for (std::size_t i = 0; i < analysis.tally.curves.size(); ++i) {
    const CurveTally& entry = analysis.tally.curves[i];
    std::vector<TableCell> row = key_cells(entry.key);
    row.insert(row.end(), {entry.smallest_n, entry.largest_n, entry.rows, entry.instances,
                           entry.violations, entry.unproved});
    for (const AxisBounds& axis : entry.axes) {
      for (const auto slack : kSlacks) row.emplace_back(axis.*slack);
    }
    const auto worst = worst_axis(entry);
    row.insert(row.end(),
               {entry.log2_volume, entry.volume_share, entry.volume_over_least,
                entry.times_the_optimum, worst ? show(entry.key, entry.axes[*worst].worst) : ""});
    if (const auto at = indices.find(i); at != indices.end())
      add_page_cells(*at->second, show, row);
    row.resize(table.columns.size());
    table.add(std::move(row));
  }
}

void fill_growth(const StudyAnalysis& analysis, const std::vector<Section>& sections,
                 Table& table) {
  std::map<CurveKey, std::size_t> curve_of_key;
  for (std::size_t i = 0; i < analysis.tally.curves.size(); ++i) {
    curve_of_key.emplace(analysis.tally.curves[i].key, i);
  }
  std::map<std::pair<std::size_t, Quantity>, std::size_t> named;
  const std::vector<SizeBin> bins = bins_of_study(sections, kMostBinsOfStudy);
  for (const Section& section : sections) {
    for (const Quantity quantity : {nearest_side(section), Quantity::volume, Quantity::wall_s}) {
      for (const auto& [index, rank] : named_lines(section, quantity, bins)) {
        named[{index, quantity}] = rank;
      }
    }
  }
  for (const ScalingEntry& entry : analysis.scaling) {
    const std::size_t curve = curve_of_key.at(entry.key);
    const auto rank = named.find({curve, entry.quantity});
    add_growth_row(entry, curve, rank == named.end() ? 0 : rank->second, table);
  }
}

void add_families(TableMaker& make) {
  const std::vector<CurveTally>& curves = make.analysis.tally.curves;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (const auto worst = worst_axis(curves[i])) make.add_graph(i, curves[i].axes[*worst].worst);
  }
  fill_bounds(make.analysis, make.sections, make.table("bounds"));
  fill_growth(make.analysis, make.sections, make.table("growth"));
  add_shares(make);
  add_bends(make);
  add_bends_by_n(make);
}

}  // namespace ar3d::report
