#include "ar3d/bench/replay/replay_row.h"

#include <algorithm>

#include "ar3d/bench/run/make_row.h"
#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/model/error.h"
#include "ar3d/model/settings.h"

namespace ar3d {
PlannedInstance plan_of_row(const RunRecord& row) {
  const Algorithm& algorithm = find_algorithm(row.algorithm);
  PlannedInstance instance;
  instance.choice.family = &find_family(row.family);
  instance.choice.parameters =
      complete_parameters(*instance.choice.family, parse_settings(row.parameters));
  instance.parameters = row.parameters;
  instance.wanted_n = static_cast<std::uint64_t>(row.requested_n);
  instance.n = static_cast<std::uint64_t>(row.n);
  instance.index = static_cast<std::uint32_t>(row.instance_index);
  instance.seed = row.seed;
  PlannedRun run;
  run.choice = {&algorithm, complete_options(algorithm, parse_settings(row.options))};
  run.options = row.options;
  run.repetition = static_cast<std::uint32_t>(row.repetition);
  run.row_key = row.row_key;
  run.phase = row.phase;
  run.scale = row.scale;
  instance.runs.push_back(std::move(run));
  return instance;
}

std::optional<std::uint64_t> study_seed(const StudyIdentity& identity) {
  try {
    return parse_study(identity.spec, identity.study_id).seed;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

RunRecord replayed(const RunRecord& row, const std::optional<std::uint64_t>& study_seed) {
  PlannedInstance instance = plan_of_row(row);
  if (study_seed) {
    PlannedBlock block;
    block.first = instance;
    block.first.n =
        instance.choice.family->nearest_n(instance.wanted_n, instance.choice.parameters);
    PlannedInstances study(*study_seed);
    study.append(std::move(block));
    instance = study[0];
  }
  RowMaker maker({.concurrency = 1, .core = -1, .memory = MemoryScope::row});
  maker.prepare(instance);
  return maker.make(instance.runs.front());
}

}  // namespace ar3d
