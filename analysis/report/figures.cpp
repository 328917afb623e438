#include "ar3d/analysis/report/figures.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>

#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/page_files.h"
#include "ar3d/analysis/report/plot.h"

namespace ar3d::report {
namespace {

/// "diamond (effort=1)" -> "diamond-effort-1".
std::string slug(const std::string& text) {
  std::string name;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x80 && std::isalnum(code) != 0) {
      name += static_cast<char>(std::tolower(code));
    } else if (!name.empty() && name.back() != '-') {
      name += '-';
    }
  }
  while (!name.empty() && name.back() == '-') name.pop_back();
  return name;
}

constexpr double kLegendLine = 16, kLegendColumn = 180;

/// Two columns of colours below a plot of this height.
std::string legend_svg(const std::vector<LegendEntry>& legend, double top) {
  std::string svg;
  for (std::size_t i = 0; i < legend.size(); ++i) {
    const double x = 6 + kLegendColumn * static_cast<double>(i % 2);
    const std::size_t row = i / 2;
    const double y = top + kLegendLine * (0.5 + static_cast<double>(row));
    svg +=
        fmt::format("<path class='median {}' d='M{} {}h20'/><text x='{}' y='{}'>{}</text>",
                    stroke_class(legend[i].colour), x, y, x + 25, y + 4, escape(legend[i].label));
  }
  return svg.empty() ? "" : "<g class='legend'>" + svg + "</g>";
}

/// The content of a plot in a document of its own, with its legend below.
std::string standalone(const std::string& plot_svg, const std::string& title,
                       const std::vector<LegendEntry>& legend) {
  const std::size_t begin = plot_svg.find('>') + 1, end = plot_svg.rfind("</svg>");
  const std::size_t box = plot_svg.find("viewBox='0 0 ") + 13;
  const double width = std::stod(plot_svg.substr(box));
  const double plot_height = std::stod(plot_svg.substr(plot_svg.find(' ', box)));
  const double height =
      plot_height + kLegendLine * std::ceil(static_cast<double>(legend.size()) / 2);
  return fmt::format(
      "<?xml version='1.0' encoding='UTF-8'?>\n<svg xmlns='http://www.w3.org/2000/svg' width='{0}' "
      "height='{1}' viewBox='0 0 {0} {1}'><title>{2}</title><style>{3}</style>{4}{5}</svg>\n",
      width, height, escape(title), figure_style(), plot_svg.substr(begin, end - begin),
      legend_svg(legend, plot_height));
}

}  // namespace

std::string legend_html(const std::vector<LegendEntry>& legend, bool with_bound) {
  std::string html = "<div class=legend>";
  const auto entry = [&](const std::string& css, const std::string& label) {
    html += fmt::format(
        "<span><svg viewBox='0 0 26 10' aria-hidden=true><path class='{}' d='M0 5H26'/></svg>{}"
        "</span>",
        css, label);
  };
  for (const LegendEntry& one : legend) {
    entry("median " + stroke_class(one.colour), escape(one.label));
  }
  if (with_bound) entry("bound", "theorem's bound");
  return html + "</div>\n";
}

std::string figure_html(const NamedPlot& plot) {
  return fmt::format("<figure><figcaption><b>{}</b> <span>{}</span></figcaption>{}</figure>\n",
                     escape(plot.title), escape(plot.note), plot.svg);
}

std::vector<Figure> standalone_figures(const StudyAnalysis& analysis) {
  std::vector<Figure> figures;
  const auto add = [&](const std::string& name, const std::string& title, const std::string& svg,
                       const std::vector<LegendEntry>& legend) {
    if (svg.empty()) return;
    std::string unique = slug(name);
    for (const Figure& other : figures) {
      if (other.name == unique) unique += fmt::format("-{}", figures.size());
    }
    figures.push_back({unique, standalone(svg, title, legend)});
  };
  for (const Section& section : sections(analysis)) {
    for (const NamedPlot& plot : section_plots(section)) {
      add(section.label + "-" + plot.file, section.label + ": " + plot.title, plot.svg,
          plot.legend);
    }
    add(section.label + "-bends", section.label + ": edges by bends", bend_svg(bends_of(section)),
        {});
  }
  for (const NamedPlot& dial : effort_dials(analysis)) {
    add(dial.title + "-" + dial.file, "effort of " + dial.title, dial.svg, dial.legend);
  }
  for (const NamedPlot& plot : strong_weak_plots(analysis)) {
    add(plot.title, plot.title, plot.svg, plot.legend);
  }
  return figures;
}

}  // namespace ar3d::report
