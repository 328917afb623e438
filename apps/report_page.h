#pragma once

#include <string>

#include "ar3d/analysis/report/report.h"

namespace ar3d {

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
