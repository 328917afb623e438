#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "ar3d/analysis/report.h"
#include "ar3d/analysis/study_analysis.h"

namespace ar3d {

/// Takes a text piece by piece, so that what has a line per row need not fit into memory.
using TextSink = std::function<void(std::string_view)>;

/// The bounds table, one line per curve (algorithm, options, family, parameters), RFC 4180 with a
/// header line. Missing numbers are empty fields; slack is 1 - extent / bound.
std::string bounds_csv(const StudyAnalysis& analysis);

/// Every row: all metrics of verify/metrics/metrics.h, its own bound, the theorem's, the published
/// one, and the slack against the theorem's.
void rows_csv(const RowView& rows, const TextSink& write);

/// The growth of every quantity of every curve, one line each: exponent with 95 % interval, log
/// exponent with its own, label, reason and the sizes that were fitted.
std::string scaling_csv(const StudyAnalysis& analysis);

/// All tables of the study (docs/analysis.md, Report), as page and figures read them.
std::string analysis_json(const StudyAnalysis& analysis, const SinceReference& since = {});

}  // namespace ar3d
