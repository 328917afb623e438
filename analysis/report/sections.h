#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ar3d/analysis/report/report.h"
#include "ar3d/analysis/table.h"

namespace ar3d::report {

/// Describes one curve of a section.
struct SectionCurve {
  std::size_t index = 0;  ///< in StudyTally::curves
  std::string family;     ///< family_label
  std::string name;       ///< of the family; with parameters only where two have one name
  const CurveTally* tally = nullptr;
  std::vector<const ScalingEntry*> scaling;  ///< by quantity; null if it was not measured
  bool is_collection = false;  ///< graphs of files, at least kFewestOfCollection of them
  std::size_t setting = 0;     ///< its section's index
  bool is_shown = false;       ///< among Section::shown

  const ScalingEntry* growth(Quantity quantity) const {
    return scaling[static_cast<std::size_t>(quantity)];
  }
  /// Returns the smallest slack over the axes; +infinity if there is none, so that it comes last.
  double least_slack() const;
};

/// Describes one setting: an algorithm with its options, and its families in the order of the file.
struct Section {
  std::string label;
  std::string algorithm;
  std::optional<SizeBound> theorem;
  std::optional<SizeBound> published;
  std::int64_t max_bends = -1;       ///< of an edge, as promised; -1: unknown
  bool has_own_unit = false;         ///< as of CurveTally
  std::vector<SectionCurve> curves;  ///< all of them: what is counted is counted over these
  std::vector<SectionCurve> shown;   ///< at most kMostFamilies: those closest to the bound
};
inline constexpr std::size_t kFewestOfCollection = 20;
inline constexpr std::size_t kMostBinsOfStudy = 48;
inline constexpr std::size_t kMostFamilies = 300, kMostSections = 40, kShownFindings = 20;

/// Returns at most kMostSections of them.
std::vector<Section> sections(const StudyAnalysis& analysis);
/// Returns the curves of all sections by their indices.
std::map<std::size_t, const SectionCurve*> curves_by_index(const std::vector<Section>& sections);
/// Returns the number of families that these labels are of: one with several parameters counts once.
std::size_t count_families(const std::set<std::string>& family_labels);
/// Returns the power of n that figures divide a quantity by: the order of the theorem's bound, or
/// without one that of the box of a line of vertices.
double order_of(const Section& section, Quantity quantity);
/// Returns the quantity that stands for the sides in figures: the extent on the axis that comes
/// nearest to the theorem's bound; without one the longest side.
Quantity nearest_side(const Section& section);
/// Returns by n the graph with the largest share of the theorem's bound.
std::map<std::int64_t, const DrawnGraph*> worst_by_size(const CurveTally& curve);
/// Returns the unit of a quantity of the setting's drawings.
const char* unit_of(const Section& section, Quantity quantity);
/// Returns the interval that is shown with a growth (docs/analysis.md, Growth, points 4 and 5).
Interval shown_interval(const ScalingEntry& entry);

/// Holds the first and the last of sizes that stand together, and of them the one nearest to the
/// middle of the logarithmic scale.
struct SizeBin {
  std::int64_t first = 0, last = 0, n = 0;
  bool operator==(const SizeBin&) const = default;
};
/// Makes one bin a size if there are at most `most`; else bins of `most` equal parts of the
/// logarithmic scale, without the empty ones. @param sizes  at least 1 each; smaller ones are in no
/// bin but the first.
std::vector<SizeBin> size_bins(const std::set<std::int64_t>& sizes, std::size_t most);
/// Makes at most `most` bins of all n that the sections' graphs have: around the sizes that the study
/// asked for, and those of collections. An n belongs to the nearest of these.
std::vector<SizeBin> bins_of_study(const std::vector<Section>& sections, std::size_t most);
/// Returns the bin with this n.
const SizeBin& bin_of(const std::vector<SizeBin>& bins, std::int64_t n);

/// Holds what the makers of tables read, and where their tables go. The table `graphs` says what each
/// graph is that other tables point at by its row.
struct TableMaker {
  const StudyAnalysis& analysis;
  const SinceReference& since;
  const std::vector<Section>& sections;
  bool all = true;  ///< false: what the page shows
  std::vector<SizeBin> bins = bins_of_study(sections, kMostBinsOfStudy);  ///< of curves and trade
  std::vector<Table> tables = empty_tables("report");
  std::map<std::size_t, std::pair<std::size_t, DrawnGraph>> graphs =
      {};                             ///< by row, with their curves
  std::set<std::size_t> points = {};  ///< rows of graphs that are points of the growth figures

  Table& table(std::string_view name) { return table_named(name, tables); }
  /// Notes the graph. @param curve  in the tally. @param point  it is a point of the growth figures.
  /// @return its row.
  std::size_t add_graph(std::size_t curve, const DrawnGraph& graph, bool point = false);
  /// Notes any row of the study; nothing if its curve is in no table.
  void add_row(std::size_t row);
  /// Fills the table `graphs`. @param drawings  which drawing of the viewer's page shows a row.
  void fill_graphs(const std::map<std::size_t, std::size_t>& drawings);
};

// Each fills its tables; they stay empty where the study has nothing to tell.
void add_verdict(TableMaker& make);      // study, verdict, findings, settings, exponents, promises
void add_background(TableMaker& make);   // since…, metrics, environment, scaling
void add_families(TableMaker& make);     // bounds, growth, shares, bends
void add_curves(TableMaker& make);       // curves, bands, volume_bands, points among the graphs
void add_trade(TableMaker& make);        // groups, trade, crossings, efforts
void add_collections(TableMaker& make);  // collections, profile, pairs, bins, group_medians
void add_precision(TableMaker& make);    // precision, real_drawings, judgements

void fill_bounds(const StudyAnalysis& analysis, const std::vector<Section>& sections, Table& table);
void fill_growth(const StudyAnalysis& analysis, const std::vector<Section>& sections, Table& table);
/// Returns the rows of the graphs that the pairs of volumes of collections name.
std::vector<std::size_t> collection_outliers(const std::vector<Section>& sections);

/// What figures call the bends of a drawing over its edges.
inline constexpr const char* kBendsPerEdge = "bends per edge";
/// Adds least, median and largest of the curves' medians of a bin to `bands`.
/// @param values  by SizeBin::n, then by curve; one median for each n.
void add_band(TableMaker& make, std::size_t setting, const char* quantity,
              const std::map<std::int64_t, std::map<std::size_t, std::vector<double>>>& values);

double log10_of(std::int64_t n);
/// Returns the decimal logarithm of a natural one.
double decimal(double natural_log);
/// Returns the bends of all edges; NaN: missing.
double bends_of(const DrawnGraph& graph);

/// Returns at most `most` of the items, evenly, the first and the last among them.
template <class Item>
std::vector<Item> evenly(const std::vector<Item>& items, std::size_t most) {
  if (items.size() <= most) return items;
  if (most < 2) return {items.back()};
  std::vector<Item> kept;
  for (std::size_t i = 0; i < most; ++i) kept.push_back(items[i * (items.size() - 1) / (most - 1)]);
  return kept;
}

}  // namespace ar3d::report
