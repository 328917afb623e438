// What the sections of a page share, and every figure as documents of its own: SVG, CSV, and
// scripts for matplotlib and pgfplots.
#include "ar3d/analysis/report/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "ar3d/analysis/replay.h"
#include "ar3d/analysis/report/html.h"
#include "ar3d/base/printable.h"

namespace ar3d::report {

namespace {

std::string numbers(const std::array<double, 3>& values) {
  if (!(values[0] >= 0 && values[1] >= 0 && values[2] >= 0)) return "0";
  return fmt::format("[{:.6g},{:.6g},{:.6g}]", values[0], values[1], values[2]);
}

/// What the rows of a curve share: label, and the draw command before n and behind the seed, both
/// empty if that needs the results file.
std::string curve_json(const CurveKey& key, const ShowCommand& show) {
  std::pair<std::string, std::string> parts;
  if (!show.needs_results(key)) parts = draw_command_parts(key);
  return fmt::format("[{},{},{}]", json_string(family_label(key) + "\n" + algorithm_label(key)),
                     json_string(parts.first), json_string(parts.second));
}

std::string number_field(double log10) {
  return std::isnan(log10) ? "" : fmt::format("{:.5g}", std::pow(10, log10));
}

/// The lines with the number of their series in front, and what the columns are called above.
std::string with_ids(const std::string& lines) {
  std::map<std::string, std::size_t> id_of;  // by series and kind
  std::string csv = "id,series,kind,x,y,low,high\r\n";
  for (std::size_t at = 0; at < lines.size();) {
    const std::size_t end = lines.find('\n', at) + 1;
    const std::size_t name_end = lines.find(',', lines.find(',', at) + 1);
    const auto [id, is_new] = id_of.try_emplace(lines.substr(at, name_end - at), id_of.size());
    csv += fmt::format("{},{}", id->second, lines.substr(at, end - at));
    at = end;
  }
  return csv;
}

}  // namespace

std::size_t Page::point_at(std::size_t curve, const DrawnGraph& graph) {
  if (rows_.contains(graph.row)) return graph.row;
  std::array<double, 3> own{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    own[axis] = static_cast<double>(graph.instance_bound[axis]);
  }
  const bool timed = analysis.tally.curves[curve].has_timing_rows;
  const double log_seconds = log_value(graph, Quantity::wall_s, timed);
  rows_[graph.row] =
      fmt::format("[{},{},{},\"{}\",0,[{},{},{}],{},{},{},{},{}]", curve, graph.n, graph.m,
                  graph.seed, graph.extents[0], graph.extents[1], graph.extents[2], numbers(own),
                  numbers(graph.theorem_bound), numbers(graph.published_bound),
                  std::isnan(log_seconds) ? "0" : fmt::format("{:.3g}", std::exp(log_seconds)),
                  graph.name.empty() ? "0" : json_string(graph.name));
  return graph.row;
}

std::size_t Page::point_at(std::size_t curve, const CensoredRow& row) {
  rows_[row.row] = fmt::format("[{},{},{},\"{}\",{},[-1,-1,-1],0,0,0,0]", curve, row.n, row.m,
                               row.seed, json_string(to_string(row.status)));
  return row.row;
}

bool Page::point_at(std::size_t row) {
  if (rows_.contains(row)) return true;
  const RunRecord run = analysis.rows.read(row);
  const std::vector<CurveTally>& curves = analysis.tally.curves;
  const auto at = std::find_if(curves.begin(), curves.end(),
                               [key = curve_of(run)](const auto& one) { return one.key == key; });
  if (at == curves.end()) return false;
  rows_[row] =
      fmt::format("[{},{},{},\"{}\",{},[{},{},{}],0,{},{},0]", at - curves.begin(),
                  run.n >= 0 ? run.n : run.requested_n, run.m, run.seed,
                  json_string(to_string(run.status)), run.extents[0], run.extents[1],
                  run.extents[2], numbers(run.theorem_bound), numbers(run.published_bound));
  return true;
}

std::string Page::rows_json() const {
  std::string curves, rows;
  const ShowCommand show(analysis.rows);
  for (const CurveTally& curve : analysis.tally.curves) {
    curves += (curves.empty() ? "" : ",\n") + curve_json(curve.key, show);
  }
  for (const auto& [row, json] : rows_) {
    rows += fmt::format("{}\"{}\":{}", rows.empty() ? "" : ",\n", row, json);
  }
  return "{\"replay\":" + json_string("ar3d replay " + shell_word(analysis.rows.file) + " ") +
         ",\n\"curves\":[" + curves + "],\n\"rows\":{" + rows + "}}";
}

std::string Page::figure(NamedPlot plot, const std::string& attributes) {
  const std::string wanted = slug(plot.file);
  plot.file = wanted;
  const auto is_taken = [&](const NamedPlot& other) { return other.file == plot.file; };
  for (int i = 2; std::any_of(figures_.begin(), figures_.end(), is_taken); ++i) {
    plot.file = fmt::format("{}-{}", wanted, i);
  }
  plot.csv = with_ids(plot.csv);
  figures_.push_back(plot);
  return fmt::format(
      "<figure data-fig='{}'{}><figcaption><b>{}</b> <span>{}</span></figcaption>{}{}</figure>\n",
      plot.file, attributes, escape(plot.title), escape(plot.note), plot.svg, plot.legend);
}

std::string Page::figures_json() const {
  std::string json;
  for (const NamedPlot& plot : figures_) {
    json += fmt::format("{}\"{}\":[{},{},{}]", json.empty() ? "" : ",\n", plot.file,
                        json_string(plot.csv), json_string(matplotlib_script(plot)),
                        json_string(pgfplots_document(plot)));
  }
  return "{" + json + "}";
}

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

std::string csv_line(const std::string& series, const char* kind, double log_x, double log_y,
                     double log_low, double log_high) {
  std::string name = one_line(series);
  std::replace(name.begin(), name.end(), ',', ';');
  std::replace(name.begin(), name.end(), '"', '\'');
  return fmt::format("{},{},{},{},{},{}\r\n", name, kind, number_field(log_x), number_field(log_y),
                     number_field(log_low), number_field(log_high));
}

namespace {

constexpr std::size_t kNamedSeries = 8;  // in a legend

/// The content without the lines of families that the page shows on demand; such a group holds no
/// other.
std::string without_hidden(std::string svg) {
  constexpr std::string_view kHidden = "<g class='family' ", kEnd = "</g>";
  for (std::size_t at = svg.find(kHidden); at != std::string::npos; at = svg.find(kHidden, at)) {
    svg.erase(at, svg.find(kEnd, at) + kEnd.size() - at);
  }
  return svg;
}

/// Text as LaTeX prints it.
std::string latex(const std::string& text) {
  static constexpr std::pair<char, const char*> kSpecial[] = {{'\\', "\\textbackslash{}"},
                                                              {'{', "\\{"},
                                                              {'}', "\\}"},
                                                              {'$', "\\$"},
                                                              {'&', "\\&"},
                                                              {'#', "\\#"},
                                                              {'^', "\\textasciicircum{}"},
                                                              {'_', "\\_"},
                                                              {'~', "\\textasciitilde{}"},
                                                              {'%', "\\%"}};
  std::string escaped;
  for (const char c : text) {
    const auto* at = std::find_if(std::begin(kSpecial), std::end(kSpecial),
                                  [c](const auto& special) { return special.first == c; });
    if (at != std::end(kSpecial)) {
      escaped += at->second;
    } else if (static_cast<unsigned char>(c) < 0x80) {
      escaped += c;
    }
  }
  return escaped;
}

/// Name and kind of the series with each id.
std::vector<std::pair<std::string, std::string>> series_of(const std::string& csv) {
  std::vector<std::pair<std::string, std::string>> series;
  for (std::size_t at = csv.find('\n') + 1; at < csv.size(); at = csv.find('\n', at) + 1) {
    std::vector<std::string> fields;
    for (std::size_t begin = at; fields.size() < 3;) {
      const std::size_t comma = csv.find(',', begin);
      fields.push_back(csv.substr(begin, comma - begin));
      begin = comma + 1;
    }
    if (std::stoul(fields[0]) == series.size()) series.emplace_back(fields[1], fields[2]);
  }
  return series;
}

/// What draws one series.
std::string addplot(const std::string& file, std::size_t id, const std::string& name,
                    const std::string& kind, bool is_named) {
  const std::string option = kind == "dashed"  ? "dashed, no marks, thick, red!70!black"
                             : kind == "band"  ? "no marks, very thick, blue"
                             : kind == "point" ? "only marks"
                             : kind == "bar"   ? "ybar, fill=blue!50"
                             : is_named        ? "mark size=1pt"
                                               : "no marks, gray!50, forget plot";
  std::string text =
      fmt::format("\\addplot+[{}, only={}] table[x=x, y=y] {{{}.csv}};\n", option, id, file);
  if (is_named) text += "\\addlegendentry{" + latex(name) + "}\n";
  return text;
}

constexpr const char* kMatplotlib = R"py(#!/usr/bin/env python3
# Draws {file}.csv, which lies beside this script:  {file}.py [OUTPUT.pdf]
# The output is {file}-matplotlib.pdf beside it if left out; one that exists stays as it is.
import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

here = pathlib.Path(__file__).resolve().parent
output = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else here / "{file}-matplotlib.pdf"
if output.exists():
    sys.exit(f"{{output}} exists already")
series = {{}}
with open(here / "{file}.csv", newline="") as table:
    for row in csv.DictReader(table):
        numbers = [float(row[column] or "nan") for column in ("x", "y", "low", "high")]
        series.setdefault((row["series"], row["kind"]), []).append(numbers)

figure, axes = plt.subplots(figsize=(5.2, 3.4))
for index, ((name, kind), rows) in enumerate(series.items()):
    x, y, low, high = zip(*rows)
    label = name if len(series) <= 12 or kind != "line" else None
    if kind == "bar":
        axes.bar(x, y)
    elif kind == "band":
        axes.fill_between(x, low, high, alpha=0.2)
        axes.plot(x, y, linewidth=2, label=label)
    elif kind == "dashed":
        axes.plot(x, y, "--", color="tab:red", label=label)
    elif kind == "point":
        axes.plot(x, y, "o", label=label)
    else:
        axes.plot(x, y, linewidth=1 if label else 0.4, color=None if label else "0.6", label=label)
if not any(kind == "bar" for name, kind in series):
    axes.set_xscale("log")
    axes.set_yscale("{y_scale}")
    axes.legend(fontsize="x-small")
axes.set_title({title}, fontsize="small")
axes.set_xlabel({x})
axes.set_ylabel({y})
figure.tight_layout()
figure.savefig(output)
)py";

constexpr const char* kPgfplots =
    R"tex(% Draws {file}.csv, which lies beside this document, where LaTeX is to be called.
\documentclass{{article}}
\usepackage{{pgfplots}}
\pgfplotsset{{compat=1.16, table/col sep=comma,
  only/.style={{x filter/.append code={{\ifnum\thisrow{{id}}=#1\relax\else\def\pgfmathresult{{}}\fi}}}}}}
\pagestyle{{empty}}
\begin{{document}}
\begin{{tikzpicture}}
\begin{{{axis}}}[title={{{title}}}, xlabel={{{x}}}, ylabel={{{y}}}, width=12cm, height=8cm,
  unbounded coords=discard, filter discard warning=false, legend style={{font=\tiny}},
  legend pos=outer north east, legend cell align=left]
{plots}\end{{{axis}}}
\end{{tikzpicture}}
\end{{document}}
)tex";

}  // namespace

std::string standalone_svg(const NamedPlot& plot) {
  const std::string svg = without_hidden(plot.svg);
  const std::size_t begin = svg.find('>') + 1, end = svg.rfind("</svg>");
  const std::size_t box = svg.find("viewBox='0 0 ") + 13;
  const double width = std::stod(svg.substr(box));
  const double height = std::stod(svg.substr(svg.find(' ', box)));
  return fmt::format(
      "<?xml version='1.0' encoding='UTF-8'?>\n<svg xmlns='http://www.w3.org/2000/svg' width='{0}' "
      "height='{1}' viewBox='0 0 {0} {1}'><title>{2}</title><style>{3}</style>{4}</svg>\n",
      width, height, escape(plot.title), figure_style(), svg.substr(begin, end - begin));
}

std::string matplotlib_script(const NamedPlot& plot) {
  return fmt::format(fmt::runtime(kMatplotlib), fmt::arg("file", plot.file),
                     fmt::arg("title", json_string(plot.title)), fmt::arg("x", json_string(plot.x)),
                     fmt::arg("y", json_string(plot.y)),
                     fmt::arg("y_scale", plot.has_linear_y ? "linear" : "log"));
}

std::string pgfplots_document(const NamedPlot& plot) {
  const auto series = series_of(plot.csv);
  const bool is_bar = !series.empty() && series.front().second == "bar";
  std::string plots;
  std::size_t named = 0;
  for (std::size_t id = 0; id < series.size(); ++id) {
    const auto& [name, kind] = series[id];
    const bool is_line = kind == "line" && series.size() > kNamedSeries;
    const bool is_named = !is_bar && !is_line && named < kNamedSeries;
    named += is_named;
    plots += addplot(plot.file, id, name, kind, is_named);
  }
  return fmt::format(fmt::runtime(kPgfplots), fmt::arg("file", plot.file),
                     fmt::arg("axis", is_bar              ? "axis"
                                      : plot.has_linear_y ? "semilogxaxis"
                                                          : "loglogaxis"),
                     fmt::arg("title", latex(plot.title)), fmt::arg("x", latex(plot.x)),
                     fmt::arg("y", latex(plot.y)), fmt::arg("plots", plots));
}

}  // namespace ar3d::report
