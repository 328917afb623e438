// The tables with a row a curve: bounds and growth (their first columns are `--csv` and
// `--growth`), the share of the bound by family and n, edges by bends.
#include <algorithm>
#include <array>
#include <cmath>

#include "ar3d/analysis/replay.h"
#include "ar3d/analysis/report/sections.h"
#include "ar3d/analysis/scaling/samples.h"

namespace ar3d::report {
namespace {

using enum CellType;

constexpr std::size_t kEndsNamed = 2;  // families with the largest values, and with the least
constexpr std::size_t kAllNamed = 6;   // so few families are all drawn and named
constexpr std::size_t kMostShareBins = 16;

/// Where a curve stands in the sections.
struct CurvePlace {
  std::size_t setting = 0;
  const SectionCurve* curve = nullptr;
  bool is_shown = false;
};
using CurvePlaces = std::map<std::size_t, CurvePlace>;

CurvePlaces places_of(const std::vector<Section>& sections) {
  CurvePlaces places;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    for (const SectionCurve& curve : sections[i].curves) places[curve.place] = {i, &curve, false};
    for (const SectionCurve& curve : sections[i].shown) places[curve.place].is_shown = true;
  }
  return places;
}

void add_key(const CurveKey& key, std::vector<TableCell>& row) {
  for (const std::string& part :
       {key.algorithm, options_and_level(key), key.family, key.parameters}) {
    row.emplace_back(part);
  }
}

std::vector<TableColumn> key_columns() {
  return {{"algorithm", "", "the algorithm"},
          {"options", "", "its options, with the level"},
          {"family", "", "the family"},
          {"parameters", "", "its parameters"}};
}

/// The smallest slack over the axes.
double worst_of(const BoundsEntry& entry, double AxisBounds::*slack) {
  double worst = kMissing;
  for (const AxisBounds& axis : entry.axes) worst = std::fmin(worst, axis.*slack);
  return worst;
}

constexpr std::array kSlacks = {
    &AxisBounds::worst_slack,           &AxisBounds::median_slack,
    &AxisBounds::worst_instance_slack,  &AxisBounds::median_instance_slack,
    &AxisBounds::worst_published_slack, &AxisBounds::median_published_slack};
constexpr std::array<std::array<const char*, 6>, 3> kSlackNames = {
    {{"worst_slack_x", "median_slack_x", "worst_instance_slack_x", "median_instance_slack_x",
      "worst_published_slack_x", "median_published_slack_x"},
     {"worst_slack_y", "median_slack_y", "worst_instance_slack_y", "median_instance_slack_y",
      "worst_published_slack_y", "median_published_slack_y"},
     {"worst_slack_z", "median_slack_z", "worst_instance_slack_z", "median_instance_slack_z",
      "worst_published_slack_z", "median_published_slack_z"}}};
constexpr std::array<const char*, 6> kSlackMeanings = {
    "1 - extent / theorem's bound, smallest",        "the same, median",
    "1 - extent / the very graph's bound, smallest", "the same, median",
    "1 - extent / published bound, smallest",        "the same, median"};

std::vector<TableColumn> bounds_columns() {
  std::vector<TableColumn> columns = key_columns();
  for (const TableColumn& column : std::initializer_list<TableColumn>{
           {"smallest_n", "vertices", "smallest n", integer},
           {"largest_n", "vertices", "largest n", integer},
           {"rows", "", "rows", integer},
           {"instances", "", "graphs, drawn or not", integer},
           {"violations", "", "rows that break a bound or a certificate", integer},
           {"unproved", "", "ok rows that no exact certificate judged", integer}}) {
    columns.push_back(column);
  }
  for (const auto& names : kSlackNames) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      columns.push_back({names[i], "", kSlackMeanings[i], number, 0});
    }
  }
  for (const TableColumn& column : std::initializer_list<TableColumn>{
           {"log2_volume", "log2 of lattice points", "of the largest n, median", number, 0},
           {"volume_share", "", "volume over the theorem's box there, median", number, 0},
           {"volume_over_least", "", "volume over what any drawing needs, median", number, 0},
           {"worst_command", "", "draws the graph with the smallest slack"},
           {"setting", "", "its row in settings", integer, 0, false},
           {"label", "", "the family with its parameters", text, 0, false},
           {"name", "", "the same, parameters only where two need them", text, 0, false},
           {"is_shown", "", "the page shows the curve", flag, 0, false},
           {"is_collection", "", "graphs of files", flag, 0, false},
           {"ok", "", "ok rows", integer, 0, false},
           {"violated", "", "violated rows", integer, 0, false},
           {"refused", "", "refused rows", integer, 0, false},
           {"timeout", "", "rows that took too long", integer, 0, false},
           {"out_of_memory", "", "rows that took too much memory", integer, 0, false},
           {"crashed", "", "rows that crashed", integer, 0, false},
           {"measured", "", "rows that were measured, not judged", integer, 0, false},
           {"share_x", "", "largest share of the theorem's bound", number, 6, false},
           {"share_y", "", "the same along y", number, 6, false},
           {"share_z", "", "the same along z", number, 6, false},
           {"median_share_x", "", "median share of the theorem's bound", number, 6, false},
           {"median_share_y", "", "the same along y", number, 6, false},
           {"median_share_z", "", "the same along z", number, 6, false},
           {"own_share", "", "largest share of the very graph's bound", number, 6, false},
           {"published_share", "", "largest share of the published bound", number, 6, false},
           {"worst_n", "vertices", "of the graph with the smallest slack", integer, 0, false},
           {"worst_row", "", "its row in /runs", integer, 0, false},
           {"command", "", "the line that draws a graph again, before n", text, 0, false},
           {"command_end", "", "and behind the seed", text, 0, false}}) {
    columns.push_back(column);
  }
  return columns;
}

