#include "ar3d/analysis/report/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "ar3d/analysis/replay.h"
#include "ar3d/analysis/report/figures.h"
#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/text.h"

namespace ar3d::report {
namespace {

std::string numbers(const std::array<double, 3>& values) {
  if (!(values[0] >= 0 && values[1] >= 0 && values[2] >= 0)) return "0";
  return fmt::format("[{:.6g},{:.6g},{:.6g}]", values[0], values[1], values[2]);
}

/// What the rows of a curve share: label, and the draw command before n and behind the seed, both
/// empty if that needs the results file.
std::string curve_json(const CurveKey& key, const ShowCommand& show) {
  const CommandParts parts = show.needs_results(key) ? CommandParts() : draw_command_parts(key);
  return fmt::format("[{},{},{}]", json_string(family_label(key) + "\n" + algorithm_label(key)),
                     json_string(parts.before_n), json_string(parts.behind_seed));
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
      fmt::format("[{},{},{},\"{}\",0,[{},{},{}],{},{},{},{}]", curve, graph.n, graph.m, graph.seed,
                  graph.extents[0], graph.extents[1], graph.extents[2], numbers(own),
                  numbers(graph.theorem_bound), numbers(graph.published_bound),
                  std::isnan(log_seconds) ? "0" : fmt::format("{:.3g}", std::exp(log_seconds)));
  return graph.row;
}

std::size_t Page::point_at(std::size_t curve, const CensoredRow& row) {
  rows_[row.row] = fmt::format("[{},{},{},\"{}\",{},[-1,-1,-1],0,0,0,0]", curve, row.n, row.m,
                               row.seed, json_string(to_string(row.status)));
  return row.row;
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
  return "{\"curves\":[" + curves + "],\n\"rows\":{" + rows + "}}";
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

}  // namespace ar3d::report
