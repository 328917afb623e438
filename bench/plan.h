#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ar3d/bench/study_spec.h"
#include "ar3d/results/run.h"

namespace ar3d {

/// One row to come: an algorithm with options, and which repetition.
struct PlannedRun {
  AlgorithmChoice choice;
  std::string options;  ///< "effort=1"
  std::uint32_t repetition = 0;
  std::string row_key;  ///< 32 hexadecimal digits
  std::size_t row = 0;  ///< place in the results
  RunPhase phase = RunPhase::metrics;
  std::int64_t scale = -1;  ///< threads of a strong or weak batch, else -1
  std::uint32_t batch = 0;  ///< strong, weak: rows with equal scale and batch are drawn together
  /// A study is complete without it: it is only made while the median of the repetitions before it
  /// is less precise than `precision`.
  bool optional = false;
  double precision = 0;
};

/// One graph to come and everything that is done with it.
struct PlannedInstance {
  FamilyChoice choice;
  std::string parameters;  ///< "k=2;p=750000"
  std::uint64_t wanted_n = 0;
  std::uint64_t n = 0;  ///< what the family makes of wanted_n
  std::uint32_t index = 0;
  std::uint64_t seed = 0;  ///< a function of the study's seed, family, parameters, n and index only
  std::vector<PlannedRun> runs;
};

/// All rows of a study, in the order of the specification: family, parameters, size, index,
/// algorithm, options, repetition. Two sizes that a family rounds to the same n are one instance; a
/// row that two sweeps ask for is planned once.
struct StudyPlan {
  std::vector<PlannedInstance> instances;
  std::size_t rows = 0;
  TimingRules timing;  ///< of the specification
  Budget budget;       ///< of the specification
};

/// Leaves out an algorithm where the family's graphs pass its maximum degree (found by generating
/// one of at most 1000 vertices) or n passes spec.max_n.
/// @throws InputError if nothing is left or there are more than 10^7 rows.
StudyPlan plan_study(const StudySpec& spec);

}  // namespace ar3d
