// A study from its beginning to its results file; a stopped one goes on from its journal.
#include "ar3d/bench/keep/journaled_study.h"

#include <boost/scope_exit.hpp>
#include <filesystem>

#include "ar3d/base/parallel.h"
#include "ar3d/base/printable.h"
#include "ar3d/base/say.h"
#include "ar3d/bench/keep/gather_rows.h"
#include "ar3d/bench/keep/study_files.h"
#include "ar3d/bench/measure/environment.h"
#include "ar3d/bench/measure/processes.h"
#include "ar3d/bench/plan/corpora.h"
#include "ar3d/bench/run/batches.h"
#include "ar3d/bench/run/describe_study.h"
#include "ar3d/store/columns/run_columns.h"
#include "ar3d/store/hdf5/results_file.h"
#include "ar3d/store/journal/journal_format.h"
#include "ar3d/store/journal/journal_reader.h"
#include "ar3d/store/journal/journal_writer.h"
#include "ar3d/store/row_collection.h"
#include "ar3d/store/run_storage.h"

namespace ar3d {
namespace {
RowCollection rows_so_far(const JournaledStudy& study) {
  RowCollection rows;
  for (const std::string& journal : existing_journals(study.results)) rows.add(journal);
  if (rows_are_in_results(study.results)) rows.add(study.results);
  rows.close();
  return rows;
}

StudyPlan plan_of(const JournaledStudy& study) {
  return plan_of_shard(plan_study(study), study.shard);
}

StudyOutcome write_rows_so_far(const JournaledStudy& study, const StudyPlan& plan,
                               const std::string& path) {
  const RowCollection rows = rows_so_far(study);
  const GatheredRows gathered = gather_rows(plan, rows);
  write_gathered(rows.identity(), gathered, rows, path);
  return gathered.outcome();
}

bool has_grown(const Study& study) {
  return study.files.grow && std::ranges::any_of(corpora_of(study), [](const StudyCorpus& corpus) {
           return corpus.corpus->graphs->growth().has_new();
         });
}

// Before rows go, all are in the results file. @throws InputError if another process is at work.
void fold_journals(const JournaledStudy& study, const StudyIdentity& identity) {
  std::vector<std::unique_ptr<JournalWriter>> locked;
  for (const std::string& journal : existing_journals(study.results)) {
    locked.push_back(std::make_unique<JournalWriter>(journal, identity));
  }
  if (!rows_are_in_results(study.results)) {
    JournaledStudy begun = study;
    begun.files.grow = false;
    write_rows_so_far(begun, plan_of(begun), study.results);
  }
  remove_journals(study.results);
}

// Rows of another program would stand in one file with this one's, under its source.
void require_own_rows(const StudyIdentity& rows, const StudyIdentity& own,
                      const std::string& path) {
  if (rows.source() == own.source()) return;
  throw InputError(fmt::format(
      "{}: its rows were made by the program of source {}, this one is of source {}: go on with "
      "that program, or run the study anew",
      path, rows.source(), own.source()));
}

// Rows that are not of the plan, or of programs that have changed.
void refuse_other_rows(const JournaledStudy& study, const StudyPlan& plan,
                       const RowCollection& rows) {
  refuse_changed_programs(study.spec, rows.environment(), study.results);
  if (rows.size() > 0) gather_rows(plan, rows);
}

// A results file without journals becomes a journal, whole or not at all.
void seed_journal(const JournaledStudy& study, const StudyPlan& plan,
                  const StudyIdentity& identity) {
  if (study.has_journals && existing_journals(study.results).empty()) {
    throw InputError(fmt::format("{}: another process has finished the study", study.results));
  }
  const bool begins_anew = !study.again.empty() || has_grown(study);
  if (begins_anew) fold_journals(study, identity);
  if (!study.seed_from_results && !begins_anew) return;
  const std::string journal_of_study = journal_path(study.results);
  const std::string seed = name_of_new_file(journal_of_study);
  try {
    RowCollection rows;
    rows.add(study.results);
    rows.close();
    require_own_rows(rows.identity(), identity, study.results);
    refuse_other_rows(study, plan, rows);  // before there is a journal that says it is not finished
    JournalWriter journal(seed, identity);
    copy_rows(rows, study.again, journal);
    if (!study.again.empty()) {
      say(stderr, "ar3d: {} of {} rows are made again\n", rows.size() - journal.rows(),
          rows.size());
    }
  } catch (...) {  // no room for it, no thread, or refused
    std::error_code ignored;
    std::filesystem::remove(seed, ignored);
    throw;
  }
  // Not by replacing: another process may have made the same journal and be at work with it.
  give_name_if_free(seed, journal_of_study);
}

StudyIdentity identity_of(const JournaledStudy& study, const StudyPlan& plan) {
  auto identity = static_cast<StudyIdentity&&>(describe_study(study, 1));
  identity.created = study.created;
  identity.shard = study.shard;
  identity.planned_rows = required_rows(plan);
  return identity;
}

std::vector<EnvironmentEntry> session_of(const JournaledStudy& study, const SessionPolicy& policy,
                                         const Ranks& ranks) {
  const Results description = describe_study(study, policy.workers);
  std::vector<EnvironmentEntry> session = {{"started", description.created}};
  if (study.shard.count > 1) {
    session.push_back({"shard", fmt::format("{}/{}", study.shard.index, study.shard.count)});
  }
  if (ranks.size() > 1) {
    session.push_back({"rank", fmt::format("{} of {}", ranks.rank(), ranks.size())});
  }
  session.insert(session.end(), description.environment.begin(), description.environment.end());
  return session;
}

// Does a step on all ranks; an InputError of one is one of all. What else is thrown is the rank's
// own: its caller ends them all (Ranks::give_up).
void together(Ranks& ranks, const std::function<void()>& step) {
  if (ranks.size() == 1) {
    step();
    return ranks.barrier();
  }
  StepResult result = StepResult::done;
  std::string why;
  try {
    step();
  } catch (const JournalFull& error) {
    result = StepResult::journal_full;
    why = error.what();
  } catch (const InputError& error) {
    result = StepResult::failed;
    why = error.what();
  }
  result = ranks.agree(result, why);
  if (result != StepResult::done) throw FailedTogether(why, result == StepResult::journal_full);
}

// One process's part in a study: its journal and what was there before.
class StudyPart {
 public:
  StudyPart(const JournaledStudy& study, const SessionPolicy& policy, Ranks& ranks)
      : study_(study),
        policy_(policy),
        ranks_(ranks),
        plan_(plan_of(study)),
        folder_(open_folder(study.results)) {
    const StudyIdentity identity = identity_of(study, plan_);
    const std::string path = journal_path(study.results, ranks.rank());
    together(ranks, [&] {
      // Threads that there are not are missed before there is a journal.
      const bool in_processes = policy.isolate || plan_.budget.limits_rows();
      if (!in_processes) in_threads(static_cast<std::uint32_t>(policy.workers), [](auto) {});
      if (ranks.is_first()) seed_journal(study, plan_, identity);
      journal_.emplace(path, identity);
    });
    tell_of_cut_bytes(path);
    together(ranks, [&] {
      if (ranks.is_first()) remove_study_leftovers(study.results);
    });
  }

