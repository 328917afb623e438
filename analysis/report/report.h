#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ar3d/analysis/check.h"
#include "ar3d/analysis/compare/compare.h"
#include "ar3d/analysis/scaling/scaling.h"
#include "ar3d/analysis/table.h"
#include "ar3d/analysis/tally.h"

namespace ar3d {

/// Returns the curve's axis of smallest slack, or nullopt if nothing was measured.
std::optional<std::size_t> worst_axis(const CurveTally& curve);

/// Describes everything that report and exports show of a study, computed once. `rows` outlives it.
struct StudyAnalysis {
  const Rows& rows;
  CheckVerdict verdict;
  StudyTally tally;
  std::vector<ScalingEntry> scaling;
};

/// Reads every row again. @param verdict  on these rows. Cost: that of tally_of and scaling.
StudyAnalysis analyse(const Rows& rows, CheckVerdict verdict);
/// Analyses the rows with check(rows).
StudyAnalysis analyse(const Rows& rows);

/// Holds what the study was compared with, or why with nothing.
struct SinceReference {
  std::string file;     ///< of the reference
  std::string created;  ///< of the reference
  std::optional<Comparison> comparison;
  std::string why_none = "No reference was given.";  ///< plain text; shown without a comparison
};

/// Describes drawings of the study's graphs that the page opens in its viewer.
struct ShownDrawings {
  std::map<std::size_t, std::size_t> page_of_row;  ///< which drawing of the viewer's page
  std::string packed_page;         ///< a page of `ar3d view`, in base64 of zlib's deflate format
  std::string script_hashes = {};  ///< of its scripts, as a content security policy names them
};

/// Returns every table of the study that anything shows (docs/analysis.md, Report).
/// @param all  false: what the page shows, which does not grow with the rows of a size.
std::vector<Table> report_tables(const StudyAnalysis& analysis, const SinceReference& since,
                                 const ShownDrawings& drawings, bool all);

/// Returns one HTML page about a study: its tables, and the scripts that show them. It needs nothing
/// from outside (no network, no other file); strings of the file are data there, never markup.
std::string render_report(const StudyAnalysis& analysis, const SinceReference& since = {},
                          const ShownDrawings& drawings = {});

/// Returns a page of the tree's template, "report" or "history", with these tables.
/// @param title  plain text.
std::string render_page(std::string_view page, std::string_view title,
                        const std::vector<Table>& tables, const ShownDrawings& drawings = {});

/// Returns the rows of the page that are worth storing a drawing of, most important first, at most
/// `most`. First come those of the listed findings and of the outliers of collections. Then, of
/// every curve, comes the graph closest to its bound among those with at most `most_edges` edges,
/// the closest first. Last come the other numbers of the heat maps in that order.
std::vector<std::size_t> rows_to_show(const StudyAnalysis& analysis, std::size_t most,
                                      std::int64_t most_edges);

/// Takes a text piece by piece, so that what has a line per row need not fit into memory.
using TextSink = std::function<void(std::string_view)>;

/// Returns the bounds table, one line per curve (algorithm, options, family, parameters), RFC 4180
/// with a header line. Missing numbers are empty fields; slack is 1 - extent / bound.
std::string bounds_csv(const StudyAnalysis& analysis);

/// Writes every row: all metrics of verify/metrics/metrics.h, its own bound, the theorem's, the
/// published one, and the slack against the theorem's.
void rows_csv(const Rows& rows, const TextSink& write);

/// Returns the growth of every quantity of every curve, one line each: exponent with 95 % interval,
/// log exponent with its own, label, reason and the sizes that were fitted.
std::string scaling_csv(const StudyAnalysis& analysis);

/// Returns all tables of the study (docs/analysis.md, Report), as page and figures read them.
std::string analysis_json(const StudyAnalysis& analysis, const SinceReference& since = {});

}  // namespace ar3d
