#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <string>
#include <vector>

#include "ar3d/analysis/report/report.h"
#include "ar3d/base/random.h"
#include "ar3d/store/columns/run_columns.h"
#include "ar3d/store/rows.h"
#include "support/tables.h"
#include "support/test.h"

namespace ar3d::testing {

/// Standard normal (Box-Muller), good enough for noise of known spread.
inline double normal(RandomStream& random) {
  const double radius = std::sqrt(-2 * std::log(1 - random.unit()));
  return radius * std::cos(2 * std::numbers::pi * random.unit());
}

/// A row as a study would write it: extents of about 4n, 4n, 6n in a box 16n/3, 16n/3, 8n.
inline RunRecord good_run(const std::string& algorithm, const std::string& family, std::int64_t n,
                          std::int64_t instance, std::int64_t repetition = 0) {
  RunRecord run;
  run.algorithm = algorithm;
  run.family = family;
  run.requested_n = run.n = n;
  run.m = 2 * n;
  run.instance_index = instance;
  run.seed = static_cast<std::uint64_t>(1000 * n + instance);
  run.graph_hash = std::to_string(run.seed);
  run.repetition = repetition;
  run.status = RunStatus::ok;
  RandomStream random(run.seed);
  const auto n_float = static_cast<double>(n);
  run.theorem_bound = {16 * n_float / 3, 16 * n_float / 3, 8 * n_float};
  run.instance_bound = {5 * n, 5 * n, 7 * n};
  run.extents = {4 * n + random.below(static_cast<std::uint32_t>(n / 2 + 1)), 4 * n, 6 * n};
  run.log2_volume = 0;
  for (const std::int64_t extent : run.extents) {
    run.log2_volume += std::log2(static_cast<double>(extent + 1));
  }
  run.bends = {0, 0, n, n, 0, 0, 0, 0};
  run.violations = 0;
  run.wall_s = 1e-7 * n_float * std::exp(0.1 * normal(random));
  return run;
}

/// Sets a metric that has no member of its own.
template <class Value>
void set_metric(const char* name, Value value, RunRecord& run) {
  std::vector<char> record = record_of(run);
  std::memcpy(&record[run_column(name).offset], &value, sizeof(value));
  run.other_metrics = load_record(record.data()).other_metrics;
}

/// All combinations, sizes 16, 32, … doubling.
inline Results good_results(const std::vector<std::string>& algorithms,
                            const std::vector<std::string>& families, std::size_t sizes,
                            std::int64_t instances) {
  Results results;
  results.study_id = "synthetic";
  results.spec_hash = content_hash(results.spec);
  const SizeBound theorem{"here", "a page", {{{16, 3, 2, 0}, {16, 3, 2, 0}, {8, 1, 2, 0}}}};
  std::vector<AlgorithmRecord> records;
  for (const std::string& algorithm : algorithms) records.push_back({algorithm, "", theorem, {}});
  results.tables = {side_table<AlgorithmRecord>(records)};
  for (const std::string& algorithm : algorithms) {
    for (const std::string& family : families) {
      for (std::size_t s = 0; s < sizes; ++s) {
        for (std::int64_t i = 0; i < instances; ++i) {
          results.runs.push_back(good_run(algorithm, family, std::int64_t{16} << s, i));
        }
      }
    }
  }
  return results;
}

inline CheckVerdict check(const Results& results) { return ar3d::check(Rows(results)); }

inline StudyTally tally_of(const Results& results) {
  return ar3d::tally_of(Rows(results), check(results).is_last_repetition);
}

/// The curves, with their medians and bounds.
inline std::vector<CurveTally> curves_of(const Results& results) {
  return analyse(Rows(results)).tally.curves;
}

inline std::string report_of(const Results& results) {
  return render_report(analyse(Rows(results)));
}

inline nlohmann::json rows_by_table(const std::vector<Table>& tables) {
  return rows_by_table(tables_json(tables));
}

/// The tables of the study's page.
inline nlohmann::json tables_of(const Results& results, const SinceReference& since = {}) {
  return rows_by_table(report_tables(analyse(Rows(results)), since, {}, false));
}

/// Gives every row a second one of the timing phase.
inline Results timed(Results results) {
  const std::size_t count = results.runs.size();
  for (std::size_t i = 0; i < count; ++i) {
    results.runs.push_back(results.runs[i]);
    results.runs.back().phase = RunPhase::timing;
  }
  return results;
}

/// 3 algorithms x 10 families x 10 sizes with `repetitions` each: 300 cells.
inline Results results_of(std::int64_t repetitions, std::uint64_t noise_seed) {
  Results results;
  results.study_id = "synthetic";
  results.environment = {{"cpu", "A", 0},
                         {"cores", "2", 0},
                         {"flags", "-O3", 0},
                         {"started", std::to_string(noise_seed), 0},
                         {"source_hash", std::to_string(noise_seed), 0}};
  RandomStream random(noise_seed);
  for (const char* algorithm : {"diamond", "grid", "two-bend"}) {
    for (int family = 0; family < 10; ++family) {
      for (int size = 0; size < 10; ++size) {
        for (std::int64_t repetition = 0; repetition < repetitions; ++repetition) {
          RunRecord run =
              good_run(algorithm, "family" + std::to_string(family), 16 << size, 0, repetition);
          run.wall_s *= std::exp(0.02 * normal(random));
          results.runs.push_back(run);
        }
      }
    }
  }
  return results;
}

}  // namespace ar3d::testing