void add_page_cells(const BoundsEntry& entry, const CurvePlace& at, const ShowCommand& show,
                    std::vector<TableCell>& row) {
  row.emplace_back(at.setting);
  row.emplace_back(at.curve->family);
  row.emplace_back(at.curve->name);
  row.emplace_back(at.is_shown);
  row.emplace_back(at.curve->is_collection);
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
  row.emplace_back(parts.first);
  row.emplace_back(parts.second);
}

/// Which lines a figure names: all if they are few, else those with the largest and the least last
/// values. By curve: 1, 2, …
std::map<std::size_t, std::size_t> named_lines(const Section& section, Quantity quantity) {
  struct Line {
    std::size_t place;
    std::int64_t last_n;
    double last;
  };
  std::vector<Line> lines, to_the_end;
  std::int64_t largest = 0;
  const double order = order_of(section, quantity);
  for (const SectionCurve& curve : section.shown) {
    const ScalingEntry* entry = curve.growth(quantity);
    if (entry == nullptr || entry->reason == kUntimed) continue;
    const SizeSample& last = entry->all.back();
    lines.push_back({curve.place, last.requested_n,
                     median(last.log_values()) - order * std::log(static_cast<double>(last.n))});
    largest = std::max(largest, last.requested_n);
  }
  if (lines.size() > kAllNamed) {
    std::ranges::copy_if(lines, std::back_inserter(to_the_end),
                         [&](const Line& line) { return line.last_n == largest; });
    if (to_the_end.size() >= 2 * kEndsNamed) lines = std::move(to_the_end);
    std::ranges::stable_sort(lines, std::greater(), &Line::last);
    lines.erase(lines.begin() + kEndsNamed, lines.end() - kEndsNamed);
  }
  std::map<std::size_t, std::size_t> named;
  for (const Line& line : lines) named.emplace(line.place, named.size() + 1);
  return named;
}

