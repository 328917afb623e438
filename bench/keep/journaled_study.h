#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/bench/keep/study_files.h"
#include "ar3d/bench/run/session.h"
#include "ar3d/store/journal/journal_writer.h"
#include "ar3d/store/rows.h"

namespace ar3d {

/// Describes a study whose rows go into a journal beside its results file.
struct JournaledStudy : Study {
  Shard shard;
  std::string results;             ///< path of the results file
  std::string created;             ///< when it began, ISO 8601 with zone
  bool seed_from_results = false;  ///< its rows so far are in the results file and nowhere else
  bool has_journals = false;       ///< its rows so far are in journals
  /// Rows with such a status are made again: what is there of them is forgotten once the rows so
  /// far are in the results file, which keeps them until the study ends anew.
  std::vector<RunStatus> again = {};
};

/// Holds how it stands with a journaled study.
struct StudyOutcome {
  std::size_t rows = 0;              ///< in the results file
  std::size_t missing = 0;           ///< rows that it is not complete without
  std::string first_missing;         ///< key of one
  std::string missing_shards;        ///< "2, 5-8"; of a merged study
  std::string results = {};          ///< path of the results file, whose folder may have been moved
  std::optional<Rows> in_hand = {};  ///< the rows, in its order; of run_journaled
  bool complete() const { return missing == 0; }
};

/// Returns a study that begins. @throws InputError if there are journals of it already or the
/// results file cannot be written.
JournaledStudy new_study(const Study& begun, const Shard& shard, const std::string& results);

/// Returns a study that has begun, from its journal or its unfinished results file.
/// @throws InputError naming the file if it cannot be read or does not say what study it is.
JournaledStudy begun_study(const std::string& journal_or_results);

/// Returns the plan of its shard (PlannedInstances::part_of): rows keep their keys and their order,
/// not their numbers. @throws InputError as plan_study.
StudyPlan plan_of(const JournaledStudy& study);
/// Returns what its files say of it. @throws InputError as describe_study.
StudyIdentity identity_of(const JournaledStudy& study, const StudyPlan& plan);

/// Returns the study that rank 0 begins, on every rank. @throws InputError that `begin` throws, on all
/// of them.
JournaledStudy begin_together(Ranks& ranks, const std::function<JournaledStudy()>& begin);

/// Plans the rows, makes those that are missing, appends each to the log, and exports all as the
/// results file. Rows that are in the journals, or in a results file made from them, stay as they
/// are. Afterwards, whether complete or stopped, the results file holds all rows so far; the
/// journals are removed when it is complete. Several ranks share the metrics phase and write a
/// journal each; rank 0 does the timed phases alone and makes the results file.
/// @return of rank 0; other ranks know nothing of it.
/// @throws JournalFull (results.journal is whole), InputError as JournalWriter, plan_study; of
/// several ranks on all (Ranks::have_failed), or on one, which has to end the others.
StudyOutcome run_journaled(JournaledStudy study, SessionPolicy policy, Ranks& ranks);

/// Represents the log of a study that one process appends to: its journal, locked while this lives.
class StudyLog {
 public:
  /// Opens the journal, on all ranks. What the results file alone holds goes into the journal of
  /// rank 0 first.
  /// Study and plan outlive it. @throws InputError as JournalWriter; naming a row
  /// that the plan does not have or a program that has changed.
  StudyLog(const JournaledStudy& study, const StudyPlan& plan, const SessionPolicy& policy,
           Ranks& ranks);

  /// Returns the study's results file, whose folder may have been moved since.
  std::string results() const { return path_in_folder(folder_, study_.results); }
  /// Returns the rows that are there. @throws InputError as the constructor.
  Rows rows() const;

  void begin_session() { journal_->begin_session(session_); }
  /// Returns where new rows go; both outlive it. @param there  rows that are not to be made.
  RowSink sink(const Rows& there);
  /// Writes what is known only at the end.
  void end_session();

 private:
  const JournaledStudy& study_;
  const StudyPlan& plan_;
  const Descriptor folder_;
  std::vector<EnvironmentEntry> session_, at_end_;
  std::optional<JournalWriter> journal_;  // until the end, so that no other run takes the study up
};

/// Returns the rows of a study that are there, in its journals and its results file.
Rows rows_so_far(const std::string& results);

/// Returns how rows of files stand to a plan. @param in_order  takes where its rows stand among them,
/// in its order. @param instances  takes of which they are. @throws InputError naming a row that the
/// plan does not have.
StudyOutcome outcome_of(const StudyPlan& plan, const Rows& rows,
                        std::vector<std::uint32_t>* in_order = nullptr,
                        std::vector<std::size_t>* instances = nullptr);

/// Writes the rows so far of a study with that plan as a results file, in the plan's order.
/// @throws InputError as rows_so_far, outcome_of, write_results.
StudyOutcome write_rows_so_far(const JournaledStudy& study, const StudyPlan& plan,
                               const std::string& path);

/// Writes the rows so far as a results file, also while they are being made.
/// @throws InputError naming the file; if it is the study's results file or a journal of it.
StudyOutcome write_snapshot(const JournaledStudy& study, const std::string& path);

/// Returns how it stands with a study that has begun, also while its rows are being made; reads all
/// of them. @throws InputError as begun_study.
StudyOutcome outcome_so_far(const JournaledStudy& study);

/// Copies rows of one file but those with these statuses into a new journal, session by session.
/// @throws InputError naming the file if a row cannot be read (it would make the journal useless),
/// JournalFull.
void copy_rows(const Rows& rows, const std::vector<RunStatus>& but, JournalWriter& journal);

/// Makes one results file of a study's parts: results files and journals of its shards and ranks,
/// in any order; the same parts give the same bytes. Shards of a collection may have listed
/// different files: the study then has the files of all.
/// @return what is there; nothing is written unless it is complete.
/// @throws InputError naming the file if one cannot be read or is damaged, if they are of different
/// studies, sources or divisions into shards, if a row is there twice and not the same, or if the
/// output cannot be written.
StudyOutcome merge_study(const std::vector<std::string>& parts, const std::string& output);

}  // namespace ar3d
