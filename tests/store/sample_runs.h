#pragma once

#include <cstdint>
#include <string>

#include "ar3d/store/columns/run_record.h"
#include "support/test.h"

namespace ar3d::testing {

/// A row of a study that exists only on paper; rows with different numbers differ.
inline RunRecord sample_run(std::int64_t i) {
  RunRecord run;
  const std::string digits = std::to_string(i);
  run.row_key = "0123456789abcdef0123456789abcdef";
  run.row_key.replace(run.row_key.size() - digits.size(), digits.size(), digits);
  run.family = "petersen";
  run.parameters = "k=2;p=750000";
  run.requested_n = 10 + i / 2;
  run.n = run.requested_n;
  run.m = 15;
  run.instance_index = 0;
  run.seed = ~std::uint64_t{0} - static_cast<std::uint64_t>(i);
  run.graph_hash = "fedcba9876543210fedcba9876543210";
  run.algorithm = i % 2 == 0 ? "diamond" : "grid";
  run.options = "effort=1";
  run.repetition = i;
  run.status = RunStatus::ok;
  run.extents = {50, 52, std::int64_t{1} << 61};
  run.log2_volume = 0.1 * static_cast<double>(i);
  run.bends = {1, 2, 3, 4, 5, 6, 7, 8};
  run.violations = 0;
  run.counters = "H=3;mode=1";
  run.wall_s = 1e-9;
  return run;
}

}  // namespace ar3d::testing
