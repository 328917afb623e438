#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/bench/plan/plan.h"
#include "support/test.h"

namespace ar3d::testing {

/// A cycle to be drawn by each algorithm, `repetitions` times, in one phase; keys "key0", "key1", …
inline PlannedInstance cycle_of(std::uint64_t n, const std::vector<const Algorithm*>& algorithms,
                                std::uint32_t repetitions = 1, RunPhase phase = RunPhase::metrics) {
  PlannedInstance instance;
  instance.choice = {&find_family("cycle"), {}};
  instance.requested_n = instance.n = n;
  for (const Algorithm* algorithm : algorithms) {
    for (std::uint32_t r = 0; r < repetitions; ++r) {
      PlannedRun run;
      run.choice = {algorithm, complete_options(*algorithm, {})};
      run.repetition = r;
      run.row = instance.runs.size();
      run.row_key = "key" + std::to_string(run.row);
      run.phase = phase;
      instance.runs.push_back(std::move(run));
    }
  }
  return instance;
}

/// The plan of one instance.
inline StudyPlan plan_of(PlannedInstance instance) {
  StudyPlan plan;
  plan.instances.push_back(std::move(instance));
  return plan;
}

/// The algorithm diamond, but drawing as the given function does.
inline Algorithm diamond_drawn_by(decltype(Algorithm::draw) draw) {
  Algorithm algorithm = find_algorithm("diamond");
  algorithm.draw = std::move(draw);
  return algorithm;
}

}  // namespace ar3d::testing
