// The log that the rows of a study go into. It is locked before anything of the study is looked at;
// a results file without journals becomes one, whole or not at all.
#include <filesystem>

#include "ar3d/base/parallel.h"
#include "ar3d/base/print.h"
#include "ar3d/bench/corpus/corpus.h"
#include "ar3d/bench/keep/journaled_study.h"
#include "ar3d/bench/measure/environment.h"
#include "ar3d/bench/plan/plan.h"
#include "ar3d/bench/run/session.h"

namespace ar3d {
namespace {

bool has_grown(const Study& study) {
  return study.rescan && std::ranges::any_of(corpora_of(study), [](const StudyCorpus& corpus) {
           const auto& [added, changed, gone] = corpus.corpus->growth();
           return !added.empty() || !changed.empty();
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
    begun.rescan = false;
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
void refuse_other_rows(const JournaledStudy& study, const StudyPlan& plan, const Rows& rows) {
  refuse_changed_programs(study.spec, rows.environment(), study.results);
  if (rows.size() > 0) outcome_of(plan, rows);
}

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
    const Rows rows(std::vector<std::string>{study.results});
    require_own_rows(rows.identity(), identity, study.results);
    refuse_other_rows(study, plan, rows);  // before there is a journal that says it is not finished
    JournalWriter journal(seed, identity);
    copy_rows(rows, study.again, journal);
    if (!study.again.empty()) {
      print(stderr, "ar3d: {} of {} rows are made again\n", rows.size() - journal.rows(),
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

// With --quiet only the loss of a half-written row, which was never acknowledged, goes unsaid.
void tell_of_cut_bytes(const JournalWriter& journal, const std::string& path, std::FILE* progress) {
  if (!journal.cut_file().empty()) {
    print(stderr, "ar3d: {} ended with {} bytes that are no row of it; they are kept in {}\n", path,
          journal.bytes_cut(), journal.cut_file());
  } else if (progress != nullptr && journal.bytes_cut() > 0) {
    print(progress, "ar3d: {} ended with {} bytes of an unfinished row; they are cut off\n", path,
          journal.bytes_cut());
  }
}

}  // namespace

StudyLog::StudyLog(const JournaledStudy& study, const StudyPlan& plan, const SessionPolicy& policy,
                   Ranks& ranks)
    : study_(study), plan_(plan), folder_(open_folder(study.results)) {
  const StudyIdentity identity = identity_of(study, plan);
  const std::string path = journal_path(study.results, ranks.rank());
  together(ranks, [&] {
    // Threads that there are not are missed before there is a journal.
    const bool in_processes = policy.isolate || plan.budget.limits_rows();
    if (!in_processes) in_threads(static_cast<std::uint32_t>(policy.workers), [](auto) {});
    if (ranks.is_first()) seed_journal(study, plan, identity);
    journal_.emplace(path, identity);
  });
  tell_of_cut_bytes(*journal_, path, policy.progress);
  together(ranks, [&] {
    if (ranks.is_first()) remove_study_leftovers(study.results);
    session_ = session_of(study, policy, ranks);
  });
}

Rows StudyLog::rows() const {
  Rows there = rows_so_far(results());
  refuse_other_rows(study_, plan_, there);
  return there;
}

RowSink StudyLog::sink(const Rows& there) {
  return {[&](std::size_t, const RunRecord& row) { journal_->append(row); },
          [&](const EnvironmentEntry& entry) { at_end_.push_back(entry); },
          there.size() == 0 ? nullptr : &there};
}

void StudyLog::end_session() {
  at_end_.push_back({"load_after", load_average()});
  journal_->end_session(at_end_);
}

}  // namespace ar3d
