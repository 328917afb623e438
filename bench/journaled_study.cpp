#include "ar3d/bench/journaled_study.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "ar3d/bench/environment.h"
#include "ar3d/bench/gather_rows.h"
#include "ar3d/bench/plan.h"
#include "ar3d/bench/study_files.h"
#include "ar3d/model/error.h"
#include "ar3d/results/atomic_file.h"
#include "ar3d/results/columns.h"
#include "ar3d/results/journal_reader.h"
#include "ar3d/results/journal_writer.h"
#include "ar3d/results/results_reader.h"
#include "ar3d/results/row_collection.h"

namespace ar3d {
namespace {

namespace fs = std::filesystem;

RowCollection journaled_rows(const JournaledStudy& study) {
  RowCollection rows;
  for (const std::string& file : existing_journals(study.results)) rows.add(file);
  rows.close();
  return rows;
}

// An unfinished results file without journals becomes a journal, whole or not at all.
void seed_journal(const JournaledStudy& study, const StudyIdentity& identity) {
  if (!study.seed_from_results) return;
  const std::string seed = study.results + ".seed";
  fs::remove(seed);
  {
    RowCollection rows;
    rows.add(study.results);
    rows.close();
    JournalWriter journal(seed, identity);
    std::vector<EnvironmentEntry> session;
    for (const EnvironmentEntry& entry : rows.environment()) {
      if (entry.session != (session.empty() ? 0 : session.back().session)) {
        journal.begin_session(session);
        session.clear();
      }
      session.push_back(entry);
    }
    journal.begin_session(session);
    std::vector<char> record(run_record_size());
    for (std::size_t place = 0; place < rows.size(); ++place) {
      rows.read(place, record.data());
      journal.append_record(record.data());
    }
    journal.sync();
  }
  fs::rename(seed, journal_path(study.results));
}

StudyPlan plan_of(const JournaledStudy& study) {
  return plan_of_shard(plan_study(study.spec), study.shard);
}

StudyIdentity identity_of(const JournaledStudy& study, const StudyPlan& plan) {
  StudyIdentity identity = describe_study(study.spec, 1);
  identity.created = study.created;
  identity.shard = study.shard;
  identity.planned_rows = required_rows(plan);
  return identity;
}

std::vector<EnvironmentEntry> session_of(const JournaledStudy& study, const Results& description) {
  std::vector<EnvironmentEntry> session = {{"started", description.created}};
  if (study.shard.count > 1) {
    session.push_back({"shard", fmt::format("{}/{}", study.shard.index, study.shard.count)});
  }
  session.insert(session.end(), description.environment.begin(), description.environment.end());
  return session;
}

FinishedRuns finished_runs(const RowCollection& rows) {
  FinishedRuns finished;
  std::vector<char> record(run_record_size());
  for (std::size_t place = 0; place < rows.size(); ++place) {
    rows.read(place, record.data());
    finished.emplace(to_string(rows.key(place)), load_record(record.data()));
  }
  return finished;
}

StudyOutcome write_rows_so_far(const JournaledStudy& study, const StudyPlan& plan,
                               const std::string& path) {
  const RowCollection rows = journaled_rows(study);
  const GatheredRows gathered = gather_rows(plan, rows);
  StudyIdentity identity = rows.identity();
  identity.planned_rows = required_rows(plan);
  write_gathered(identity, gathered, rows, path);
  return {gathered.places.size(), gathered.missing, gathered.first_missing, {}};
}

}  // namespace

JournaledStudy new_study(const std::string& name_or_path, const Shard& shard,
                         const std::string& results) {
  JournaledStudy study{load_study(name_or_path), shard, results, now_with_zone(), false};
  if (study.results.empty()) study.results = path_of_shard(default_results_path(study.spec), shard);
  if (const auto journals = existing_journals(study.results); !journals.empty()) {
    throw InputError(fmt::format(
        "{} is the journal of a study that is not finished: go on with `ar3d study resume {}`, or "
        "delete it",
        journals.front(), study.results));
  }
  require_writable(study.results);
  return study;
}

JournaledStudy begun_study(const std::string& journal_or_results) {
  const std::string results = results_path_of(journal_or_results);
  const std::vector<std::string> journals = existing_journals(results);
  const bool no_journal = journals.empty();
  const StudyIdentity identity =
      no_journal ? ResultsReader(results).identity() : journal_status(journals.front()).identity;
  return {parse_study(identity.spec, no_journal ? results : journals.front()), identity.shard,
          results, identity.created, no_journal};
}

StudyOutcome run_journaled(const JournaledStudy& study, const StudyOptions& options) {
  const StudyPlan plan = plan_of(study);
  const StudyIdentity identity = identity_of(study, plan);
  seed_journal(study, identity);
  {
    std::optional<RowCollection> before;  // lives longer: closing its files gives up the lock
    JournalWriter journal(journal_path(study.results), identity);
    if (options.progress != nullptr && journal.bytes_cut() > 0) {
      fmt::print(options.progress,
                 "ar3d: {} ended with {} bytes of an unfinished row; they are cut off\n",
                 journal_path(study.results), journal.bytes_cut());
    }
    remove_leftovers(study.results);
    before.emplace(journaled_rows(study));
    const FinishedRuns finished = finished_runs(*before);
    journal.begin_session(session_of(study, describe_study(study.spec, options.threads)));
    run_plan(
        plan, options, finished, [&](const Run& run) { journal.append(run); }, study.spec.name);
    journal.end_session({{"load_after", load_average()}});
  }
  try {
    const StudyOutcome outcome = write_rows_so_far(study, plan, study.results);
    if (outcome.complete()) remove_journals(study.results);
    return outcome;
  } catch (const InputError& error) {  // the rows are in the journal all the same
    throw JournalFull(error.what());
  }
}

StudyOutcome write_snapshot(const JournaledStudy& study, const std::string& path) {
  return write_rows_so_far(study, plan_of(study), path);
}

}  // namespace ar3d
