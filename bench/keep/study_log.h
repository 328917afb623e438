#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/bench/keep/journaled_study.h"
#include "ar3d/bench/keep/study_files.h"
#include "ar3d/bench/plan/plan.h"
#include "ar3d/bench/run/session.h"
#include "ar3d/store/journal/journal_writer.h"
#include "ar3d/store/rows.h"

namespace ar3d {

/// Represents the log of a study that one process appends to: its journal, locked while this lives.
class StudyLog {
 public:
  /// Opens the journal, on all ranks. What the results file alone holds goes into the journal of
  /// rank 0 first.
  /// Study and plan outlive it. @throws FailedTogether, InputError as JournalWriter; naming a row
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

}  // namespace ar3d
