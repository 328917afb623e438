#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/bench/run/ranks.h"
#include "ar3d/bench/run/session.h"
#include "ar3d/bench/spec/study_spec.h"
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

/// Returns the study that rank 0 begins, on every rank. @throws FailedTogether if `begin` throws an
/// InputError.
JournaledStudy begin_together(Ranks& ranks, const std::function<JournaledStudy()>& begin);

/// Plans the rows, makes those that are missing, appends each to the log, and exports all as the
/// results file. Rows that are in the journals, or in a results file made from them, stay as they
/// are. Afterwards, whether complete or stopped, the results file holds all rows so far; the
/// journals are removed when it is complete. Several ranks share the metrics phase and write a
/// journal each; rank 0 does the timed phases alone and makes the results file.
/// @return of rank 0; other ranks know nothing of it.
/// @throws JournalFull (results.journal is whole), InputError as JournalWriter, plan_study; of
/// several ranks FailedTogether on all, or anything else on one, which has to end the others.
StudyOutcome run_journaled(JournaledStudy study, SessionPolicy policy, Ranks& ranks);

}  // namespace ar3d