std::vector<TableColumn> growth_columns() {
  std::vector<TableColumn> columns = key_columns();
  for (const TableColumn& column : std::initializer_list<TableColumn>{
           {"quantity", "", "what grows"},
           {"sizes", "", "sizes that were fitted", integer},
           {"smallest_n", "vertices", "the smallest of them", integer},
           {"largest_n", "vertices", "the largest of them", integer},
           {"exponent", "", "a of n^a over the fitted sizes", number, 0},
           {"exponent_low", "", "its 95 % interval", number, 0},
           {"exponent_high", "", "upper end", number, 0},
           {"law_low", "", "of a power law: the interval for larger n, too", number, 0},
           {"law_high", "", "upper end", number, 0},
           {"log_exponent", "", "b of n^a log^b n", number, 0},
           {"log_exponent_low", "", "its 95 % interval", number, 0},
           {"log_exponent_high", "", "upper end", number, 0},
           {"log_weight", "", "Akaike weight of that model", number, 0},
           {"growth", "", "power law, power law with logarithm, apparent exponent or undecided"},
           {"reason", "", "why so"},
           {"next", "", "what would decide"},
           {"curve", "", "its row in bounds", integer, 0, false},
           {"low", "", "the interval that is told: law_… of a power law, else exponent_…", number,
            6, false},
           {"high", "", "upper end", number, 6, false},
           {"of_sizes", "", "sizes that were measured", integer, 0, false},
           {"unfinished", "", "rows that ended before they had a value", integer, 0, false},
           {"untimed", "", "a drawing time without rows of the timing phase", flag, 0, false},
           {"named", "", "place among the lines that a figure names; missing: it is not", integer,
            0, false}}) {
    columns.push_back(column);
  }
  return columns;
}

void add_growth_row(const ScalingEntry& entry, std::size_t curve, std::size_t named, Table& table) {
  const auto& used = entry.sizes.used;
  std::vector<TableCell> row;
  add_key(entry.key, row);
  row.emplace_back(name_of(entry.quantity));
  row.emplace_back(used.size());
  row.push_back(used.empty() ? TableCell() : TableCell(used.front().n));
  row.push_back(used.empty() ? TableCell() : TableCell(used.back().n));
  const CurveFit &power = entry.power, &log = entry.with_log;
  const Interval told = told_interval(entry);
  for (const double value :
       {power.fitted ? power.exponent : kMissing, power.exponent_interval.low,
        power.exponent_interval.high, entry.law_interval.low, entry.law_interval.high,
        log.fitted ? log.log_exponent : kMissing, log.log_exponent_interval.low,
        log.log_exponent_interval.high, entry.log_weight}) {
    row.emplace_back(value);
  }
  row.emplace_back(to_string(entry.growth));
  row.emplace_back(entry.reason);
  row.emplace_back(entry.next);
  row.emplace_back(curve);
  row.emplace_back(told.low);
  row.emplace_back(told.high);
  row.emplace_back(entry.all.size());
  row.emplace_back(entry.censored.size());
  row.emplace_back(entry.reason == kUntimed);
  row.push_back(named == 0 ? TableCell() : TableCell(named));
  table.add(std::move(row));
}

void add_shares(TableMaker& make) {
  Table& table = make.start("shares", "a curve and a bin of n: the graph closest to its bound",
                            {{"setting", "", "its row in settings", integer},
                             {"curve", "", "its row in bounds", integer},
                             {"first_n", "vertices", "smallest n of the bin", integer},
                             {"last_n", "vertices", "largest n of the bin", integer},
                             {"share", "", "largest share of the theorem's bound", number, 4},
                             {"row", "", "its graph's row in /runs", integer}});
  for (std::size_t i = 0; i < make.sections.size(); ++i) {
    std::set<std::int64_t> sizes;
    for (const SectionCurve& curve : make.sections[i].shown) {
      for (const auto& [n, graph] : worst_by_size(*curve.tally)) sizes.insert(n);
    }
    for (const SectionCurve& curve : make.sections[i].shown) {
      const auto shares = worst_by_size(*curve.tally);
      for (const SizeBin& bin : size_bins(sizes, kMostShareBins)) {
        const DrawnGraph* closest = nullptr;
        for (auto at = shares.lower_bound(bin.first); at != shares.end() && at->first <= bin.last;
             ++at) {
          if (closest == nullptr || at->second->share() > closest->share()) closest = at->second;
        }
        if (closest == nullptr) continue;
        table.add({i, curve.place, bin.first, bin.last, closest->share(),
                   make.graphs.add(curve.place, *closest)});
      }
    }
  }
}

