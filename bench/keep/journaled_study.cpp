// A study from its beginning to its results file; a stopped one goes on from its journal.
#include "ar3d/bench/keep/journaled_study.h"

#include <fmt/format.h>

#include <boost/scope_exit.hpp>

#include "ar3d/base/printable.h"
#include "ar3d/bench/measure/processes.h"
#include "ar3d/store/journal/journal_reader.h"

namespace ar3d {

StudyPlan plan_of(const JournaledStudy& study) {
  StudyPlan plan = plan_study(study);
  const auto [index, count] = study.shard;
  if (count > 1) plan.instances = plan.instances.part_of(index - 1, count);
  return plan;
}

StudyIdentity identity_of(const JournaledStudy& study, const StudyPlan& plan) {
  auto identity = static_cast<StudyIdentity&&>(describe_study(study, 1));
  identity.created = study.created;
  identity.shard = study.shard;
  identity.planned_rows = 0;
  for (const PlannedBlock& block : plan.instances.blocks()) {
    identity.planned_rows += static_cast<std::int64_t>(block.count * required_runs(block.first));
  }
  return identity;
}

JournaledStudy new_study(const Study& begun, const Shard& shard, const std::string& results) {
  JournaledStudy study{begun, shard, results, time_with_zone()};
  if (study.results.empty()) study.results = path_of_shard(default_results_path(study.spec), shard);
  require_results_name(study.results);
  study.results = in_resolved_folder(study.results);
  if (const auto journals = existing_journals(study.results); !journals.empty()) {
    throw InputError(fmt::format(
        "{} is the journal of a study that is not finished: go on with `ar3d study resume {}`, or "
        "delete it",
        journals.front(), shell_word(study.results)));
  }
  require_writable(study.results);
  study.own_files = own_files_of(study.results);
  return study;
}

JournaledStudy begun_study(const std::string& journal_or_results) {
  const std::string results = in_resolved_folder(results_path_of(journal_or_results));
  const std::vector<std::string> journals = existing_journals(results);
  const bool in_results = rows_are_in_results(results);
  const StudyIdentity identity =
      in_results ? Rows(results).identity() : journal_status(journals.front()).identity;
  Study study = recorded_study(identity, in_results ? results : journals.front());
  study.own_files = own_files_of(results);
  return {std::move(study), identity.shard, results, identity.created, in_results, !in_results};
}

JournaledStudy begin_together(Ranks& ranks, const std::function<JournaledStudy()>& begin) {
  std::optional<JournaledStudy> study;
  together(ranks, [&] {
    if (ranks.is_first()) study = begin();
  });
  if (ranks.size() == 1) return *study;
  const std::string results = ranks.from_first(study ? study->results : "");
  StudyIdentity identity = study ? identity_of(*study, StudyPlan()) : StudyIdentity();
  identity = parse_identity(ranks.from_first(identity_text(identity)), results);
  Study same = recorded_study(identity, results);
  same.own_files = own_files_of(results);
  if (study) same.open_files = study->open_files;
  together(ranks, [&same] { corpora_of(same); });  // so that all ranks have read the same graphs
  return {std::move(same),
          identity.shard,
          results,
          identity.created,
          study && study->seed_from_results,
          study && study->has_journals};
}

namespace {

// Rank i of N makes every N-th instance in the metrics phase. Then rank 0 alone makes
// those that are timed; the others draw their parts of its batches.
void make_on_ranks(StudyPlan& plan, SessionPolicy policy, Ranks& ranks, StudyLog& log,
                   std::optional<Rows>& there) {
  const Stopwatch time;
  const bool timed_phases = std::exchange(policy.timed_phases, false);
  policy.workers_elsewhere = (ranks.size() - 1) * policy.workers;
  StudyPlan share = plan;
  share.instances = plan.instances.every_nth(static_cast<std::size_t>(ranks.rank()),
                                             static_cast<std::size_t>(ranks.size()));
  run_session(share, policy, log.sink(*there));
  there.reset();
  ranks.barrier();
  if (!ranks.is_first()) ranks.serve(batch_parts(plan, ranks.rank(), is_interrupted));
  together(ranks, [&] {
    if (!ranks.is_first()) return;
    BOOST_SCOPE_EXIT_ALL(&) { ranks.stop_serving(); };
    policy.metrics_phase = false;
    policy.timed_phases = timed_phases;
    if (plan.budget.study_s) *plan.budget.study_s -= time.seconds();  // what is left of it
    there.emplace(log.rows());
    run_session(plan, policy, log.sink(*there));
  });
}

}  // namespace

StudyOutcome run_journaled(JournaledStudy study, SessionPolicy policy, Ranks& ranks) {
  StudyPlan plan = plan_of(study);
  StudyLog log(study, plan, policy, ranks);
  std::optional<Rows> there;  // the others are missing
  // A rank that cannot read must not leave the others making rows without it.
  together(ranks, [&] { there.emplace(log.rows()); });
  together(ranks, [&] { log.begin_session(); });
  policy.name = study.spec.name;
  policy.ranks = &ranks;
  if (ranks.size() == 1) {
    run_session(plan, policy, log.sink(*there));
  } else {
    make_on_ranks(plan, policy, ranks, log, there);
  }
  there.reset();
  together(ranks, [&] { log.end_session(); });
  StudyOutcome outcome;
  together(ranks, [&] {
    if (!ranks.is_first()) return;
    study.results = log.results();
    try {
      outcome = write_rows_so_far(study, plan, study.results);
      if (outcome.complete()) remove_journals(study.results);
      outcome.results = study.results;
    } catch (const InputError& error) {  // the rows are in the journals all the same
      throw JournalFull(error.what());
    }
  });
  return outcome;
}

}  // namespace ar3d
