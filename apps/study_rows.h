#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "ar3d/analysis/check.h"
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

}  // namespace ar3d
