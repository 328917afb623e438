#pragma once

#include <cstdint>
#include <string>

#include "ar3d/bench/replay/replay_row.h"
#include "ar3d/store/rows.h"

namespace ar3d {

/// Returns why nothing can be counted here: valgrind is missing, or the build is sanitised; empty
/// if it can.
std::string counting_problem();

/// Fills counted_instructions and estimated_cycles in all rows of every drawing with at most max_n
/// vertices, by callgrind (valgrind) in one process of this program. The same build gives the same
/// numbers on every run. A program of the study runs under callgrind itself and gets no estimated
/// cycles; one that fails there, or counts another number for the same graph, is named on standard
/// error and not counted. Cost: about 50 times the time of generating and drawing, and two seconds;
/// a second for each graph of a program.
/// @return how many drawings; 0 also if it was interrupted.
/// @throws InputError as plan_of_row; naming the row that callgrind did not come to the end of; as
/// counting_problem().
std::size_t fill_counts(Results& results, std::int64_t max_n);

/// Names what fill_counts runs under valgrind: `ar3d study draw-counted FILE`, a name that
/// programs use, not people. Draws what the lines of the file say: family, parameters, n, seed,
/// algorithm, options, between tabs. A family "file:PATH" is the only graph of that file.
inline constexpr const char* kDrawCountedVerb = "draw-counted";
/// @throws InputError as plan_of_row.
void draw_for_counting(const std::string& file);

}  // namespace ar3d
