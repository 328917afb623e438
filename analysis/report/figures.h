#pragma once

#include <string>

#include "ar3d/analysis/report.h"
#include "ar3d/analysis/report/page.h"

namespace ar3d::report {

/// The figure as an SVG document of its own, without what the page hides.
std::string standalone_svg(const NamedPlot& plot);
/// A Python script that draws the figure again from FILE.csv, with matplotlib, as FILE.pdf.
std::string matplotlib_script(const NamedPlot& plot);
/// A LaTeX document that draws the figure again from FILE.csv, with pgfplots.
std::string pgfplots_document(const NamedPlot& plot);

}  // namespace ar3d::report
