#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ar3d/analysis/report.h"
#include "ar3d/analysis/report/page.h"
#include "ar3d/store/columns/side_tables.h"

namespace ar3d::report {

/// One curve of a section.
struct SectionCurve {
  std::size_t place = 0;  ///< in StudyTally::curves and StudyAnalysis::bounds
  std::string family;     ///< family_label
  std::string name;       ///< of the family; with parameters only where two have one name
  const CurveTally* tally = nullptr;
  const BoundsEntry* bounds = nullptr;
  std::vector<const ScalingEntry*> scaling;  ///< by quantity; null if it was not measured
  bool is_collection = false;  ///< graphs of files, at least kFewestOfCollection of them
};

/// One setting: an algorithm with its options, and its families in the order of the file.
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

/// At most kMostSections of them.
std::vector<Section> sections(const StudyAnalysis& analysis);
/// How many families these labels are of: one with several parameters counts once.
std::size_t count_families(const std::set<std::string>& family_labels);

/// The head of the page: is everything certified, how close does anything come to a bound, and has
/// anything changed?
std::string verdict_section(Page& page, const std::vector<Section>& sections,
                            const SinceReference& since);
/// What changed since the reference?
std::string reference_section(const SinceReference& since);
/// How close does anything come to a bound, and which graph is it? One line a setting.
std::string closeness_section(Page& page, const std::vector<Section>& sections);
/// What was promised, and what is drawn? By setting and axis: the paper's bound, the proved one,
/// the measured exponent and constant. Empty if no setting has a theorem's box.
std::string promises_section(const std::vector<Section>& sections);
/// What does each algorithm trade: volume, bends, time?
std::string trade_section(Page& page, const std::vector<Section>& sections);
/// For each collection who drew how many of its graphs, profiles, scatters, curves and groups.
std::string collection_sections(Page& page, const std::vector<Section>& sections);
/// The rows of the graphs that its scatters of volumes name.
std::vector<std::size_t> collection_outliers(const std::vector<Section>& sections);
/// What does accuracy cost: real types, certificate modes, levels, efforts? Empty where all rows
/// are proved exactly and of one level. One more pass over the rows.
std::string precision_section(Page& page, const std::vector<Section>& sections);
/// How does each quantity of one setting grow, and how sure is that? `id` is its anchor.
std::string algorithm_section(Page& page, const Section& section, const std::string& id);
/// A part of it.
std::string growth_figures(Page& page, const Section& section);
/// The numbers of its heat map: by requested n the graph with the largest share of the bound.
std::map<std::int64_t, const DrawnGraph*> worst_by_size(const CurveTally& curve);
/// A button that opens the drawing of a row that the page points at, or shows how it is drawn
/// again. @param text  HTML.
std::string row_button(std::size_t row, const std::string& text);
/// The same for a graph, at which the page points then.
std::string graph_button(Page& page, std::size_t curve, const DrawnGraph& graph,
                         const std::string& text);
/// Batches of strong and weak scaling against the ideal; empty if there are none.
std::string strong_weak_section(Page& page);
/// Every metric of verify/metrics/metrics.h: unit, definition, and its median and range by setting.
std::string metrics_section(const StudyAnalysis& analysis, const std::vector<Section>& sections);
/// Environment, spec and methods.
std::string background(const RowView& rows);

/// The cell of violations: their number, or that there are none, and how many of the ok rows no
/// exact certificate judged.
std::string violations_text(std::size_t violations, std::size_t unproved, std::size_t ok_rows,
                            std::size_t measured_rows);

}  // namespace ar3d::report
