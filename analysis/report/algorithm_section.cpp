#include <fmt/format.h>

#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/sections.h"

namespace ar3d::report {

std::string algorithm_section(Page& page, const Section& section, const std::string& id) {
  std::string html =
      fmt::format("<section id={} class=setting><h2>{}</h2>\n", id, escape(section.label));
  html += bound_sentences(section);
  if (section.curves.size() < section.all_curves) {
    html += fmt::format(
        "<p class=incomplete>The {} of {} families that come closest to the bound; <code>ar3d "
        "report "
        "--csv</code> lists all.</p>\n",
        section.curves.size(), section.all_curves);
  }
  html += fmt::format(
      "<p><label class=choice>Highlight families <input type=search class=filter "
      "placeholder='part of a name' list='{}-families'></label><datalist id='{}-families'>",
      id, id);
  for (const SectionCurve& curve : section.curves) {
    html += fmt::format("<option value='{}'>", escape(curve.family));
  }
  html += "</datalist></p>\n";
  html += growth_figures(page, section) + heat_map(page, section);
  html += bounds_table_html(page, section) + growth_table(section) + bend_figure(page, section);
  return html + "</section>\n";
}

}  // namespace ar3d::report
