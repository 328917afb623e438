// The page of a history: changes with figures, every cell with a small picture, results,
// environments.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "ar3d/analysis/history/history.h"
#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/plot.h"

namespace ar3d {
namespace {

using report::escape;
using report::LogRange;

constexpr double kLeft = report::kLeft + 6, kRight = report::kLabelledWidth - 14;
constexpr double kTop = 16, kBottom = report::kBottom - 14;
constexpr double kLeastHeight = 0.02;  // of the values: less is not stretched to the whole height
constexpr std::size_t kMostNames = 6;

/// From the number of a value, and the value, to pixels: both linear.
struct LineScale {
  double left = 0, right = 0, top = 0, bottom = 0;
  double last = 1;  ///< number of the last value, at least 1
  double low = 0, high = 1;
  double x(double index) const { return left + index / last * (right - left); }
  double y(double value) const { return bottom - (value - low) / (high - low) * (bottom - top); }
};

LineScale scale_of(const HistoryLine& line, double left, double right, double top, double bottom) {
  LogRange range;
  for (const double value : line.values) range.include(value);
  const double middle = (range.low + range.high) / 2;
  const double least = middle > 0 ? kLeastHeight * middle : 1;
  const double half = std::max(range.high - range.low, least) / 2;
  const auto last = static_cast<double>(std::max<std::size_t>(line.values.size(), 2) - 1);
  return {left, right, top, bottom, last, middle - half, middle + half};
}

std::string polyline(const HistoryLine& line, const LineScale& scale, const char* css) {
  std::string points;
  for (std::size_t i = 0; i < line.values.size(); ++i) {
    points +=
        fmt::format("{:.1f},{:.1f} ", scale.x(static_cast<double>(i)), scale.y(line.values[i]));
  }
  return fmt::format("<polyline class='{}' points='{}'/>", css, points);
}

/// Between value i - 1 and value i.
double before(std::size_t i) { return static_cast<double>(i) - 0.5; }

std::string change_marks(const HistoryLine& line, const LineScale& scale) {
  std::string svg;
  for (const ChangePoint& change : line.changes) {
    const double first = scale.x(before(change.first)), last = scale.x(before(change.last));
    svg += fmt::format(
        "<rect class='band f1' x='{:.1f}' y='{}' width='{:.1f}' height='{}'/><path class='bound' "
        "d='M{:.1f} {}V{}'/>",
        std::max(first - 1, scale.left), scale.top, std::max(last - first, 0.0) + 2,
        scale.bottom - scale.top, scale.x(before(change.at)), scale.top, scale.bottom);
  }
  return svg;
}

/// The median between every two changes.
std::string levels(const HistoryLine& line, const LineScale& scale) {
  std::string svg;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= line.changes.size(); ++i) {
    const std::size_t end = i < line.changes.size() ? line.changes[i].at : line.values.size();
    const double y = scale.y(median({line.values.begin() + static_cast<std::ptrdiff_t>(begin),
                                     line.values.begin() + static_cast<std::ptrdiff_t>(end)}));
    svg += fmt::format("<polyline class='median s0' points='{:.1f},{:.1f} {:.1f},{:.1f}'/>",
                       scale.x(static_cast<double>(begin)), y,
                       scale.x(static_cast<double>(end - 1)), y);
    begin = end;
  }
  return svg;
}

std::string dots(const History& history, const HistoryLine& line, const LineScale& scale) {
  std::string svg;
  for (std::size_t i = 0; i < line.values.size(); ++i) {
    svg += fmt::format(
        "<circle class='f0' cx='{:.1f}' cy='{:.1f}' r='2.6'><title>{}: {}</title></circle>",
        scale.x(static_cast<double>(i)), scale.y(line.values[i]),
        escape(history.results[line.results[i]].name), value_text(line.measure, line.values[i]));
  }
  return svg;
}

/// Lines across at round percentages of the first value, or at the values where that is 0.
std::string value_grid(const HistoryLine& line, const LineScale& scale) {
  const double unit = line.values.front() > 0 ? line.values.front() : 1;
  const double reach = (scale.high - scale.low) / unit;
  double step = std::pow(10, std::floor(std::log10(reach / 2)));
  for (const double factor : {2.0, 2.5, 2.0}) {
    if (reach / step > 6) step *= factor;
  }
  std::string svg;
  const double zero = line.values.front() > 0 ? 1 : 0;
  const double first = std::ceil((scale.low / unit - zero) / step);
  for (double i = first; zero + i * step <= scale.high / unit + 1e-9; ++i) {
    const double y = scale.y((zero + i * step) * unit);
    const std::string label =
        zero > 0 ? fmt::format("{:+.3g} %", 100 * i * step + 0.0) : fmt::format("{:.3g}", i * step);
    svg += fmt::format(
        "<path d='M{} {:.1f}H{}'/><text x='{}' y='{:.1f}' text-anchor='end'>{}</text>", scale.left,
        y, scale.right, scale.left - 6, y + 4, i == 0 && zero > 0 ? "±0 %" : label);
  }
  return svg;
}

std::string commit_names(const History& history, const HistoryLine& line, const LineScale& scale) {
  std::string svg;
  const std::size_t step = (line.values.size() + kMostNames - 1) / kMostNames;
  for (std::size_t i = 0; i < line.values.size(); i += step) {
    svg += fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='middle'>{}</text>",
                       scale.x(static_cast<double>(i)), scale.bottom + 18,
                       escape(history.results[line.results[i]].name.substr(0, 8)));
  }
  return svg;
}

