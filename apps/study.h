#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "ar3d/results/run.h"

namespace ar3d {

/// Verbs of `ar3d study` that have files of their own.
void add_study_status(CLI::App& study, int& exit_code);
void add_study_merge(CLI::App& study, int& exit_code);

/// "2/8": the second of eight. @throws InputError naming the text.
Shard parse_shard(const std::string& text);

}  // namespace ar3d
