#pragma once

// Studies made in memory, without files.

#include <unistd.h>

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "ar3d/bench/measure/environment.h"
#include "ar3d/bench/run/session.h"
#include "ar3d/store/columns/run_record.h"
#include "support/test.h"

namespace ar3d::testing {

/// What a session has made: the rows by index, and the indices as they were made.
struct Made {
  std::map<std::size_t, RunRecord> rows;
  std::vector<std::size_t> order;
  std::vector<EnvironmentEntry> notes;
};

/// These rows, read from a results file.
inline Rows rows_of_a_file(const std::unordered_map<std::string, RunRecord>& finished) {
  Results results;
  results.spec_hash = content_hash("");
  results.environment = {{"started", "now"}};
  for (const auto& [key, run] : finished) results.runs.emplace_back(run).session = 0;
  const std::string path = ::testing::TempDir() + "finished-" + std::to_string(getpid()) + ".h5";
  write_results(results, path);
  Rows rows(std::vector<std::string>{path});
  std::filesystem::remove(path);
  return rows;
}

/// All rows of a plan but the finished ones, each once.
inline Made make(const StudyPlan& plan, const SessionPolicy& policy,
                 const std::unordered_map<std::string, RunRecord>& finished = {},
                 const std::function<void()>& after_each = {}) {
  Made made;
  RowSink sink{[&](std::size_t index, const RunRecord& row) {
                 made.order.push_back(index);
                 EXPECT_TRUE(made.rows.emplace(index, row).second) << "row " << index << " twice";
                 if (after_each) after_each();
               },
               [&](const EnvironmentEntry& entry) { made.notes.push_back(entry); }};
  std::optional<Rows> there;
  if (!finished.empty()) sink.there = &there.emplace(rows_of_a_file(finished));
  run_session(plan, policy, sink);
  return made;
}

/// All rows of a plan in its order.
inline std::vector<RunRecord> made_rows(const StudyPlan& plan, const SessionPolicy& policy = {}) {
  std::vector<RunRecord> rows;
  for (const auto& [index, row] : make(plan, policy).rows) rows.push_back(row);
  EXPECT_EQ(rows.size(), plan.rows());
  rows.resize(plan.rows());
  return rows;
}

/// A whole study.
inline Results run_study(const Study& study, SessionPolicy policy = {}) {
  policy.name = study.spec.name;
  Results results = describe_study(study, policy.workers);
  results.runs = made_rows(plan_study(study), policy);
  results.environment.push_back({"load_after", load_average()});
  return results;
}

}  // namespace ar3d::testing
