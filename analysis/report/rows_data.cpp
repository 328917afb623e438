// The rows that plots point at, as JSON for the page's script.
#include <fmt/format.h>

#include <array>
#include <map>
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

/// What the rows of a cell share: label, and the draw command before n and behind the seed.
std::string cell_json(const RunRecord& run) {
  const CommandParts parts = draw_command_parts(run);
  const CellKey key{run.algorithm, run.options, run.family, run.parameters};
  return fmt::format("[{},{},{}]", json_string(family_label(key) + "\n" + algorithm_label(key)),
                     json_string(parts.before_n), json_string(parts.behind_seed));
}

std::string numbers(const std::array<double, 3>& values) {
  if (!(values[0] >= 0 && values[1] >= 0 && values[2] >= 0)) return "0";
  return fmt::format("[{:.6g},{:.6g},{:.6g}]", values[0], values[1], values[2]);
}

/// [cell, n, m, "seed", status, extents, own bound, theorem's bound, published bound, seconds]; 0
/// for what is missing.
std::string row_json(const RunRecord& run, std::size_t cell) {
  std::array<double, 3> own{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    own[axis] = static_cast<double>(run.instance_bound[axis]);
  }
  const std::string status = run.status == RunStatus::ok ? "0" : json_string(to_string(run.status));
  return fmt::format("[{},{},{},\"{}\",{},[{},{},{}],{},{},{},{}]", cell, run.n, run.m, run.seed,
                     status, run.extents[0], run.extents[1], run.extents[2], numbers(own),
                     numbers(run.theorem_bound), numbers(run.published_bound),
                     run.wall_s > 0 ? fmt::format("{:.3g}", run.wall_s) : "0");
}

std::set<std::size_t> plotted_rows(const Analysis& analysis) {
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

std::string plotted_rows_json(const Analysis& analysis) {
  std::map<CellKey, std::size_t> cell_of;
  std::string cells, rows;
  for (const std::size_t row : plotted_rows(analysis)) {
    const RunRecord& run = analysis.results.runs[row];
    const CellKey key{run.algorithm, run.options, run.family, run.parameters};
    const auto [place, is_new] = cell_of.try_emplace(key, cell_of.size());
    if (is_new) cells += (cells.empty() ? "" : ",\n") + cell_json(run);
    rows +=
        fmt::format("{}\"{}\":{}", rows.empty() ? "" : ",\n", row, row_json(run, place->second));
  }
  return "{\"cells\":[" + cells + "],\n\"rows\":{" + rows + "}}";
}

}  // namespace ar3d::report
