#include "ar3d/bench/plan/work_order.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "ar3d/base/error.h"

namespace ar3d {

bool has_run(const PlannedInstance& instance, const std::function<bool(RunPhase)>& is_meant) {
  return std::any_of(instance.runs.begin(), instance.runs.end(),
                     [&](const PlannedRun& run) { return is_meant(run.phase); });
}

bool has_run(const StudyPlan& plan, const std::function<bool(RunPhase)>& is_meant) {
  const std::vector<PlannedBlock>& blocks = plan.instances.blocks();
  return std::any_of(blocks.begin(), blocks.end(),
                     [&](const PlannedBlock& block) { return has_run(block.first, is_meant); });
}

// Drawing is linear in n; certifying, which takes most of the time, sorts. The constant is what a
// row of no vertices takes.
double work_of_row(const PlannedInstance& instance) {
  const auto n = static_cast<double>(instance.n);
  return 200 + n * std::log2(n + 1);
}

double work_of_instance(const PlannedInstance& instance) {
  return work_of_row(instance) * static_cast<double>(instance.runs.size());
}

LargestFirst::LargestFirst(const StudyPlan& plan) {
  for (const PlannedBlock& block : plan.instances.blocks()) blocks_.push_back({&block, 0});
  std::stable_sort(blocks_.begin(), blocks_.end(), [](const Part& a, const Part& b) {
    return work_of_instance(a.block->first) > work_of_instance(b.block->first);
  });
  for (Part& part : blocks_) {
    part.first = size_;
    size_ += part.block->count;
  }
}

std::size_t LargestFirst::operator[](std::size_t i) const {
  expect(i < size_, "an order has that place");
  const auto behind =
      std::upper_bound(blocks_.begin(), blocks_.end(), i,
                       [](std::size_t wanted, const Part& part) { return wanted < part.first; });
  const Part& part = *std::prev(behind);
  return part.block->first_place + (i - part.first);
}

}  // namespace ar3d
