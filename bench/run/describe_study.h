#pragma once

#include <string>

#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/records/run_storage.h"

namespace ar3d {

/// "2026-01-02T03:04:05.678901+00:00".
std::string now_with_zone();

/// Everything about a study's results but its rows: name, specification, source, environment, time.
/// @param workers  of the process, for the environment. @throws InputError as corpora_of.
Results describe_study(const StudySpec& spec, int workers);

}  // namespace ar3d
