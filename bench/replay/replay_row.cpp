// Makes a recorded row again and compares everything that is no measurement. This shows that
// results can be reproduced from their file alone. Drawings are not stored while a study runs: the
// wanted ones are drawn again afterwards, and kept only if their hash is the one of their row.
#include "ar3d/bench/replay/replay_row.h"

#include <exception>
#include <set>
#include <tuple>

#include "ar3d/base/random.h"
#include "ar3d/bench/plan/plan.h"
#include "ar3d/bench/run/row_maker.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/store/columns/run_columns.h"

namespace ar3d {
namespace {

bool is_of_a_file(const std::string& family, const StudyOrigin& origin) {
  if (!origin.study || !origin.study->begun_with) return false;
  const std::vector<GraphFileRecord>& files = *origin.study->begun_with;
  return std::any_of(files.begin(), files.end(),
                     [&](const GraphFileRecord& file) { return file.name == family; });
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

FamilyChoice choice_from_file(const RunRecord& row, const StudyOrigin& origin) {
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

FamilyChoice choice_of(const RunRecord& row, const StudyOrigin& origin) {
  if (is_of_a_file(row.family, origin)) return choice_from_file(row, origin);
  const Family& family = find_family(row.family);
  return {&family, complete_parameters(family, parse_settings(row.parameters))};
}

/// Holds how bad a drawing is; what stands first decides.
using Badness = std::array<double, 3>;

Badness badness_of(const RunRecord& run) {
  const auto known = [](double value) { return std::isnan(value) ? -1 : value; };
  double share = -1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double of_axis = static_cast<double>(run.extents[axis]) / run.theorem_bound[axis];
    if (run.extents[axis] >= 0) share = std::max(share, known(of_axis));
  }
  static const Column miss = run_column("angle_miss");
  return {share, known(column_number(miss, run)), known(run.log2_volume)};
}

auto drawing_of(const RunRecord& run) {
  return std::tuple(run.graph_hash, run.algorithm, run.options);
}

std::vector<std::size_t> worst_rows(const Rows& rows) {
  std::map<std::array<std::string, 4>, std::pair<Badness, std::size_t>> worst;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const RunRecord& run = rows.run(row);
    if (run.phase != RunPhase::metrics || !is_drawn(run)) continue;
    const Badness badness = badness_of(run);
    const auto [at, is_new] =
        worst.try_emplace({run.algorithm, run.options, run.family, run.parameters}, badness, row);
    if (!is_new && badness > at->second.first) at->second = {badness, row};
  }
  std::vector<std::size_t> chosen;
  for (const auto& [curve, found] : worst) chosen.push_back(found.second);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

std::vector<std::size_t> rows_to_keep(const Rows& rows, KeptDrawings kept, std::size_t& repeated) {
  if (kept == KeptDrawings::none) return {};
  if (kept == KeptDrawings::worst) return worst_rows(rows);
  std::vector<std::size_t> chosen;
  std::set<decltype(drawing_of(RunRecord()))> known;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const RunRecord& run = rows.run(row);
    const bool is_wanted =
        kept == KeptDrawings::all ? is_drawn(run) : run.status == RunStatus::violated;
    if (run.phase != RunPhase::metrics || !is_wanted) continue;
    const bool is_new = known.insert(drawing_of(run)).second;
    if (is_new) chosen.push_back(row);
    repeated += !is_new;
  }
  return chosen;
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
    Study study = recorded_study(identity, identity.study_id);
    const std::uint64_t seed = study.spec.seed;
    return {.seed = seed, .study = std::move(study)};
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
  if (origin.seed) {
    instance.n =
        instance.choice.family->nearest_n(instance.requested_n, instance.choice.parameters);
    set_seed_and_keys(*origin.seed, instance);
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

std::optional<Drawing> drawn_again(const RunRecord& run, const StudyOrigin& origin,
                                   std::string& problem) {
  try {
    Drawing drawing = redrawn(run, origin);
    if (drawing_hash(drawing) == run.drawing_hash) return drawing;
    problem = "drawn again it is another drawing, which is not kept";
  } catch (const std::exception& error) {
    problem = fmt::format("not drawn again: {}", error.what());
  }
  return std::nullopt;
}

std::tuple<std::size_t, std::size_t, std::vector<std::string>> write_kept_drawings(
    const Rows& rows, KeptDrawings kept, OutputFile& file) {
  std::size_t written = 0, repeated = 0;
  std::vector<std::string> problems;
  const StudyOrigin origin = study_origin(rows.identity());
  if (origin.study && origin.study->begun_with) corpora_of(*origin.study);
  for (const std::size_t row : rows_to_keep(rows, kept, repeated)) {
    std::string problem;
    if (const auto drawing = drawn_again(rows.run(row), origin, problem)) {
      write_drawing_line(file, *drawing);
      ++written;
    } else {
      problems.push_back(fmt::format("row {}: {}", row, problem));
    }
  }
  return {written, repeated, std::move(problems)};
}

}  // namespace ar3d
