#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>

#include "ar3d/bench/plan/plan.h"
#include "ar3d/bench/run/estimate.h"
#include "ar3d/bench/run/make_rows.h"
#include "ar3d/bench/spec/study_spec.h"
#include "commands.h"
#include "numbers.h"
#include "study.h"
#include "study_choice.h"

namespace ar3d {
namespace {

// From this size on, a calibration costs nothing beside the study.
constexpr std::uint64_t kLargeSize = 200000;

std::string about(double seconds) {
  if (seconds < 0.1) return fmt::format("{:.2g} ms", 1e3 * seconds);
  if (seconds < 120) return fmt::format("{:.2g} s", seconds);
  if (seconds < 7200) return fmt::format("{:.3g} min", seconds / 60);
  return fmt::format("{:.3g} h", seconds / 3600);
}

std::string cost_of(const CellEstimate& cell) {
  if (!cell.is_known) return "time and memory not known";
  return fmt::format("about {} and {:.2g} MB per row, {} in all", about(cell.row_s),
                     cell.row_bytes / 1e6, about(cell.total_s));
}

std::string cost_of(const StudyEstimate& estimate, int workers) {
  if (estimate.unknown_rows == estimate.rows) return "its time and memory are not known";
  std::string text = fmt::format(
      "estimated from runs up to n = {}: {} on {} threads, {:.2g} MB for the largest row",
      estimate.calibration_n, about(estimate.wall_s), workers, estimate.largest_row_bytes / 1e6);
  if (estimate.unknown_rows > 0) {
    text += fmt::format("; of {} rows time and memory are not known", estimate.unknown_rows);
  }
  return text;
}

void print_estimate(const StudyPlan& plan, const StudyEstimate& estimate, int workers) {
  for (const CellEstimate& cell : estimate.cells) {
    fmt::print("{} {} n={} {} {}: {} instances, {} rows, {}\n", cell.family, cell.parameters,
               cell.n, cell.algorithm, cell.options, cell.instances, cell.rows, cost_of(cell));
  }
  fmt::print("{} cells, {} instances, {} rows", estimate.cells.size(), plan.instances.size(),
             estimate.rows);
  if (estimate.optional_rows > 0) fmt::print(" and at most {} more", estimate.optional_rows);
  fmt::print("\n{}\n", cost_of(estimate, workers));
  if (plan.budget.study_s && estimate.wall_s > *plan.budget.study_s) {
    fmt::print("the budget of {} will probably end it earlier\n", about(*plan.budget.study_s));
  }
}

}  // namespace

void refuse_impossible_study(const StudySpec& spec, const MakingPolicy& policy) {
  const StudyPlan plan = plan_study(spec);
  require_makeable(plan, policy);
  const std::vector<PlannedBlock>& blocks = plan.instances.blocks();
  const bool is_large = std::any_of(blocks.begin(), blocks.end(), [](const PlannedBlock& block) {
    return block.first.n >= kLargeSize;
  });
  if (!is_large && !plan.budget.limits_rows()) return;
  refuse_impossible(plan, estimate(plan, policy.workers), available_memory());
}

void add_study_plan(CLI::App& study, int&) {
  CLI::App* verb = study.add_subcommand(
      "plan", "Lists the cells of a study with estimated time and memory; refuses impossible ones");
  struct Arguments {
    StudyChoice chosen;
    int workers = 0;
  };
  const auto arguments = std::make_shared<Arguments>();
  add_study_choice(*verb, arguments->chosen);
  verb->add_option("--threads", arguments->workers,
                   "rows made at the same time; as many as cores if left out")
      ->check(whole_number(1, 1024));
  verb->footer(
      "Estimates are extrapolated from short runs at small sizes on this machine; expect them to "
      "be "
      "right within a factor of three.\nExit code 2 if a cell is impossible.\nExample: ar3d study "
      "plan quick");
  verb->callback([arguments] {
    const StudyPlan plan = plan_study(chosen_study(arguments->chosen));
    const int workers = workers_for(arguments->workers);
    const StudyEstimate made = estimate(plan, workers);
    print_estimate(plan, made, workers);
    refuse_impossible(plan, made, available_memory());
  });
}

}  // namespace ar3d
