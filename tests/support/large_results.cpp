#include "support/large_results.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <vector>

#include "ar3d/store/columns/run_columns.h"
#include "ar3d/store/columns/study_identity.h"
#include "ar3d/store/hdf5/results_file.h"
#include "ar3d/store/rows.h"

namespace ar3d::testing {
namespace {

constexpr std::string_view kAlgorithms[] = {"compact", "diamond", "grid", "two-bend"};

bool is_one_of(std::size_t row, std::size_t chosen, std::size_t rows, std::size_t offset) {
  if (chosen == 0) return false;
  const std::size_t step = rows / chosen;
  return row % step == offset % step && row / step < chosen;
}

RunRecord large_run(const LargeResults& like, std::size_t row) {
  const std::size_t graph = row / std::size(kAlgorithms);
  RunRecord run;
  run.row_key = fmt::format("{:032x}", row + 1);
  run.algorithm = kAlgorithms[row % std::size(kAlgorithms)];
  run.family = fmt::format("family-{}", graph % like.families);
  const auto n = std::int64_t{16} << (graph / like.families % like.sizes);
  run.requested_n = run.n = n;
  run.m = 3 * n / 2;
  run.instance_index = static_cast<std::int64_t>(graph / like.families / like.sizes);
  run.seed = graph * 0x9E3779B97F4A7C15;
  run.graph_hash = fmt::format("{:032x}", run.seed);
  run.drawing_hash = fmt::format("{:032x}", row * 0x9E3779B97F4A7C15);
  run.repetition = 0;
  run.workers = 1;
  run.session = 0;
  run.status = RunStatus::ok;
  run.violations = 0;
  const auto chance = static_cast<std::int64_t>(run.seed >> 33) % (n / 2);
  run.extents = {4 * n + chance, 4 * n, 6 * n};
  run.instance_bound = {5 * n, 5 * n, 7 * n};
  run.log2_volume = 0;
  for (const std::int64_t extent : run.extents) {
    run.log2_volume += std::log2(static_cast<double>(extent + 1));
  }
  run.bends = {0, 0, n, n / 2, 0, 0, 0, 0};
  run.total_edge_length = 10 * static_cast<double>(n);
  run.longest_edge_length = static_cast<double>(n);
  run.smallest_vertex_distance = 1;
  run.wall_s = run.cpu_s =
      1e-7 * (static_cast<double>(n) + std::floor(static_cast<double>(chance) / 8));
  if (is_one_of(row, like.violated, like.rows, 1)) {
    run.status = RunStatus::violated;
    run.violations = 1;
    run.message = "crossing: edges 3 and 7";
  } else if (is_one_of(row, like.unfinished, like.rows, 2)) {
    run.status = RunStatus::timeout;
    run.message = "no row within 1 s";
  }
  return run;
}

}  // namespace

void write_large_results(const LargeResults& like, const std::string& path) {
  StudyIdentity identity;
  identity.study_id = "large";
  identity.spec = "study = \"large\"\n";
  identity.spec_hash = content_hash(identity.spec);
  identity.source_hash = "made up";
  identity.created = "2024-01-01T00:00:00+00:00";
  identity.planned_rows = static_cast<std::int64_t>(like.rows);
  const SizeBound theorem{"here", "a page", {linear(16, 3), linear(16, 3), linear(8)}};
  std::vector<AlgorithmRecord> records;
  for (const std::string_view algorithm : kAlgorithms) {
    records.push_back({std::string(algorithm), "", theorem, {}});
  }
  identity.tables = {side_table<AlgorithmRecord>(records)};
  const auto read = [&](std::size_t row, char* record) {
    store_record(large_run(like, row), record);
  };
  write_results(identity, {{"started", "made up", 0}}, like.rows, read, path);
}

}  // namespace ar3d::testing
