#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "ar3d/analysis/report.h"
#include "ar3d/analysis/study_analysis.h"

namespace ar3d::report {

/// A figure that can be saved: SVG, the numbers behind it, and what a script says at its axes.
struct NamedPlot {
  std::string file;   ///< "diamond-longest-side": what a saved file is called; made unique
  std::string title;  ///< plain text, as note and the axes
  std::string note = {};
  std::string x = {};
  std::string y = {};
  std::string svg = {};
  std::string csv = {};     ///< lines of csv_line; a noted figure's have a head and ids in front
  std::string legend = {};  ///< HTML below the figure
  bool has_linear_y = false;
};

/// What the sections of a page share: the rows that something in it points at, and its figures.
class Page {
 public:
  explicit Page(const StudyAnalysis& of, const ShownDrawings& shown = {})
      : analysis(of), drawings_(shown.page_of_row) {}

  const StudyAnalysis& analysis;

  /// Whether the page holds the drawing of this row.
  bool is_shown(std::size_t row) const { return drawings_.contains(row); }

  /// Notes that something points at this row. @param curve  in analysis.tally.curves.
  /// @return the row.
  std::size_t point_at(std::size_t curve, const DrawnGraph& graph);
  std::size_t point_at(std::size_t curve, const CensoredRow& row);
  /// The same of any row of the study; false if its curve is in no table.
  bool point_at(std::size_t row);
  /// The rows noted so far, for the page's script: {"replay": command before the row, "curves":
  /// [[label, command before n, command behind the seed], …], "bounds": {"n of setting": …},
  /// "rows": {"row": [curve, n, m, seed, …]}}.
  std::string rows_json() const;

  /// Notes a figure. @return it as HTML.
  std::string figure(NamedPlot plot, const std::string& attributes = "");
  const std::vector<NamedPlot>& figures() const { return figures_; }
  /// {"file": [csv, matplotlib script, pgfplots document], …}
  std::string figures_json() const;

 private:
  std::map<std::size_t, std::size_t> drawings_;
  std::map<std::size_t, std::string> rows_;
  std::vector<NamedPlot> figures_;
};

/// "diamond (effort=1)" -> "diamond-effort-1".
std::string slug(const std::string& text);

/// One line of NamedPlot::csv: name of a series, line, dashed, band, point or bar, and numbers of
/// which decimal logarithms are given; missing ones are empty. Names hold no comma and no quote.
std::string csv_line(const std::string& series, const char* kind, double log_x, double log_y,
                     double log_low = kMissing, double log_high = kMissing);

/// The figure as an SVG document of its own, without what the page hides.
std::string standalone_svg(const NamedPlot& plot);
/// A Python script that draws the figure again from FILE.csv, with matplotlib, as FILE.pdf.
std::string matplotlib_script(const NamedPlot& plot);
/// A LaTeX document that draws the figure again from FILE.csv, with pgfplots.
std::string pgfplots_document(const NamedPlot& plot);

}  // namespace ar3d::report