std::string line_figure(const History& history, const HistoryLine& line) {
  const LineScale scale = scale_of(line, kLeft, kRight, kTop, kBottom);
  const std::string title =
      fmt::format("{} of {}", to_string(line.measure), cell_label(line.cell.curve, line.cell.n));
  const std::string content =
      "<g class='grid labels'>" + value_grid(line, scale) + commit_names(history, line, scale) +
      fmt::format("<text x='{}' y='{}' text-anchor='middle'>commits</text>", (kLeft + kRight) / 2,
                  kBottom + 36) +
      "</g>" + change_marks(line, scale) + levels(line, scale) + dots(history, line, scale);
  std::string note =
      fmt::format("first value {}; environment {}", value_text(line.measure, line.values.front()),
                  line.environment + 1);
  for (const ChangePoint& change : line.changes) {
    note += fmt::format("; {}{}", effect_text(line, change), change.gradual ? " (gradual)" : "");
  }
  return fmt::format("<figure><figcaption><b>{}</b> <span>{}</span></figcaption>{}</figure>\n",
                     escape(title), escape(note),
                     report::svg_element(title + " over commits", report::kLabelledWidth,
                                         report::kHeight, content));
}

std::string sparkline(const History& history, const HistoryLine& line) {
  constexpr double kWidth = 132, kHeight = 30;
  const LineScale scale = scale_of(line, 3, kWidth - 3, 4, kHeight - 4);
  const std::string from = history.results[line.results.front()].name;
  const std::string to = history.results[line.results.back()].name;
  const std::string title = fmt::format("{} of {}: {} ({}) to {} ({})", to_string(line.measure),
                                        cell_label(line.cell.curve, line.cell.n),
                                        value_text(line.measure, line.values.front()), from,
                                        value_text(line.measure, line.values.back()), to);
  return fmt::format(
      "<svg class='spark' viewBox='0 0 {} {}' role='img' tabindex='0'><title>{}</title>{}{}</svg>",
      kWidth, kHeight, escape(title), change_marks(line, scale),
      polyline(line, scale, "median s0"));
}

using report::cell;
using report::note;

constexpr std::size_t kMostFigures = 60;
constexpr std::size_t kMostChanges = 1000;
constexpr std::size_t kMostCells = 5000;

