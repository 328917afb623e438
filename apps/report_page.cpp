// What a report shows beside its study: what changed since a reference, and drawings made again.
#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/bench/compare/interleave.h"
#include "ar3d/bench/replay/replay_row.h"
#include "ar3d/formats/drawings/drawing_html.h"
#include "ar3d/formats/drawings/edge_roles.h"
#include "study_rows.h"
#include "view.h"

namespace ar3d {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostDrawings = 200, kMostBytes = 300'000;
constexpr std::int64_t kMostEdges = 1000, kMostVertices = 4000, kMostGraphs = 100'000;
/// Rows that a page compares; they are held in memory.
constexpr std::size_t kMostCompared = 200'000;

/// Compares with that file. @throws InputError as compare and read_results.
SinceReference since(const Rows& rows, const std::string& reference) {
  SinceReference found;
  if (rows.size() > kMostCompared || Rows(reference).size() > kMostCompared) {
    found.why_none =
        fmt::format("a page compares at most {} rows; ar3d compare has no limit.", kMostCompared);
    return found;
  }
  const Results base = read_results(reference);
  found.comparison = compare(base, in_memory(rows));
  found.file = fs::path(reference).filename().string();
  found.created = base.created;
  return found;
}

SinceReference since_committed(const Rows& rows) {
  SinceReference none;
  try {
    const std::string reference = committed_reference(rows.identity().study_id);
    if (!reference.empty()) return since(rows, reference);
    none.why_none =
        fmt::format("results/reference has no results of study '{}'.", rows.identity().study_id);
  } catch (const InputError& error) {
    none.why_none = std::string(error.what()) + ".";
  }
  return none;
}

}  // namespace

std::string committed_reference(const std::string& study_id) {
  const fs::path folder = fs::path(find_checkout()) / "results" / "reference";
  if (!fs::is_directory(folder)) return {};
  std::vector<std::string> named;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().filename().string().ends_with("-" + study_id + ".h5")) {
      named.push_back(entry.path().string());
    }
  }
  std::sort(named.rbegin(), named.rend());
  for (const std::string& path : named) {  // "0.1.0-compact-volume.h5" ends like a "volume"
    if (Rows(path).identity().study_id == study_id) return path;
  }
  return {};
}

ShownDrawings shown_drawings(const StudyAnalysis& analysis) {
  ShownDrawings shown;
  std::string text;
  ViewerPage page([&](std::string_view piece) { text += piece; });
  const std::size_t empty = text.size();
  const StudyOrigin origin = study_origin(analysis.rows.identity());
  std::set<std::string> too_large;  // files that a page does not read
  for (const GraphFileRecord& file : side_records<GraphFileRecord>(analysis.rows.identity())) {
    if (file.graphs > kMostGraphs) too_large.insert(file.name);
  }
  for (const std::size_t index : rows_to_show(analysis, kMostDrawings, kMostEdges)) {
    if (text.size() - empty > kMostBytes) break;
    const RunRecord row = analysis.rows.run(index);
    const Algorithm* const algorithm = known_algorithm(row.algorithm);  // no program of the study
    // However few edges the file says that it has.
    if (algorithm == nullptr || row.n > kMostVertices || too_large.contains(row.family)) continue;
    std::string ignored;
    const std::optional<Drawing> drawing = drawn_again(row, origin, ignored);
    if (!drawing) continue;
    const std::string& name = row.graph_name;  // stands first: what a narrow list does not cut
    const std::string title =
        fmt::format("{}{}{}{}{}, n = {}{}", family_label(curve_of(row)), name.empty() ? "" : ", ",
                    name, row.options.empty() ? "" : ", ", row.options, row.n,
                    name.empty() ? fmt::format(", seed {}", row.seed) : "");
    page.add(page_entry(title, *drawing, &algorithm->guarantee, page_verdict(*drawing, algorithm)));
    shown.page_of_row.emplace(index, shown.page_of_row.size());
  }
  if (shown.page_of_row.empty()) return shown;
  page.finish();
  shown.packed_page = packed_text(text);
  shown.script_hashes = viewer_script_hashes();
  return shown;
}

SinceReference since_reference(const Rows& rows, const std::string& reference) {
  return reference.empty() ? since_committed(rows) : since(rows, reference);
}

}  // namespace ar3d
