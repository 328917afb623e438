#pragma once

#include <signal.h>
#include <sys/resource.h>

#include <cstdint>
#include <string>

#include "ar3d/store/rows.h"
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

/// A study that exists only on paper, without its environment.
inline StudyIdentity sample_identity() {
  StudyIdentity identity;
  identity.study_id = "sample";
  identity.spec = "# h\xc3\xb6her\n[study]\n";
  identity.spec_hash = content_hash(identity.spec);
  identity.source_hash = std::string(40, 'b');
  identity.dirty = true;
  identity.dirty_hash = std::string(64, 'd');
  identity.created = "2026-01-02T03:04:05+00:00";
  identity.planned_rows = 100;
  return identity;
}

/// Its results with so many rows.
inline Results sample_results(std::int64_t count) {
  Results results;
  static_cast<StudyIdentity&>(results) = sample_identity();
  results.shard = {2, 3};
  results.environment = {{"cpu", "abacus"}, {"flags", "-O3 -DNDEBUG", 1}};
  for (std::int64_t i = 0; i < count; ++i) results.runs.push_back(sample_run(i));
  return results;
}

/// While it lives, the kernel refuses to let files grow past a size, as it refuses to on a full
/// disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(std::uint64_t bytes) : handler_(signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit small = before_;
    small.rlim_cur = bytes;
    EXPECT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  }
  ~FileSizeLimit() {
    EXPECT_EQ(setrlimit(RLIMIT_FSIZE, &before_), 0);
    signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

}  // namespace ar3d::testing
