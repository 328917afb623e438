#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "ar3d/analysis/check.h"
#include "ar3d/analysis/report/report.h"
#include "ar3d/store/rows.h"

namespace ar3d {

/// Returns the rows of a study, wherever they are: in its results file or, while it is not finished,
/// in its journals. `study run`, `resume` and `status`, `check` and `report` judge these rows and no
/// others, with judge(), so that they agree.
/// @param file  the study's results file or a journal of it.
/// @throws InputError naming the file if neither is there, or if what is there cannot be read, is
/// damaged, or is no results file or journal.
Rows rows_of_study(const std::string& file);

/// Returns a line that says how many files of collections were left out; empty if none was.
std::string left_out_text(const StudyIdentity& identity);

/// Returns a verdict as `ar3d check --json` prints it.
nlohmann::ordered_json verdict_json(const CheckVerdict& verdict, const StudyIdentity& identity);

/// Returns the one verdict on a study. @param file  for messages.
/// @throws InputError if the rows cannot be of one study.
CheckVerdict judge(const Rows& rows, const std::string& file);

/// Returns what the report of a study says of an earlier one.
/// @param reference  the results file to compare with; empty: the youngest committed one of the
/// same study, if the working directory is in a checkout and has one.
/// @throws InputError if the given reference cannot be read or is of another study.
SinceReference since_reference(const Rows& rows, const std::string& reference);

/// Returns drawings of the graphs that come closest to their bounds, made again from their rows: at
/// most 200 of at most 1,000 edges each, as long as they take fewer than 300,000 bytes. A graph of
/// a file, a drawing of a foreign program, and one that does not come out as it was recorded
/// are left out.
ShownDrawings shown_drawings(const StudyAnalysis& analysis);

/// Returns the youngest committed reference results of the study,
/// results/reference/VERSION-STUDY.h5, by name; empty if there are none.
/// @throws InputError if the working directory is in no checkout.
std::string committed_reference(const std::string& study_id);

}  // namespace ar3d
