#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "ar3d/analysis/report.h"
#include "ar3d/analysis/table.h"
#include "ar3d/store/columns/side_tables.h"

namespace ar3d::report {

/// Describes one curve of a section.
struct SectionCurve {
  std::size_t place = 0;  ///< in StudyTally::curves and StudyAnalysis::bounds
  std::string family;     ///< family_label
  std::string name;       ///< of the family; with parameters only where two have one name
  const CurveTally* tally = nullptr;
  const BoundsEntry* bounds = nullptr;
  std::vector<const ScalingEntry*> scaling;  ///< by quantity; null if it was not measured
  bool is_collection = false;  ///< graphs of files, at least kFewestOfCollection of them

  const ScalingEntry* growth(Quantity quantity) const {
    return scaling[static_cast<std::size_t>(quantity)];
  }
};

/// Describes one setting: an algorithm with its options, and its families in the order of the file.
struct Section {
  std::string label;
  std::string algorithm;
  std::optional<SizeBound> theorem;
  std::optional<SizeBound> published;
  bool has_own_unit = false;         ///< as of CurveTally
  std::vector<SectionCurve> curves;  ///< all of them: what is counted is counted over these
  std::vector<SectionCurve> shown;   ///< at most kMostFamilies: those closest to the bound
};
inline constexpr std::size_t kFewestOfCollection = 20;
inline constexpr std::size_t kMostFamilies = 300, kMostSections = 40, kShownFindings = 20;

/// Returns at most kMostSections of them.
std::vector<Section> sections(const StudyAnalysis& analysis);
/// Returns the number of families that these labels are of: one with several parameters counts once.
std::size_t count_families(const std::set<std::string>& family_labels);
/// Returns the power of n that figures divide a quantity by: the order of the theorem's bound, or
/// without one that of the box of a line of vertices.
double order_of(const Section& section, Quantity quantity);
/// Returns by requested n the graph with the largest share of the theorem's bound.
std::map<std::int64_t, const DrawnGraph*> worst_by_size(const CurveTally& curve);
/// Returns the interval that a growth is told with (docs/analysis.md, Growth, points 4 and 5).
Interval told_interval(const ScalingEntry& entry);

/// Represents the graphs that tables point at by their rows: the table `graphs` says what each is.
class GraphList {
 public:
  explicit GraphList(const StudyAnalysis& of) : analysis(of) {}

  const StudyAnalysis& analysis;

  /// Notes the graph. @param curve  in the tally. @param point  it is a point of the growth figures.
  /// @return its row.
  std::size_t add(std::size_t curve, const DrawnGraph& graph, bool point = false);
  void add(std::size_t curve, const CensoredRow& row);
  /// The same of any row of the study; nothing if its curve is in no table.
  void add_row(std::size_t row);
  /// @param drawings  which drawing of the viewer's page shows a row.
  Table table(const std::map<std::size_t, std::size_t>& drawings,
              const std::vector<Section>& sections) const;

 private:
  struct Noted {
    std::size_t curve = 0;
    bool is_point = false;
    DrawnGraph graph;
    std::string status;
  };
  std::map<std::size_t, Noted> rows_;
};

/// Holds what the makers of tables read, and where their tables go.
struct TableMaker {
  const StudyAnalysis& analysis;
  const SinceReference& since;
  const std::vector<Section>& sections;
  bool all = true;  ///< false: what the page shows
  GraphList graphs;
  std::vector<Table> tables = {};

  Table& start(std::string name, std::string row_is, std::vector<TableColumn> columns);
};

// Each adds its tables; they are empty where the study has nothing to tell.
void add_verdict(TableMaker& make);      // study, verdict, findings, settings, exponents, promises
void add_background(TableMaker& make);   // since…, metrics, environment, scaling
void add_families(TableMaker& make);     // bounds, growth, shares, bends
void add_curves(TableMaker& make);       // curves, bands, volume_bands, points among the graphs
void add_trade(TableMaker& make);        // groups, trade, crossings, efforts
void add_collections(TableMaker& make);  // collections, profile, pairs, bins, group_medians
void add_precision(TableMaker& make);    // misses, onsets, …, judgements

Table bounds_table_of(const StudyAnalysis& analysis, const std::vector<Section>& sections);
Table growth_table_of(const StudyAnalysis& analysis, const std::vector<Section>& sections);
/// Returns the rows of the graphs that the pairs of volumes of collections name.
std::vector<std::size_t> collection_outliers(const std::vector<Section>& sections);

/// Volume and drawing time: decimal logarithms, medians. Times are those of the timing phase.
struct Median {
  double volume = kMissing;           ///< lattice points of the box
  double relative_volume = kMissing;  ///< in cubes of the smallest distance of vertices
  double time = kMissing;
};

/// Holds what one setting did on every family but collections at every requested n: medians over
/// graphs. Sizes with an unfinished graph are left out.
struct ComparedSetting {
  const Section* section = nullptr;
  std::string label;
  std::string algorithm;
  std::size_t place = 0;  ///< in the sections
  std::size_t bends = 0;  ///< largest number of bends per edge
  std::map<std::int64_t, std::map<std::string, Median>> sizes;
};
std::vector<ComparedSetting> settings_of(const std::vector<Section>& sections);

/// Describes settings that can be compared, and the families that all of them drew.
struct SettingGroup {
  std::vector<const ComparedSetting*> settings;
  std::set<std::string> families;
  /// Is true if some setting has a unit of its own, so that all volumes are over the smallest
  /// distance of vertices.
  bool is_relative = false;

  /// Returns the settings with this n, and those of the families that all of these drew there.
  SettingGroup at(std::int64_t n) const;
  std::vector<std::int64_t> sizes() const;
};

/// Returns at most four groups of at least two settings, none of which could have another setting
/// without losing families; most algorithms first, then most settings.
std::vector<SettingGroup> groups_of(const std::vector<ComparedSetting>& settings);

/// Returns the median of a setting's medians over the group's families at an n that it has;
/// `volume` is the relative one if the group's are.
Median over(const ComparedSetting& setting, std::int64_t n, const SettingGroup& group);

/// Describes a graph that two settings drew: log10 of its requested n, and of the one's volume over
/// the other's.
struct PairedGraph {
  double log_n = 0, log_ratio = 0;
};
/// Returns the graphs of the group's families that both drew and the tally keeps.
std::vector<PairedGraph> paired_graphs(const ComparedSetting& one, const ComparedSetting& other,
                                       const SettingGroup& group);

double log10_of(std::int64_t n);
/// Returns the decimal logarithm of a natural one.
double decimal(double natural_log);
/// Returns one metric of the table, its decimal logarithm, and the bends of all edges; NaN: missing.
double metric_of(const DrawnGraph& graph, std::string_view name);
double log10_metric(const DrawnGraph& graph, std::string_view name);
double bends_of(const DrawnGraph& graph);

/// Sizes that stand together.
struct SizeBin {
  std::int64_t first = 0, last = 0;
};
/// One bin a size if there are at most `most`; else those of `most` equal parts of the logarithmic
/// scale that hold any. @param sizes  at least 1 each; smaller ones are in no bin but the first.
std::vector<SizeBin> size_bins(const std::set<std::int64_t>& sizes, std::size_t most);

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
