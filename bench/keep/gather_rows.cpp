#include "ar3d/bench/keep/gather_rows.h"

#include <fmt/format.h>

#include "ar3d/base/error.h"
#include "ar3d/store/run_storage.h"

namespace ar3d {
namespace {

void refuse_unknown_row(const GatheredRows& gathered, const RowCollection& rows) {
  std::vector<bool> known(rows.size(), false);
  for (const std::uint32_t place : gathered.places) known[place] = true;
  for (std::size_t place = 0; place < rows.size(); ++place) {
    if (!known[place]) {
      throw InputError(fmt::format(
          "row {} is none of study {} as this program plans it (the rows are of source {})",
          to_string(rows.key(place)), rows.identity().study_id, rows.identity().source()));
    }
  }
}

}  // namespace

StudyPlan plan_of_shard(StudyPlan plan, const Shard& shard) {
  if (shard.count == 1) return plan;
  plan.instances = plan.instances.every_nth(shard.index - 1, shard.count);
  return plan;
}

std::int64_t required_rows(const StudyPlan& plan) {
  std::int64_t rows = 0;
  for (const PlannedBlock& block : plan.instances.blocks()) {
    rows += static_cast<std::int64_t>(block.count * required_runs(block.first));
  }
  return rows;
}

GatheredRows gather_rows(const StudyPlan& plan, const RowCollection& rows) {
  GatheredRows gathered;
  gathered.places.reserve(rows.size());
  for (const PlannedInstance& instance : plan.instances) {
    for (const PlannedRun& run : instance.runs) {
      if (const auto place = rows.find(parse_row_key(run.row_key))) {
        gathered.places.push_back(static_cast<std::uint32_t>(*place));
      } else if (!run.optional && gathered.missing++ == 0) {
        gathered.first_missing = run.row_key;
      }
    }
  }
  if (gathered.places.size() < rows.size()) refuse_unknown_row(gathered, rows);
  return gathered;
}

void write_gathered(const StudyIdentity& identity, const GatheredRows& gathered,
                    const RowCollection& rows, const std::string& path) {
  const auto read = [&](std::size_t i, char* record) { rows.read(gathered.places[i], record); };
  StudyIdentity described = identity;
  described.planned_rows = static_cast<std::int64_t>(gathered.places.size() + gathered.missing);
  write_results(described, rows.environment(), run_format(), {gathered.places.size(), read}, path);
}

}  // namespace ar3d
