#pragma once

#include <vector>

#include "ar3d/analysis/history/history.h"

namespace ar3d {

/// A change with the line that it is on.
struct PlacedChange {
  const HistoryLine* line = nullptr;
  const ChangePoint* change = nullptr;
};

/// All changes, the largest effects first; those that are no ratio last.
std::vector<PlacedChange> changes_in_order(const History& history);

/// The results before the change (the last that surely have not got it, if `surely`) and behind it.
struct Neighbours {
  const CommitResults* before = nullptr;
  const CommitResults* after = nullptr;
};
Neighbours around(const History& history, const PlacedChange& placed, bool surely);

/// "+10.2 %" of a logarithm of a ratio.
std::string percent_change(double log_ratio);

/// "slower", "fewer instructions", "larger volume", …
const char* direction_text(const PlacedChange& placed);

/// The value with its unit: "1.23 ms", "4.5e+06", "2.31".
std::string value_text(Measure measure, double value);

}  // namespace ar3d
