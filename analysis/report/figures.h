#pragma once

#include <string>
#include <vector>

#include "ar3d/analysis/report.h"
#include "ar3d/analysis/report/sections.h"

namespace ar3d::report {

/// What a colour of a plot stands for; plain text.
struct LegendEntry {
  std::string label;
  std::size_t colour = 0;
};

/// A plot as it stands in the page, and what to call it.
struct NamedPlot {
  std::string file;   ///< "longest-side": letters, digits and hyphens
  std::string title;  ///< plain text
  std::string note;   ///< plain text
  std::string svg;
  std::vector<LegendEntry> legend;
};

/// The plot with its caption as HTML.
std::string figure_html(const NamedPlot& plot);
/// Colours and what they stand for as HTML.
std::string legend_html(const std::vector<LegendEntry>& legend, bool with_bound);

/// Longest side, volume and drawing time of all families of a section.
std::vector<NamedPlot> section_plots(const Section& section);

/// Volume against drawing time over the settings of an algorithm: one plot for every algorithm that
/// was measured with at least two. Medians of the largest n that all settings share.
std::vector<NamedPlot> effort_dials(const StudyAnalysis& analysis);

/// Drawings at a time against threads or ranks in batches: one plot for every algorithm, phase and
/// kind, one line for every family and size.
std::vector<NamedPlot> strong_weak_plots(const StudyAnalysis& analysis);

/// Every plot of the page that shows more than one family, as a document of its own.
std::vector<Figure> standalone_figures(const StudyAnalysis& analysis);

}  // namespace ar3d::report