  void add_rows() {
    const Stopwatch time;
    // A rank that cannot read must not leave the others sharing rows without it.
    std::optional<RowCollection> before;
    together(ranks_, [&] {
      before.emplace(rows_so_far(study_));
      refuse_other_rows(study_, plan_, *before);
    });
    together(ranks_, [&] { journal_->begin_session(session_of(study_, policy_, ranks_)); });
    SessionPolicy shared = policy_;
    shared.name = study_.spec.name;
    shared.ranks = &ranks_;
    if (ranks_.size() > 1) {
      shared.timed_phases = false;
      shared.workers_elsewhere = (ranks_.size() - 1) * shared.workers;
    }
    make_shared(shared, *before);
    before.reset();
    if (!ranks_.is_first()) {
      ranks_.help(batch_parts(plan_, ranks_.rank(), is_interrupted));
    }
    together(ranks_, [&] {
      if (ranks_.size() == 1 || !ranks_.is_first()) return;
      shared.timed_phases = policy_.timed_phases;
      shared.next_instance = [] { return std::nullopt; };
      if (plan_.budget.study_s) *plan_.budget.study_s -= time.wall_s();  // what is left of it
      BOOST_SCOPE_EXIT_ALL(&) { ranks_.dismiss(); };
      study_.results = path_in_folder(folder_, study_.results);
      make(shared, rows_so_far(study_));
    });
    at_end_.push_back({"load_after", load_average()});
    together(ranks_, [&] { journal_->end_session(at_end_); });
  }

