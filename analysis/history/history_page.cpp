#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "ar3d/analysis/history/changes_in_order.h"
#include "ar3d/analysis/history/line_plot.h"
#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/page_files.h"

namespace ar3d {
namespace {

using report::cell;
using report::escape;
using report::note;

constexpr std::size_t kMostFigures = 60;
constexpr std::size_t kMostChanges = 1000;
constexpr std::size_t kMostCells = 5000;

constexpr const char* kMethods = R"html(<section id=methods><h2>Methods</h2>
<p><b>Values.</b> Time: of every graph the smallest among the repetitions (of the timing phase where there is one), the geometric mean
over the graphs of the cell. Instructions: counted by callgrind (<code>ar3d study count</code>), geometric mean. Volume: lattice points of the box,
geometric mean. Bends: per edge. A cell with an unfinished row has no values in those results. Cells hold the same graphs throughout.</p>
<p><b>Lines.</b> Results of one study measured in one environment (processor, cores, kernel, compiler, flags, libraries, threads, variables). Unlike
environments are never joined. Times of a busy machine and of debug or sanitised builds are left out.</p>
<p><b>Changes of time.</b> The logarithms are winsorised at three robust standard deviations. Over the intervals of seeded binary segmentation (Kovács,
Bühlmann, Li and Munk, Biometrika 110, 2023) the split with the largest difference of means, weighted by its lengths, is a change if none of 999
random permutations of the values has one as large; then both sides are searched (hierarchical divisive estimation with a
permutation test: Matteson and James, Journal of the American Statistical Association 109, 2014). Where nothing changes and the noise of
one commit does not depend on that of the others, a line has a false alarm with probability at most 1/1000, whatever the noise looks like.
At least four commits lie between two changes; eight make a line that is judged. Changes below the threshold are given up.</p>
<p><b>Effect.</b> Hodges and Lehmann's shift with its 95 % interval. <b>Place.</b> The most likely two commits, and a range that holds the change
with 95 % confidence (the shaded part of a figure). <b>Gradual</b>: a straight line fits better than a step.</p>
<p><b>Changes without noise.</b> Volume and bends: any change of any graph. Instructions: by more than the threshold since the last change.</p></section>
)html";

std::string head(const std::string& folder) {
  return "<!doctype html>\n<html lang=en><head><meta charset=utf-8>"
         "<meta name=viewport content='width=device-width,initial-scale=1'>"
         "<meta http-equiv=Content-Security-Policy content=\"default-src 'none'; "
         "style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:\">"
         "<title>ar3d history: " +
         escape(folder) + "</title><style>" + report::page_style() + "</style></head>\n";
}

std::string beginning(const History& history, const std::string& folder, std::size_t changes) {
  std::size_t judged = 0, lines = 0;
  for (const Measure measure : kMeasures) {
    judged += history.count(measure, true);
    lines += history.count(measure, false);
  }
  std::string html = fmt::format(
      "<header><p class=muted>ar3d history</p><h1>{}</h1><p><span class='verdict {}'>{} "
      "change{}</span> "
      "{} results, {} environment{}; {} of {} lines judged</p></header>\n",
      escape(folder),
      judged == 0    ? "incomplete"
      : changes == 0 ? "pass"
                     : "violated",
      changes, changes == 1 ? "" : "s", history.results.size(), history.environments.size(),
      history.environments.size() == 1 ? "" : "s", judged, lines);
  if (judged < lines) {
    html += fmt::format(
        "<p>{} lines are too short to be judged: times need {} results of one environment, the "
        "others two.</p>\n",
        lines - judged, 2 * history.rule.time.shortest);
  }
  return html;
}

std::string change_row(const History& history, const PlacedChange& placed) {
  const HistoryLine& line = *placed.line;
  const Neighbours at = around(history, placed, false), surely = around(history, placed, true);
  const bool worse = placed.change->effect > 0;
  const auto names = [](const Neighbours& two) {
    return "<code>" + escape(two.before->name) + "</code> → <code>" + escape(two.after->name) +
           "</code>";
  };
  std::string where = names(at);
  if (placed.change->gradual) where = "gradual, about " + where;
  if (surely.before != at.before || surely.after != at.after) {
    where += "<br><small>95 %: " + names(surely) + "</small>";
  }
  const std::string command = bisect_command(history, line, *placed.change);
  return "<tr>" +
         cell(fmt::format("<span class={}>{}</span>", worse ? "violated" : "pass",
                          direction_text(placed))) +
         cell(escape(effect_text(line, *placed.change))) +
         note(escape(cell_label(line.cell.curve, line.cell.n))) + cell(where) +
         cell(fmt::format("{}", line.environment + 1), true) +
         note(command.empty() ? "–" : "<code>" + escape(command) + "</code>") + "</tr>\n";
}

std::string changes_section(const History& history, const std::vector<PlacedChange>& changes) {
  std::string html = "<section id=changes><h2>What changed?</h2>";
  if (changes.empty()) return html + "<p>Nothing that was judged.</p></section>\n";
  if (changes.size() > kMostChanges) {
    html += fmt::format("<p>The {} largest of {} changes.</p>", kMostChanges, changes.size());
  }
  html +=
      "<div class=scroll><table class=sortable><thead><tr><th>Change</th><th>Effect</th><th>Cell"
      "</th><th>Between</th><th class=num>Environment</th><th>Find the commit</th></tr></thead>"
      "<tbody>\n";
  for (std::size_t i = 0; i < std::min(kMostChanges, changes.size()); ++i) {
    html += change_row(history, changes[i]);
  }
  html += "</tbody></table></div>\n<div class=figures>\n";
  std::set<const HistoryLine*> drawn;
  for (const PlacedChange& placed : changes) {
    if (drawn.size() < kMostFigures && drawn.insert(placed.line).second) {
      html += line_figure(history, *placed.line);
    }
  }
  return html + "</div></section>\n";
}

/// The four lines of a cell in one environment and study.
using CellLines = std::array<const HistoryLine*, kMeasures.size()>;

std::string cell_row(const History& history, const CellLines& lines) {
  const auto any = std::find_if(lines.begin(), lines.end(), [](const auto* l) { return l; });
  const HistoryLine& line = **any;
  std::string html = "<tr>" + note(escape(algorithm_label(line.cell.curve))) +
                     note(escape(family_label(line.cell.curve))) +
                     cell(report::grouped(line.cell.n), true) + cell(escape(line.study)) +
                     cell(fmt::format("{}", line.environment + 1), true);
  for (const HistoryLine* of : lines) {
    html += of == nullptr ? cell("–")
                          : "<td>" + value_text(of->measure, of->values.back()) +
                                (of->is_judged ? "" : " <small>not judged</small>") + "<br>" +
                                sparkline(history, *of) + "</td>";
  }
  return html + "</tr>\n";
}

std::string cells_section(const History& history) {
  std::map<std::tuple<std::size_t, std::string, HistoryCell>, CellLines> cells;
  for (const HistoryLine& line : history.lines) {
    cells[{line.environment, line.study, line.cell}][static_cast<std::size_t>(line.measure)] =
        &line;
  }
  std::string html =
      "<section id=cells><h2>Every cell</h2><p>The last value, and all values over the commits; a "
      "dashed line is a change. A picture whose values differ by less than 2 % does not fill its "
      "height. A click makes it large.</p>";
  if (cells.size() > kMostCells) {
    html += fmt::format("<p>The first {} of {} cells; <code>--json</code> has all.</p>", kMostCells,
                        cells.size());
  }
  html +=
      "<div class=scroll><table class=sortable><thead><tr><th>Algorithm</th><th>Family</th><th "
      "class=num>n</th><th>Study</th><th class=num>Environment</th><th>Time</th><th>Instructions"
      "</th><th>Volume</th><th>Bends per edge</th></tr></thead><tbody>\n";
  std::size_t shown = 0;
  for (const auto& [key, lines] : cells) {
    if (shown++ < kMostCells) html += cell_row(history, lines);
  }
  return html + "</tbody></table></div></section>\n";
}

std::string results_section(const History& history) {
  std::string html =
      "<section id=results><h2>Results</h2><div class=scroll><table><thead><tr><th class=num>Place"
      "</th><th>Name</th><th>Commit</th><th>Study</th><th>Begun</th><th class=num>Environment</th>"
      "<th class=num>Unfinished rows</th><th>Times left out</th></tr></thead><tbody>\n";
  for (const CommitResults& one : history.results) {
    html += "<tr>" + cell(fmt::format("{}", one.place), true) + cell(escape(one.name)) +
            cell("<code>" + escape(one.source_hash.substr(0, 12)) + "</code>") +
            cell(escape(one.study)) + cell(escape(one.created)) +
            cell(fmt::format("{}", one.environment + 1), true) +
            cell(report::grouped(static_cast<std::int64_t>(one.unfinished)), true) +
            note(escape(one.untimed)) + "</tr>\n";
  }
  return html + "</tbody></table></div></section>\n";
}

/// What all environments share is left out where there are several.
std::string environments_section(const History& history) {
  std::set<std::string> names;
  for (const auto& settings : history.environments) {
    for (const auto& [name, value] : settings) names.insert(name);
  }
  std::string html = "<section id=environments><h2>Environments</h2>";
  if (history.environments.size() > 1) html += "<p>What differs between them.</p>";
  html += "<div class=scroll><table><thead><tr><th>Setting</th>";
  for (std::size_t i = 0; i < history.environments.size(); ++i) {
    html += fmt::format("<th>{}</th>", i + 1);
  }
  html += "</tr></thead><tbody>\n";
  for (const std::string& name : names) {
    std::set<std::string> values;
    std::string row;
    for (const auto& settings : history.environments) {
      const auto at = settings.find(name);
      const std::string value = at == settings.end() ? "absent" : at->second;
      values.insert(value);
      row += note(escape(value));
    }
    if (history.environments.size() > 1 && values.size() == 1) continue;
    html += "<tr><th scope=row>" + escape(name) + "</th>" + row + "</tr>\n";
  }
  return html + "</tbody></table></div></section>\n";
}

}  // namespace

std::string render_history(const History& history, const std::string& folder) {
  const std::vector<PlacedChange> changes = changes_in_order(history);
  return head(folder) + "<body>\n" + beginning(history, folder, changes.size()) +
         "<nav><a href='#changes'>What changed?</a><a href='#cells'>Every cell</a>"
         "<a href='#results'>Results</a><a href='#environments'>Environments</a>"
         "<a href='#methods'>Methods</a></nav>\n" +
         changes_section(history, changes) + cells_section(history) + results_section(history) +
         environments_section(history) + kMethods + "<script>" + report::table_script() +
         "</script>\n</body></html>\n";
}

}  // namespace ar3d
