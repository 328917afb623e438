#pragma once

#include <string>
#include <vector>

#include "ar3d/analysis/study_analysis.h"

namespace ar3d {

/// One HTML page about a study: verdict, bounds table, growth, plots, bends, environment, spec and
/// methods. It needs nothing from outside (no network, no other file); every string of the file is
/// escaped. About 1 kB a plotted size, however many rows there are.
std::string render_report(const StudyAnalysis& analysis);

/// A figure for a paper, in dark colours on white.
struct Figure {
  std::string name;        ///< "diamond-effort-0-longest-side": lower case, digits, hyphens; unique
  std::string svg;         ///< a document of its own
  std::string csv;         ///< the numbers behind it
  std::string matplotlib;  ///< a Python script that draws NAME.csv as NAME.pdf
  std::string pgfplots;    ///< a LaTeX document that draws NAME.csv
};

/// Every figure of the page.
std::vector<Figure> report_figures(const StudyAnalysis& analysis);

}  // namespace ar3d
