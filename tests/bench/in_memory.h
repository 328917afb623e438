#pragma once

// Studies made in memory, without files.

#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "ar3d/bench/measure/environment.h"
#include "ar3d/bench/run/describe_study.h"
#include "ar3d/bench/run/session.h"
#include "ar3d/store/columns/run_record.h"
#include "support/test.h"

namespace ar3d::testing {

/// Hands every row to a function; has no rows but those that it is given.
class FunctionSink final : public RowSink {
 public:
  using Take = std::function<void(std::size_t place, const RunRecord& row)>;
  explicit FunctionSink(Take take, std::unordered_map<std::string, RunRecord> finished = {})
      : take_(std::move(take)), finished_(std::move(finished)) {}
  bool has_any() const override { return !finished_.empty(); }
  bool has(const std::string& key) const override { return finished_.contains(key); }
  RunRecord read(const std::string& key) const override { return finished_.at(key); }
  void add(std::size_t place, const RunRecord& row) override { take_(place, row); }
  void note(const EnvironmentEntry& entry) override { notes.push_back(entry); }

  std::vector<EnvironmentEntry> notes;

 private:
  Take take_;
  std::unordered_map<std::string, RunRecord> finished_;
};

/// The rows of a plan in its order: those that are finished, and the others, made.
inline std::vector<RunRecord> run_plan(
    const StudyPlan& plan, const SessionPolicy& policy,
    const std::unordered_map<std::string, RunRecord>& finished = {},
    const std::function<void(const RunRecord&)>& on_row = {}) {
  std::vector<std::optional<RunRecord>> rows(plan.rows());
  for (const PlannedInstance& instance : plan.instances) {
    for (const PlannedRun& run : instance.runs) {
      const auto known = finished.find(run.row_key);
      if (known != finished.end()) rows[run.row] = known->second;
    }
  }
  FunctionSink sink(
      [&](std::size_t place, const RunRecord& row) {
        if (on_row) on_row(row);
        rows[place] = row;
      },
      finished);
  run_session(plan, policy, sink);
  std::vector<RunRecord> made;
  for (std::optional<RunRecord>& row : rows) {
    if (row) made.push_back(std::move(*row));
  }
  return made;
}

/// A whole study.
inline Results run_study(const StudySpec& spec, SessionPolicy policy = {}) {
  policy.name = spec.name;
  Results results = describe_study(spec, policy.workers);
  results.runs = run_plan(plan_study(spec), policy);
  results.environment.push_back({"load_after", load_average()});
  return results;
}

}  // namespace ar3d::testing
