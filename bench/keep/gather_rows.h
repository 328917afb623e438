#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ar3d/bench/keep/journaled_study.h"
#include "ar3d/bench/plan/plan.h"
#include "ar3d/store/journal/journal_writer.h"
#include "ar3d/store/rows.h"

namespace ar3d {

/// Returns rows that a study is not complete without.
std::int64_t required_rows(const StudyPlan& plan);

/// Returns the rows of a study that are there, in its journals and its results file.
Rows rows_so_far(const std::string& results);

/// Returns how rows of files stand to a plan. @throws InputError naming a row that the plan does not
/// have.
StudyOutcome outcome_of(const StudyPlan& plan, const Rows& rows);

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
