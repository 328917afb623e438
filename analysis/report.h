#pragma once

#include <string>
#include <vector>

#include "ar3d/analysis/study_analysis.h"

namespace ar3d {

/// One HTML page about a study: verdict, bounds table, growth, plots, bends, environment, spec and
/// methods. It needs nothing from outside (no network, no other file); every string of the file is
/// escaped. About 1 kB a plotted size, however many rows there are.
std::string render_report(const StudyAnalysis& analysis);

/// A figure for a paper: an SVG document of its own, in dark colours on white.
struct Figure {
  std::string name;  ///< "diamond-effort-0-longest-side": lower case, digits and hyphens; unique
  std::string svg;
};

/// The report's plots by algorithm (longest side, volume, drawing time, bends) and the effort
/// dials.
std::vector<Figure> report_figures(const StudyAnalysis& analysis);

}  // namespace ar3d
