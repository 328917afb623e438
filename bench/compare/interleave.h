#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/store/rows.h"

namespace ar3d {

struct InterleaveOptions {
  std::size_t rounds = 15;
  int core = -1;                  ///< that both programs are pinned to; -1: the last allowed one
  std::FILE* progress = nullptr;  ///< where to tell how far it is; null: nowhere
  bool count = false;             ///< `study count` after the first run of each
};

/// Holds what two programs measured in turns; base[i] and now[i] belong to round i.
struct InterleavedRounds {
  std::vector<Results> base;
  std::vector<Results> now;
  bool interrupted = false;  ///< (is_interrupted) the rounds are not all there
};

/// Runs the study with both programs in turns, base first in even rounds and last in odd ones, so
/// that a machine that gets slower or faster treats both alike. Each run is a process of its own on
/// one thread, pinned to one core; both programs run under paths of equal length. Files go into a
/// folder of their own in `folder`, which is removed afterwards.
/// @throws InputError naming round and program if one ends with anything but a verdict.
InterleavedRounds run_interleaved(const std::string& base_program, const std::string& new_program,
                                  const Study& study, const std::string& folder,
                                  const InterleaveOptions& options);

}  // namespace ar3d
