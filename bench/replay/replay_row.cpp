// Makes a recorded row again and compares everything that is no measurement. This shows that
// results can be reproduced from their file alone.
#include "ar3d/bench/replay/replay_row.h"

#include "ar3d/base/random.h"
#include "ar3d/bench/run/row_maker.h"
#include "ar3d/generators/catalog.h"

namespace ar3d {
namespace {

bool is_of_a_file(const std::string& family, const StudyOrigin& origin) {
  return origin.study && origin.study->begun_with &&
         std::ranges::count(*origin.study->begun_with, family, &GraphFileRecord::name) > 0;
}

const std::vector<FamilyChoice>& choices_of(const std::string& family, const StudyOrigin& origin) {
  const auto [known, is_new] = origin.choices->try_emplace(family);
  if (!is_new) return known->second;
  Study study = *origin.study;
  if (!origin.moved_graphs.empty()) study.stored_graphs = nullptr;
  for (GraphFileRecord& file : *study.begun_with) {
    if (!origin.moved_graphs.empty() && file.name == family) file.path = origin.moved_graphs;
  }
  for (const StudyCorpus& corpus : corpora_of(study, family)) {
    for (FamilyChoice& choice : corpus.choices()) known->second.push_back(std::move(choice));
  }
  return known->second;
}

FamilyChoice choice_of(const RunRecord& row, const StudyOrigin& origin) {
  if (!is_of_a_file(row.family, origin)) {
    const Family& family = find_family(row.family);
    return {&family, complete_parameters(family, parse_settings(row.parameters))};
  }
  for (const FamilyChoice& choice : choices_of(row.family, origin)) {
    if (settings_text(choice.parameters) == row.parameters) return choice;
  }
  throw InputError(fmt::format("the study has no graphs {} with '{}'", row.family, row.parameters));
}

/// Returns the mode that the row was to be judged by.
CertificateMode certificate_of(const RunRecord& row) {
  const std::string asked = asked_certificate(row);
  return asked == "measured" ? CertificateMode::exact : parse_certificate_mode(asked);
}

}  // namespace

PlannedInstance plan_of_row(const RunRecord& row, const StudyOrigin& origin) {
  PlannedInstance instance;
  instance.choice = choice_of(row, origin);
  instance.parameters = row.parameters;
  instance.requested_n = static_cast<std::uint64_t>(row.requested_n);
  instance.n = static_cast<std::uint64_t>(row.n);
  instance.index = static_cast<std::uint32_t>(row.instance_index);
  instance.seed = row.seed;
  PlannedRun run;
  static const StudySpec none;
  run.choice = algorithm_choice(origin.study ? origin.study->spec : none, row.algorithm,
                                parse_settings(row.options));
  if (!row.level.empty()) run.choice.level = parse_level(row.level);
  run.choice.certificate = certificate_of(row);
  run.options = row.options;
  run.repetition = static_cast<std::uint32_t>(row.repetition);
  run.row_key = row.row_key;
  run.phase = row.phase;
  run.workers = row.workers;
  instance.runs.push_back(std::move(run));
  return instance;
}

StudyOrigin study_origin(const StudyIdentity& identity) {
  try {
    return {recorded_study(identity, identity.study_id)};
  } catch (const InputError&) {
    return {};
  }
}

Drawing redrawn(const RunRecord& row, const StudyOrigin& origin) {
  const PlannedInstance instance = plan_of_row(row, origin);
  const Graph graph = graph_of(instance);
  const AlgorithmChoice& choice = instance.runs.front().choice;
  return draw(*choice.algorithm, graph, choice.options);
}

RunRecord replayed(const RunRecord& row, const StudyOrigin& origin) {
  PlannedInstance instance = plan_of_row(row, origin);
  if (origin.study) {
    instance.n =
        instance.choice.family->nearest_n(instance.requested_n, instance.choice.parameters);
    set_seed_and_keys(origin.study->spec.seed, instance);
  }
  RowMaker maker(MemoryScope::row);
  maker.prepare(instance);
  RunRecord now = maker.make_row(instance.runs.front());
  if (row.max_degree < 0) now.max_degree = row.max_degree;  // made before there was that column
  return now;
}

std::vector<std::size_t> sample_of_rows(const std::vector<RunRecord>& rows, std::size_t count,
                                        std::uint64_t seed) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (is_drawn(rows[i]) || rows[i].status == RunStatus::refused) indices.push_back(i);
  }
  count = std::min(count, indices.size());
  RandomStream random(seed);
  for (std::size_t i = 0; i < count; ++i) {  // a study has at most 10^7 rows
    std::swap(indices[i],
              indices[i + random.below(static_cast<std::uint32_t>(indices.size() - i))]);
  }
  indices.resize(count);
  std::sort(indices.begin(), indices.end());
  return indices;
}

}  // namespace ar3d