  StudyOutcome write_results() {
    study_.results = path_in_folder(folder_, study_.results);
    StudyOutcome outcome = write_rows_so_far(study_, plan_, study_.results);
    if (outcome.complete()) remove_journals(study_.results);
    outcome.results = study_.results;
    return outcome;
  }

 private:
  // With --quiet only the loss of a half-written row, which was never acknowledged, goes unsaid.
  void tell_of_cut_bytes(const std::string& path) const {
    if (!journal_->cut_file().empty()) {
      say(stderr, "ar3d: {} ended with {} bytes that are no row of it; they are kept in {}\n", path,
          journal_->bytes_cut(), journal_->cut_file());
    } else if (policy_.progress != nullptr && journal_->bytes_cut() > 0) {
      say(policy_.progress, "ar3d: {} ended with {} bytes of an unfinished row; they are cut off\n",
          path, journal_->bytes_cut());
    }
  }

  // The largest instances first, so that none is left to the end.
  void make_shared(const SessionPolicy& policy, const RowCollection& before) {
    const LargestFirst order(plan_);
    std::vector<double> work;
    for (std::size_t i = 0; ranks_.size() > 1 && i < order.size(); ++i) {
      work.push_back(work_of_instance(plan_.instances.block_of_place(order[i]).first));
    }
    ranks_.share_out(work, [&](const Tickets& tickets) {
      SessionPolicy mine = policy;
      if (tickets) {
        mine.next_instance = [&]() -> std::optional<std::size_t> {
          const std::optional<std::size_t> ticket = tickets();
          if (!ticket) return std::nullopt;
          return order[*ticket];
        };
      }
      make(mine, before);
    });
  }

  void make(const SessionPolicy& policy, const RowCollection& before) {
    RowSink sink{[&](std::size_t, const RunRecord& row) { journal_->append(row); },
                 [&](const EnvironmentEntry& entry) { at_end_.push_back(entry); }};
    if (before.size() > 0) {
      sink.has = [&](const std::string& key) {
        return before.find(parse_row_key(key)).has_value();
      };
      sink.read = [&](const std::string& key) {
        std::vector<char> record(run_record_size());
        before.read(before.find(parse_row_key(key)).value(), record.data());
        return load_record(record.data());
      };
    }
    run_session(plan_, policy, sink);
  }

  JournaledStudy study_;
  const SessionPolicy& policy_;
  Ranks& ranks_;
  StudyPlan plan_;
  Descriptor folder_;
  std::vector<EnvironmentEntry> at_end_;
  std::optional<JournalWriter> journal_;  // until the end, so that nobody else takes the study up
};

}  // namespace

JournaledStudy new_study(const Study& begun, const Shard& shard, const std::string& results) {
  JournaledStudy study{begun, shard, results, now_with_zone()};
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
  study.files.own = own_files_of(study.results);
  return study;
}

JournaledStudy begun_study(const std::string& journal_or_results) {
  const std::string results = in_resolved_folder(results_path_of(journal_or_results));
  const std::vector<std::string> journals = existing_journals(results);
  const bool in_results = rows_are_in_results(results);
  const StudyIdentity identity =
      in_results ? RunReader(results).identity() : journal_status(journals.front()).identity;
  Study study = recorded_study(identity, in_results ? results : journals.front());
  study.files.own = own_files_of(results);
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
  same.files.own = own_files_of(results);
  if (study) same.files.shelf = study->files.shelf;
  together(ranks, [&same] { corpora_of(same); });  // so that all ranks have read the same graphs
  return {std::move(same),
          identity.shard,
          results,
          identity.created,
          study && study->seed_from_results,
          study && study->has_journals};
}

StudyOutcome run_journaled(const JournaledStudy& study, const SessionPolicy& policy, Ranks& ranks) {
  StudyPart part(study, policy, ranks);
  part.add_rows();
  StudyOutcome outcome;
  together(ranks, [&] {
    try {
      if (ranks.is_first()) outcome = part.write_results();
    } catch (const InputError& error) {  // the rows are in the journals all the same
      throw JournalFull(error.what());
    }
  });
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
  return gather_rows(plan_of(study), rows_so_far(study)).outcome();
}

}  // namespace ar3d
