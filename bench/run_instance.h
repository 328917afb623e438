#pragma once

#include <functional>

#include "ar3d/bench/plan.h"
#include "ar3d/results/run.h"

namespace ar3d {

/// Generates the graph once and makes the rows that are wanted: draws (timed), certifies (outside
/// that clock), measures. Nothing that goes wrong leaves this function: it becomes a row with a
/// status and a message. Repetitions stand in the outer loop, so that what disturbs the machine for
/// a moment disturbs all alike.
/// @param wanted  whether to make the row with that key; may be empty: all.
/// @param stop  asked before every row: true ends the instance without further rows; may be empty.
/// @param emit  called after every row with its place in the results; what it throws is passed on.
void run_instance(const PlannedInstance& instance,
                  const std::function<bool(const std::string& row_key)>& wanted,
                  const std::function<bool()>& stop,
                  const std::function<void(std::size_t row, Run run)>& emit);

}  // namespace ar3d
