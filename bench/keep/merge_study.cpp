#include "ar3d/bench/keep/merge_study.h"

#include <fmt/format.h>

#include "ar3d/bench/keep/gather_rows.h"
#include "ar3d/model/error.h"
#include "ar3d/results/atomic_file.h"
#include "ar3d/results/row_collection.h"

namespace ar3d {
namespace {

void require_one_division(const std::vector<Shard>& shards) {
  for (const Shard& shard : shards) {
    if (shard.count != shards.front().count) {
      throw InputError(fmt::format("shard {}/{} and shard {}/{} are of different divisions",
                                   shards.front().index, shards.front().count, shard.index,
                                   shard.count));
    }
  }
}

// "shard 2/8 is missing", or nothing.
std::string missing_shards(const std::vector<Shard>& shards) {
  std::string missing;
  std::size_t next = 0;
  for (std::uint32_t index = 1; index <= shards.front().count; ++index) {
    if (next < shards.size() && shards[next].index == index) {
      ++next;
    } else {
      missing += fmt::format("{}{}", missing.empty() ? "" : ", ", index);
    }
  }
  return missing;
}

}  // namespace

StudyOutcome merge_study(const std::vector<std::string>& parts, const std::string& output) {
  require_writable(output);
  RowCollection rows;
  for (const std::string& part : parts) rows.add(part);
  rows.close();
  require_one_division(rows.shards());
  const StudyPlan plan = plan_study(parse_study(rows.identity().spec, parts.front()));
  const GatheredRows gathered = gather_rows(plan, rows);
  StudyOutcome outcome{gathered.places.size(), gathered.missing, gathered.first_missing,
                       missing_shards(rows.shards())};
  if (!outcome.complete()) return outcome;
  StudyIdentity identity = rows.identity();
  identity.shard = {};
  write_gathered(identity, gathered, rows, output);
  return outcome;
}

}  // namespace ar3d
