// Puts rows from several files into the order of the plan. Parts of different studies, programs or
// divisions into shards are refused, since their rows would not mean the same.
#include <fmt/format.h>

#include <filesystem>

#include "ar3d/base/printable.h"
#include "ar3d/bench/keep/journaled_study.h"
#include "ar3d/bench/keep/study_files.h"
#include "ar3d/bench/run/row_maker.h"
#include "ar3d/bench/run/session.h"
#include "ar3d/store/columns/run_columns.h"
#include "ar3d/store/hdf5/results_file.h"

namespace ar3d {
namespace {

void refuse_unknown_row(const std::vector<std::uint32_t>& in_plan, const Rows& rows) {
  std::vector<bool> known(rows.size(), false);
  for (const std::uint32_t i : in_plan) known[i] = true;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!known[i]) {
      throw InputError(fmt::format(
          "{}: row {} is none of study {} as this program plans it (the rows are of source {})",
          rows.path(i), to_string(rows.key(i)), rows.identity().study_id,
          rows.identity().source()));
    }
  }
}

void require_one_division(const std::vector<Shard>& shards) {
  for (const Shard& shard : shards) {
    if (shard.count != shards.front().count) {
      throw InputError(fmt::format("shard {}/{} and shard {}/{} are of different divisions",
                                   shards.front().index, shards.front().count, shard.index,
                                   shard.count));
    }
  }
}

// Sessions tell the hash of every program of the study's own in an entry program_NAME.
void require_one_program_each(const std::vector<EnvironmentEntry>& environment) {
  constexpr std::string_view kEntry = "program_";
  std::map<std::string, std::string> hashes;
  for (const EnvironmentEntry& entry : environment) {
    if (!entry.name.starts_with(kEntry)) continue;
    const std::string& first = hashes.try_emplace(entry.name, entry.value).first->second;
    if (first == entry.value) continue;
    throw InputError(fmt::format(
        "the shards were made with different programs '{}' (hashes {} and {}): one of "
        "them has to be made again",
        printable(entry.name.substr(kEntry.size())), printable(first), printable(entry.value)));
  }
}

// "2, 5-8", or nothing. In time proportional to the shards that are there, however many there are
// to be.
std::string missing_shards(const std::vector<Shard>& shards) {
  std::string missing;
  const auto add = [&missing](std::uint64_t first, std::uint64_t last) {
    if (first > last) return;
    if (!missing.empty()) missing += ", ";
    missing += first == last ? fmt::format("{}", first) : fmt::format("{}-{}", first, last);
  };
  std::uint64_t next = 1;
  for (const Shard& shard : shards) {
    add(next, std::uint64_t{shard.index} - 1);
    next = std::uint64_t{shard.index} + 1;
  }
  add(next, shards.front().count);
  return missing;
}

}  // namespace

StudyOutcome outcome_of(const StudyPlan& plan, const Rows& rows,
                        std::vector<std::uint32_t>* in_order, std::vector<std::size_t>* instances) {
  StudyOutcome outcome;
  std::vector<std::uint32_t> indices;
  indices.reserve(rows.size());
  for (std::size_t number = 0; number < plan.instances.size(); ++number) {
    const PlannedInstance instance = plan.instances[number];
    for (const PlannedRun& run : instance.runs) {
      if (const auto i = rows.find(parse_row_key(run.row_key))) {
        indices.push_back(static_cast<std::uint32_t>(*i));
        if (instances != nullptr) instances->push_back(number);
      } else if (!run.optional && outcome.missing++ == 0) {
        outcome.first_missing = run.row_key;
        const std::string graph = planned_row(instance, run).graph_name;
        if (!graph.empty()) outcome.first_missing += " of graph " + printable(graph);
      }
    }
  }
  outcome.rows = indices.size();
  if (indices.size() < rows.size()) refuse_unknown_row(indices, rows);
  if (in_order != nullptr) *in_order = std::move(indices);
  return outcome;
}

Rows rows_so_far(const std::string& results) {
  std::vector<std::string> files = existing_journals(results);
  if (rows_are_in_results(results)) files.push_back(results);
  return Rows(files);
}

StudyOutcome write_rows_so_far(const JournaledStudy& study, const StudyPlan& plan,
                               const std::string& path) {
  Rows rows = rows_so_far(study.results);
  std::vector<std::uint32_t> indices;
  StudyOutcome outcome = outcome_of(plan, rows, &indices);
  rows.arrange(indices);
  rows.identity().planned_rows = static_cast<std::int64_t>(outcome.rows + outcome.missing);
  write_results(rows, path);
  rows.file = path;
  outcome.in_hand = std::move(rows);
  return outcome;
}

StudyOutcome write_snapshot(const JournaledStudy& study, const std::string& path) {
  using std::filesystem::weakly_canonical;
  std::vector<std::string> own = existing_journals(study.results);
  own.push_back(study.results);
  for (const std::string& file : own) {
    if (weakly_canonical(file) != weakly_canonical(path)) continue;
    throw InputError(fmt::format("{} is a file of the study itself, not for a snapshot", path));
  }
  return write_rows_so_far(study, plan_of(study), path);
}

StudyOutcome outcome_so_far(const JournaledStudy& study) {
  return outcome_of(plan_of(study), rows_so_far(study.results));
}

void copy_rows(const Rows& rows, const std::vector<RunStatus>& but, JournalWriter& journal) {
  std::vector<EnvironmentEntry> session;
  for (const EnvironmentEntry& entry : rows.environment()) {
    if (entry.session != (session.empty() ? 0 : session.back().session)) {
      journal.begin_session(session);
      session.clear();
    }
    session.push_back(entry);
  }
  journal.begin_session(session);
  rows.visit([&](const char* record) {
    try {
      const RunStatus status = load_record(record).status;
      if (std::ranges::count(but, status) == 0) journal.append_record(record);
    } catch (const JournalFull&) {
      throw;
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", rows.path(0), error.what()));
    }
  });
  journal.sync();
}

StudyOutcome merge_study(const std::vector<std::string>& parts, const std::string& output) {
  require_writable(output);
  Rows rows(parts);
  require_one_division(rows.shards());
  require_one_program_each(rows.environment());
  const Study study = recorded_study(rows.identity(), parts.front());
  const StudyPlan plan = plan_study(study);
  std::vector<std::uint32_t> indices;
  std::vector<std::size_t> instances;
  StudyOutcome outcome = outcome_of(plan, rows, &indices, &instances);
  outcome.missing_shards = missing_shards(rows.shards());
  if (!outcome.complete()) return outcome;
  rows.arrange(indices);
  StudyIdentity& identity = rows.identity();
  identity.shard = {};
  identity.planned_rows = static_cast<std::int64_t>(outcome.rows);
  if (!rows.files_differ()) {
    write_results(rows, output);
    return outcome;
  }
  identity.tables = side_tables_of(study);
  // Each shard has numbered its own files.
  const auto renumbered = [&](std::size_t row, char* record) {
    RunRecord run = rows.run(row);
    const PlannedInstance instance = plan.instances[instances[row]];
    const RunRecord planned = planned_row(instance, instance.runs.front());
    run.instance_index = planned.instance_index;
    run.graph_name = planned.graph_name;
    run.group = planned.group;
    store_record(run, record);
  };
  write_results(identity, rows.environment(), rows.size(), renumbered, output);
  return outcome;
}

}  // namespace ar3d
