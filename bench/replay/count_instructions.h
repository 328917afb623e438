#pragma once

#include <cstdint>
#include <string>

#include "ar3d/bench/replay/replay_row.h"
#include "ar3d/store/columns/run_record.h"

namespace ar3d {

/// Draws a row's graph once; what callgrind is told to count is this function's call. A family
/// "file:PATH" is the only graph of that file.
/// @throws InputError as plan_of_row.
void draw_for_counting(const RunRecord& row);

/// Instructions of a row's drawing, generation and certification left out, counted by callgrind
/// (valgrind) in a run of this program: the same number on every run of the same build.
/// @param row  its identity is what counts.
/// @param origin  of the row, for graphs of files.
/// @throws InputError as plan_of_row; if valgrind is missing or fails; in a sanitised build, which
/// it cannot run.
std::int64_t count_instructions(const RunRecord& row, const StudyOrigin& origin = {});

/// What count_instructions runs under valgrind: `ar3d study draw-once FAMILY PARAMETERS N SEED
/// ALGORITHM OPTIONS`. Names that programs use, not people.
inline constexpr const char* kDrawOnceVerb = "draw-once";

}  // namespace ar3d
