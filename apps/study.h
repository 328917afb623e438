#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "ar3d/bench/run/make_rows.h"
#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/store/columns/run_record.h"

namespace ar3d {

/// Verbs of `ar3d study` that have files of their own.
void add_study_status(CLI::App& study, int& exit_code);
void add_study_merge(CLI::App& study, int& exit_code);
void add_study_plan(CLI::App& study, int& exit_code);
void add_study_selfcheck(CLI::App& study, int& exit_code);
void add_study_drawings(CLI::App& study, int& exit_code);
void add_study_count(CLI::App& study, int& exit_code);

/// Before any work: @throws InputError if the study cannot be made with this policy (bad build, too
/// few cores) or, for large sizes and for rows with limits, if a cell is estimated to be
/// impossible.
void refuse_impossible_study(const StudySpec& spec, const MakingPolicy& policy);

/// "2/8": the second of eight. @throws InputError naming the text.
Shard parse_shard(const std::string& text);

}  // namespace ar3d
