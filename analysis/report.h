#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/analysis/compare.h"
#include "ar3d/analysis/study_analysis.h"

namespace ar3d {

/// What the study was compared with, or why with nothing.
struct SinceReference {
  std::string file;     ///< of the reference
  std::string created;  ///< of the reference
  std::optional<Comparison> comparison;
  std::string why_none = "No reference was given.";  ///< plain text; shown without a comparison
};

/// Drawings of the study's graphs that the page opens in its viewer.
struct ShownDrawings {
  std::map<std::size_t, std::size_t> page_of_row;  ///< which drawing of the viewer's page
  std::string packed_page;  ///< a page of `ar3d view`, in base64 of zlib's deflate format
};

/// One HTML page about a study: verdict, what changed since the reference, bounds table, growth,
/// plots, bends, environment, spec and methods. It needs nothing from outside (no network, no other
/// file); every string of the file is escaped. About 1 kB per plotted size, however many rows there
/// are; the drawings come on top.
std::string render_report(const StudyAnalysis& analysis, const SinceReference& since = {},
                          const ShownDrawings& drawings = {});

/// The rows of the page that are worth storing a drawing of, most important first, at most `most`:
/// those of the findings that are listed, of the outliers of collections, of the heat maps those of
/// each curve the graph that comes closest to its bound among those with at most `most_edges`
/// edges, the closest ones first; then the other numbers of the maps in the same order.
std::vector<std::size_t> rows_to_show(const StudyAnalysis& analysis, std::size_t most,
                                      std::int64_t most_edges);

/// A figure for a paper, in dark colours on white.
struct Figure {
  std::string name;        ///< "diamond-effort-0-longest-side": lower case, digits, hyphens; unique
  std::string svg;         ///< a document of its own
  std::string csv;         ///< the numbers behind it
  std::string matplotlib;  ///< a Python script that draws NAME.csv as NAME-matplotlib.pdf
  std::string pgfplots;    ///< a LaTeX document that draws NAME.csv
};

/// Every figure of the page.
std::vector<Figure> report_figures(const StudyAnalysis& analysis);

}  // namespace ar3d
