#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/store/rows.h"

namespace ar3d {

/// Returns "2026-01-02T03:04:05.678901+00:00".
std::string time_with_zone(std::chrono::system_clock::time_point time);
inline std::string now_with_zone() { return time_with_zone(std::chrono::system_clock::now()); }

/// Returns the tables that stand beside a study's rows: its algorithms, files and their graphs.
/// @throws InputError as corpora_of.
std::vector<StoredTable> side_tables_of(const Study& study);

/// Returns everything about a study's results but its rows: name, specification, source,
/// environment, time.
/// @param workers  of the process, for the environment. @throws InputError as corpora_of, and if
/// the executable of a program cannot be read.
Results describe_study(const Study& study, int workers);

/// Requires that rows of one study are of one program each. @param before  of earlier sessions.
/// @param results  for messages. @throws InputError naming a program whose hash is another one now.
void refuse_changed_programs(const StudySpec& spec, const std::vector<EnvironmentEntry>& before,
                             const std::string& results);

/// @throws InputError naming the first program of the study that cannot be run.
void require_programs(const StudySpec& spec);

}  // namespace ar3d
