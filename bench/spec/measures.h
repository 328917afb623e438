#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ar3d/bench/spec/size_function.h"

namespace ar3d {

/// How often a drawing is repeated in the timing phase: until the median's relative precision is
/// reached, between `least` and `most` times; exactly `most` times if precision is 0.
struct TimedRepetitions {
  std::uint32_t least = 0;
  std::uint32_t most = 0;
  double precision = 0;
};

/// Batches of equal drawings shared by 1, ... threads or ranks. strong: `drawings` in all, weak:
/// `drawings` for each of them.
struct Batches {
  std::vector<std::uint32_t> scales;  ///< how many share; from 1 on, increasing; empty: no batches
  std::uint32_t drawings = 1;
  std::uint32_t repetitions = 1;
};

/// What holds for the whole timing phase.
struct TimingRules {
  std::uint32_t warm_up = 1;      ///< drawings before each timed one, thrown away
  std::uint32_t concurrency = 1;  ///< timed drawings at the same time, each on a core of its own
  bool write = false;             ///< time the formatting as JSON lines too
};

/// What a study may cost. A row that passes its limit is a row with status timeout or
/// out_of_memory.
struct Budget {
  std::optional<SizeFunction> row_time_s;
  std::optional<SizeFunction> row_memory_bytes;
  std::optional<double> study_s;
  /// What the proof by counting may store at a time (CertifyOptions::proof_bytes); no limit of
  /// rows.
  std::optional<SizeFunction> certify_memory_bytes;
  bool limits_rows() const { return row_time_s || row_memory_bytes; }
};

}  // namespace ar3d
