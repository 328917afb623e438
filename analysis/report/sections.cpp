// The settings of a study with their families, and the graphs that tables point at.
#include "ar3d/analysis/report/sections.h"

#include <algorithm>
#include <numbers>

namespace ar3d::report {
namespace {

/// Marks the curves closest to their bound as shown.
void show_closest(Section& section) {
  std::vector<SectionCurve*> closest;
  for (SectionCurve& curve : section.curves) closest.push_back(&curve);
  std::ranges::stable_sort(closest, {}, &SectionCurve::least_slack);
  if (closest.size() > kMostFamilies) closest.resize(kMostFamilies);
  for (SectionCurve* curve : closest) curve->is_shown = true;
  std::ranges::copy_if(section.curves, std::back_inserter(section.shown), std::identity(),
                       &SectionCurve::is_shown);
}

/// Of each bin's sizes the one nearest to its middle.
void set_middles(const std::set<std::int64_t>& sizes, std::vector<SizeBin>& bins) {
  const auto log_of = [](std::int64_t n) { return log10_of(std::max<std::int64_t>(1, n)); };
  for (SizeBin& bin : bins) {
    const double middle = (log_of(bin.first) + log_of(bin.last)) / 2;
    const auto distance = [&](std::int64_t n) { return std::abs(log_of(n) - middle); };
    for (auto at = sizes.find(bin.first); at != sizes.end() && *at <= bin.last; ++at) {
      if (distance(*at) <= distance(bin.n)) bin.n = *at;
    }
  }
}

void name_families(std::vector<SectionCurve>& curves) {
  std::map<std::string, std::size_t> times;
  for (const SectionCurve& curve : curves) ++times[curve.name];
  for (SectionCurve& curve : curves) {
    if (times.at(curve.tally->key.family) > 1) curve.name = curve.family;
  }
}

}  // namespace

double SectionCurve::least_slack() const {
  double least = std::numeric_limits<double>::infinity();
  for (const AxisBounds& axis : tally->axes) least = std::fmin(least, axis.worst_slack);
  return least;
}

std::vector<Section> sections(const StudyAnalysis& analysis) {
  std::map<CurveKey, std::vector<const ScalingEntry*>> scaling_of;
  for (const ScalingEntry& entry : analysis.scaling) {
    auto& entries = scaling_of[entry.key];
    entries.resize(kQuantities.size());
    entries[static_cast<std::size_t>(entry.quantity)] = &entry;
  }
  const ShowCommand commands(analysis.rows);
  const std::vector<AlgorithmRecord> records =
      side_records<AlgorithmRecord>(analysis.rows.identity());
  std::vector<Section> sections;
  std::map<std::string, std::size_t> index_of;
  for (std::size_t index = 0; index < analysis.tally.curves.size(); ++index) {
    const CurveTally& tally = analysis.tally.curves[index];
    const CurveKey& key = tally.key;
    const auto [at, is_new] = index_of.try_emplace(algorithm_label(key), sections.size());
    if (at->second >= kMostSections) continue;
    if (is_new) {
      Section& section = sections.emplace_back();
      section.label = at->first;
      section.algorithm = key.algorithm;
      if (const auto* record = find_algorithm_record(records, key.algorithm, key.options)) {
        if (record->theorem.promises_box()) section.theorem = record->theorem;
        section.published = record->published;
        section.max_bends = record->max_bends;
      }
    }
    sections[at->second].has_own_unit |= tally.has_own_unit;
    auto scaling = scaling_of[key];
    scaling.resize(kQuantities.size());
    sections[at->second].curves.push_back(
        {index, family_label(key), key.family, &tally, std::move(scaling),
         commands.is_of_file(key.family) && tally.instances >= kFewestOfCollection, at->second});
  }
  for (Section& section : sections) {
    name_families(section.curves);
    show_closest(section);
  }
  return sections;
}

std::map<std::size_t, const SectionCurve*> curves_by_index(const std::vector<Section>& sections) {
  std::map<std::size_t, const SectionCurve*> indices;
  for (const Section& section : sections) {
    for (const SectionCurve& curve : section.curves) indices[curve.index] = &curve;
  }
  return indices;
}

std::size_t count_families(const std::set<std::string>& family_labels) {
  std::set<std::string> names;
  for (const std::string& label : family_labels) names.insert(label.substr(0, label.find(" (")));
  return names.size();
}

std::size_t TableMaker::add_graph(std::size_t curve, const DrawnGraph& graph, bool point) {
  const auto [at, is_new] = graphs.try_emplace(graph.row, curve, DrawnGraph());
  DrawnGraph& noted = at->second.second;
  if (is_new || graph.status != RunStatus::ok) {
    noted = graph;
    noted.metrics.clear();
  }
  if (point) points.insert(graph.row);
  return graph.row;
}

void TableMaker::add_row(std::size_t row) {
  if (graphs.contains(row)) return;
  const RunRecord run = analysis.rows.run(row);
  const auto at = std::ranges::find(analysis.tally.curves, curve_of(run), &CurveTally::key);
  if (at == analysis.tally.curves.end()) return;
  DrawnGraph graph;
  graph.row = row, graph.status = run.status, graph.n = run.n >= 0 ? run.n : run.requested_n,
  graph.m = run.m;
  graph.seed = run.seed, graph.instance = run.instance_index, graph.name = run.graph_name;
  graph.extents = run.extents, graph.theorem_bound = run.theorem_bound;
  graph.published_bound = run.published_bound;
  const auto curve = static_cast<std::size_t>(at - analysis.tally.curves.begin());
  graphs[row] = {curve, graph};
}

void TableMaker::fill_graphs(const std::map<std::size_t, std::size_t>& drawings) {
  Table& listed = table("graphs");
  const auto indices = curves_by_index(sections);
  for (const auto& entry : graphs) {
    const std::uint64_t row = entry.first;
    const auto& [index, graph] = entry.second;
    const bool is_point = points.contains(row);
    const bool timed = analysis.tally.curves[index].has_timing_rows;
    const auto curve = indices.find(index);
    const auto over = [&, &graph = graph](Quantity quantity) {
      if (curve == indices.end() || graph.status != RunStatus::ok || !is_point) return kMissing;
      const double log_n = std::log(static_cast<double>(graph.n));
      return std::exp(log_value(graph, quantity, timed) -
                      order_of(sections[curve->second->setting], quantity) * log_n);
    };
    const auto optional = [](const std::string& text) {
      return text.empty() ? TableCell() : TableCell(text);
    };
    const auto drawing = drawings.find(row);
    const double side =
        curve == indices.end() ? kMissing : over(nearest_side(sections[curve->second->setting]));
    std::vector<TableCell> cells = {
        row,
        index,
        count_or_none(graph.n),
        count_or_none(graph.m),
        std::to_string(graph.seed),
        optional(graph.name),
        optional(graph.status == RunStatus::ok ? "" : to_string(graph.status)),
        drawing == drawings.end() ? TableCell() : TableCell(drawing->second),
        is_point,
        side,
        over(Quantity::volume),
        timed ? over(Quantity::wall_s) : kMissing,
        timed ? std::exp(graph.log_timed_s) : kMissing};
    for (const std::int64_t extent : graph.extents) cells.push_back(count_or_none(extent));
    for (const std::int64_t own : graph.instance_bound) cells.push_back(count_or_none(own));
    for (const auto& bounds : {graph.theorem_bound, graph.published_bound}) {
      for (const double bound : bounds) cells.push_back(bound);
    }
    listed.add(std::move(cells));
  }
}

double order_of(const Section& section, Quantity quantity) {
  if (quantity == Quantity::wall_s) return 1;
  const double without = quantity == Quantity::volume ? 3 : 1;
  return section.theorem ? theorem_order(*section.theorem, quantity).value_or(without) : without;
}

const char* unit_of(const Section& section, Quantity quantity) {
  if (quantity == Quantity::wall_s) return "s";
  if (quantity != Quantity::volume) return "lattice units";
  return section.has_own_unit ? "vertex distances³" : "lattice points";
}

std::map<std::int64_t, const DrawnGraph*> worst_by_size(const CurveTally& curve) {
  std::map<std::int64_t, const DrawnGraph*> shares;
  for (const auto& [n, size] : curve.sizes) {
    if (size.drawn > 0 && !std::isnan(size.closest.share())) shares[n] = &size.closest;
  }
  return shares;
}

Quantity nearest_side(const Section& section) {
  const SectionCurve& closest =
      *std::ranges::min_element(section.curves, {}, &SectionCurve::least_slack);
  const auto axis = worst_axis(*closest.tally);
  return axis ? static_cast<Quantity>(static_cast<std::size_t>(Quantity::extent_x) + *axis)
              : Quantity::longest_side;
}

Interval shown_interval(const ScalingEntry& entry) {
  if (!entry.decided) return {kMissing, kMissing};
  return entry.growth == Growth::power ? entry.law_interval : entry.power.exponent_interval;
}

double log10_of(std::int64_t n) { return std::log10(static_cast<double>(n)); }
double bends_of(const DrawnGraph& graph) {
  double bends = 0;
  for (int of_edge = 1; of_edge < 8; ++of_edge) {
    bends += of_edge * metric_of(graph, "bends_" + std::to_string(of_edge));
  }
  return bends;
}

double decimal(double natural_log) { return natural_log / std::numbers::ln10; }

std::vector<SizeBin> size_bins(const std::set<std::int64_t>& sizes, std::size_t most) {
  std::vector<SizeBin> bins;
  if (sizes.empty()) return bins;
  const double low = log10_of(std::max<std::int64_t>(1, *sizes.begin()));
  const double width = (log10_of(*sizes.rbegin()) - low) / static_cast<double>(most);
  std::size_t end_of_last = 0;  // parts up to the last bin's end
  for (const std::int64_t n : sizes) {
    const double bin = (log10_of(std::max<std::int64_t>(1, n)) - low) / width;
    const std::size_t end = std::min(static_cast<std::size_t>(std::max(0.0, bin)), most - 1) + 1;
    if (sizes.size() <= most || end > end_of_last) bins.push_back({n, n, n});
    bins.back().last = n;
    end_of_last = end;
  }
  set_middles(sizes, bins);
  return bins;
}

std::vector<SizeBin> bins_of_study(const std::vector<Section>& sections, std::size_t most) {
  std::set<std::int64_t> asked, sizes;
  for (const Section& section : sections) {
    for (const SectionCurve& curve : section.curves) {
      for (const auto& [n, size] : curve.tally->sizes) {
        if (size.drawn == 0) continue;
        sizes.insert(n);
        asked.insert(curve.is_collection ? n : size.requested_n);
      }
    }
  }
  const std::vector<SizeBin> around = size_bins(asked, most);
  std::vector<SizeBin> bins;
  std::size_t at = 0, last = around.size();
  for (const std::int64_t n : sizes) {
    while (at + 1 < around.size() &&
           2 * log10_of(n) > log10_of(around[at].last) + log10_of(around[at + 1].first)) {
      ++at;
    }
    if (at != last) bins.push_back({n, n, n});
    bins.back().last = n, last = at;
  }
  set_middles(sizes, bins);
  return bins;
}

const SizeBin& bin_of(const std::vector<SizeBin>& bins, std::int64_t n) {
  const auto at = std::ranges::lower_bound(bins, n, {}, &SizeBin::last);
  expect(at != bins.end() && at->first <= n, "every n that was drawn is in a bin");
  return *at;
}

}  // namespace ar3d::report