void add_bends(TableMaker& make) {
  Table& table = make.start("bends", "a setting's edges with so many bends",
                            {{"setting", "", "its row in settings", integer},
                             {"bends", "", "bends; 7: or more", integer},
                             {"edges", "", "edges", integer},
                             {"share", "", "of all its edges", number, 5}});
  for (std::size_t i = 0; i < make.sections.size(); ++i) {
    std::array<std::uint64_t, 8> bends{};
    double edges = 0;
    for (const SectionCurve& curve : make.sections[i].curves) {
      for (std::size_t b = 0; b < bends.size(); ++b) {
        bends[b] += curve.bounds->bends[b];
        edges += static_cast<double>(curve.bounds->bends[b]);
      }
    }
    for (std::size_t b = 0; b < bends.size(); ++b) {
      if (bends[b] > 0) table.add({i, b, bends[b], static_cast<double>(bends[b]) / edges});
    }
  }
}

}  // namespace

Table bounds_table_of(const StudyAnalysis& analysis, const std::vector<Section>& sections) {
  Table table{"bounds", "a curve: a setting on a family", bounds_columns()};
  const ShowCommand show(analysis.rows);
  const CurvePlaces places = places_of(sections);
  for (std::size_t i = 0; i < analysis.bounds.size(); ++i) {
    const BoundsEntry& entry = analysis.bounds[i];
    std::vector<TableCell> row;
    add_key(entry.key, row);
    for (const std::int64_t n : {entry.smallest_n, entry.largest_n}) row.emplace_back(n);
    for (const std::size_t count :
         {entry.rows, entry.instances, entry.violations, entry.unproved}) {
      row.emplace_back(count);
    }
    for (const AxisBounds& axis : entry.axes) {
      for (const auto slack : kSlacks) row.emplace_back(axis.*slack);
    }
    for (const double value : {entry.log2_volume, entry.volume_share, entry.volume_over_least}) {
      row.emplace_back(value);
    }
    const auto worst = worst_axis(entry);
    row.emplace_back(worst ? show(entry.key, entry.axes[*worst].worst) : "");
    if (const auto at = places.find(i); at != places.end()) {
      add_page_cells(entry, at->second, show, row);
    }
    row.resize(table.columns.size());
    table.add(std::move(row));
  }
  return table;
}

Table growth_table_of(const StudyAnalysis& analysis, const std::vector<Section>& sections) {
  Table table{"growth", "a curve and a quantity: how it grows with n", growth_columns()};
  std::map<CurveKey, std::size_t> curve_of_key;
  for (std::size_t i = 0; i < analysis.bounds.size(); ++i) {
    curve_of_key.emplace(analysis.bounds[i].key, i);
  }
  std::map<std::pair<std::size_t, Quantity>, std::size_t> named;
  for (const Section& section : sections) {
    for (const Quantity quantity : {Quantity::longest_side, Quantity::volume, Quantity::wall_s}) {
      for (const auto& [place, rank] : named_lines(section, quantity)) {
        named[{place, quantity}] = rank;
      }
    }
  }
  for (const ScalingEntry& entry : analysis.scaling) {
    const std::size_t curve = curve_of_key.at(entry.key);
    const auto rank = named.find({curve, entry.quantity});
    add_growth_row(entry, curve, rank == named.end() ? 0 : rank->second, table);
  }
  return table;
}

void add_families(TableMaker& make) {
  for (const CurveTally& curve : make.analysis.tally.curves) {
    const auto place = static_cast<std::size_t>(&curve - make.analysis.tally.curves.data());
    const BoundsEntry& entry = make.analysis.bounds[place];
    if (const auto worst = worst_axis(entry)) make.graphs.add(place, entry.axes[*worst].worst);
  }
  make.tables.push_back(bounds_table_of(make.analysis, make.sections));
  make.tables.push_back(growth_table_of(make.analysis, make.sections));
  add_shares(make);
  add_bends(make);
}

}  // namespace ar3d::report