constexpr const char* kMethods = R"html(<section id=methods><h2>Methods</h2>
<p><b>Values.</b> Time: of every graph the median of the repetitions (of the timing phase where there is one, in units of the yardsticks near
each), the geometric mean over the graphs of the cell, divided by how slow the machine was. Instructions: counted by callgrind (<code>ar3d study count</code>), geometric mean. Volume: lattice points of the box,
geometric mean. Bends: per edge. A cell with an unfinished row has no values in those results. Cells hold the same graphs throughout.</p>
<p><b>Lines.</b> Results of one study measured in one environment (processor, cores, kernel, compiler, flags, libraries, threads, variables). Unlike
environments are never joined. Times of a debug or sanitised build, or of a busy machine without yardsticks, are left out.</p>
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
  return "<!doctype html>\n<html lang=en><head><meta charset=utf-8><meta name=viewport "
         "content='width=device-width,initial-scale=1'><meta http-equiv=Content-Security-Policy "
         "content=\"default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; "
         "img-src data:\"><title>ar3d history: " +
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
      "change{}</span> {} results, {} environment{}; {} of {} lines judged</p></header>\n",
      escape(folder),
      judged == 0    ? "incomplete"
      : changes == 0 ? "pass"
                     : "violated",
      changes, changes == 1 ? "" : "s", history.results.size(), history.environments.size(),
      history.environments.size() == 1 ? "" : "s", judged, lines);
  if (judged < lines) {
    html += fmt::format(
        "<p>{} lines are not judged: times need {} results of one environment, the others two, and "
        "where all results have counts, these are judged and times are not.</p>\n",
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
  html += report::table_head(
      {"Change", "Effect", "Cell", "Between", "#Environment", "Find the commit"});
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

/// The lines of a cell in one environment and study.
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
  html += report::table_head({"Algorithm", "Family", "#n", "Study", "#Environment", "Time",
                              "Instructions", "Estimated cycles", "Volume", "Bends per edge",
                              "Crossings", "Smallest angle"});
  std::size_t shown = 0;
  for (const auto& [key, lines] : cells) {
    if (shown++ < kMostCells) html += cell_row(history, lines);
  }
  return html + "</tbody></table></div></section>\n";
}

std::string results_section(const History& history) {
  std::string html = "<section id=results><h2>Results</h2>" +
                     report::table_head({"#Place", "Name", "Commit", "Study", "Begun",
                                         "#Environment", "#Unfinished rows",
                                         "#Machine, times as slow as usual", "Times left out"});
  for (const CommitResults& one : history.results) {
    html += "<tr>" + cell(fmt::format("{}", one.place), true) + cell(escape(one.name)) +
            cell("<code>" + escape(one.source_hash.substr(0, 12)) + "</code>") +
            cell(escape(one.study)) + cell(escape(one.created)) +
            cell(fmt::format("{}", one.environment + 1), true) +
            cell(report::grouped(static_cast<std::int64_t>(one.unfinished)), true) +
            cell(fmt::format("{:.2f}", one.slowness), true) + note(escape(one.untimed)) + "</tr>\n";
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
  std::vector<std::string> columns = {"Setting"};
  for (std::size_t i = 0; i < history.environments.size(); ++i) {
    columns.push_back(fmt::format("{}", i + 1));
  }
  html += report::table_head(columns);
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
    html += report::row_head(name) + row + "</tr>\n";
  }
  return html + "</tbody></table></div></section>\n";
}

}  // namespace

std::string render_history(const History& history, const std::string& folder) {
  const std::vector<PlacedChange> changes = changes_in_order(history);
  return head(folder) + "<body>\n" + beginning(history, folder, changes.size()) +
         "<nav><a href='#changes'>What changed?</a><a href='#cells'>Every cell</a><a "
         "href='#results'>Results</a><a href='#environments'>Environments</a><a "
         "href='#methods'>Methods</a></nav>\n" +
         changes_section(history, changes) + cells_section(history) + results_section(history) +
         environments_section(history) + kMethods + "<script>" + report::table_script() +
         "</script>\n</body></html>\n";
}

}  // namespace ar3d
