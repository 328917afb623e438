#pragma once

#include <string>

#include "ar3d/records/run_storage.h"

namespace ar3d {

/// The bounds table, one line a cell (algorithm, options, family, parameters), RFC 4180 with a
/// header line. Missing numbers are empty fields; slack is 1 - extent / bound.
std::string bounds_csv(const Results& results);

/// Every row: all metrics of verify/metrics.h, its own bound, the theorem's, the published one, and
/// the slack against the theorem's.
std::string rows_csv(const Results& results);

/// The growth of every quantity of every cell, one line each: exponent with 95 % interval, log
/// exponent with its own, label, reason and the sizes that were fitted.
std::string scaling_csv(const Results& results);

/// Verdict, bounds table and growth as one JSON object; missing numbers are null.
std::string analysis_json(const Results& results);

}  // namespace ar3d
