// The rows that plots point at, as JSON for the page's script.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <set>

#include "ar3d/analysis/replay.h"
#include "ar3d/analysis/report/plot.h"
#include "ar3d/analysis/report/sections.h"
#include "ar3d/analysis/text.h"

namespace ar3d::report {
namespace {

/// A JSON string that may stand in a script element: no byte of it can end the element.
std::string json_string(std::string_view text) {
  std::string json = "\"";
  for (const char c : valid_utf8(text)) {
    const auto code = static_cast<unsigned char>(c);
    const bool is_special =
        code < 0x20 || std::string_view("\"\\<>&").find(c) != std::string_view::npos;
    json += is_special ? fmt::format("\\u{:04x}", code) : std::string(1, c);
  }
  return json + "\"";
}

/// What the rows of a curve share: label, and the draw command before n and behind the seed.
std::string curve_json(const CurveKey& key) {
  const CommandParts parts = draw_command_parts(key);
  return fmt::format("[{},{},{}]", json_string(family_label(key) + "\n" + algorithm_label(key)),
                     json_string(parts.before_n), json_string(parts.behind_seed));
}

std::string numbers(const std::array<double, 3>& values) {
  if (!(values[0] >= 0 && values[1] >= 0 && values[2] >= 0)) return "0";
  return fmt::format("[{:.6g},{:.6g},{:.6g}]", values[0], values[1], values[2]);
}

/// [curve, n, m, "seed", status, extents, own bound, theorem's bound, published bound, seconds]; 0
/// for what is missing.
std::string row_json(const DrawnGraph& graph, double log_seconds, std::size_t curve) {
  std::array<double, 3> own{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    own[axis] = static_cast<double>(graph.instance_bound[axis]);
  }
  return fmt::format("\"{}\":[{},{},{},\"{}\",0,[{},{},{}],{},{},{},{}]", graph.row, curve, graph.n,
                     graph.m, graph.seed, graph.extents[0], graph.extents[1], graph.extents[2],
                     numbers(own), numbers(graph.theorem_bound), numbers(graph.published_bound),
                     std::isnan(log_seconds) ? "0" : fmt::format("{:.3g}", std::exp(log_seconds)));
}

std::string row_json(const CensoredRow& row, std::size_t curve) {
  return fmt::format("\"{}\":[{},{},{},\"{}\",{},[-1,-1,-1],0,0,0,0]", row.row, curve, row.n, row.m,
                     row.seed, json_string(to_string(row.status)));
}

std::set<std::size_t> plotted_rows(const StudyAnalysis& analysis) {
  std::set<std::size_t> rows;
  for (const ScalingEntry& entry : analysis.scaling) {
    for (const SizeSample& size : entry.all) {
      for (const InstanceValue& instance : size.instances) rows.insert(instance.row);
    }
    for (const CensoredRow& row : entry.censored) rows.insert(row.row);
  }
  return rows;
}

}  // namespace

std::string plotted_rows_json(const StudyAnalysis& analysis) {
  const std::set<std::size_t> plotted = plotted_rows(analysis);
  std::string curves, rows;
  const auto add = [&](const std::string& row) { rows += (rows.empty() ? "" : ",\n") + row; };
  for (std::size_t c = 0; c < analysis.tally.curves.size(); ++c) {
    const CurveTally& curve = analysis.tally.curves[c];
    curves += (curves.empty() ? "" : ",\n") + curve_json(curve.key);
    for (const auto& [n, size] : curve.sizes) {
      for (const DrawnGraph& graph : size.graphs) {
        const double seconds = log_value(graph, Quantity::wall_s, curve.has_timing_rows);
        if (plotted.contains(graph.row)) add(row_json(graph, seconds, c));
      }
    }
    for (const CensoredRow& row : curve.censored) add(row_json(row, c));
  }
  return "{\"cells\":[" + curves + "],\n\"rows\":{" + rows + "}}";
}

}  // namespace ar3d::report
