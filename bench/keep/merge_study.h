#pragma once

#include <string>
#include <vector>

#include "ar3d/bench/keep/journaled_study.h"

namespace ar3d {

/// Makes one results file of a study's parts: results files and journals of its shards and ranks,
/// in any order; the same parts give the same bytes.
/// @return what is there; nothing is written unless it is complete.
/// @throws InputError naming the file if one cannot be read or is damaged, if they are of different
/// studies, sources or divisions into shards, if a row is there twice and not the same, or if the
/// output cannot be written.
StudyOutcome merge_study(const std::vector<std::string>& parts, const std::string& output);

}  // namespace ar3d
