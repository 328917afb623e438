#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "ar3d/bench/plan/plan.h"

namespace ar3d {

/// True if a run of the instance is of a phase that is meant.
bool has_run(const PlannedInstance& instance, const std::function<bool(RunPhase)>& is_meant);
/// True if any instance of the plan has one.
bool has_run(const StudyPlan& plan, const std::function<bool(RunPhase)>& is_meant);

/// Work that a row is, in a unit that is roughly proportional to time.
double work_of_row(const PlannedInstance& instance);
/// Work of all its rows.
double work_of_instance(const PlannedInstance& instance);

/// The places of plan.instances, the most costly first, so that no large one is left to the end;
/// equally costly ones in the plan's order. The plan outlives it.
class LargestFirst {
 public:
  explicit LargestFirst(const StudyPlan& plan);
  std::size_t size() const { return size_; }
  std::size_t operator[](std::size_t i) const;

 private:
  struct Part {
    const PlannedBlock* block = nullptr;
    std::size_t first = 0;  // of its instances, in this order
  };
  std::vector<Part> blocks_;
  std::size_t size_ = 0;
};

}  // namespace ar3d
