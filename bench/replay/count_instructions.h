#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "ar3d/bench/replay/replay_row.h"
#include "ar3d/store/columns/run_record.h"
#include "ar3d/store/run_storage.h"

namespace ar3d {

/// Holds what callgrind counts of a drawing, generation and certification left out.
struct DrawingCounts {
  std::int64_t instructions = -1;
  /// Instructions + 10 for every miss of the first level of a simulated cache + 100 for every miss
  /// of its last: the estimate of kcachegrind. The cache is the same on every machine: 32 KB of
  /// instructions and 32 KB of data, 8 MB behind both.
  std::int64_t estimated_cycles = -1;
};

/// Why nothing can be counted here: valgrind is missing, or the build is sanitised. Empty: it can.
std::string counting_problem();

/// Counts drawings in one process of this program under callgrind (valgrind), one after the other:
/// rows of one graph that stand together have it generated once. The same numbers on every run of
/// the same build with the same rows. Cost: about 50 times the time of generating and drawing, and
/// two seconds.
/// @param rows  their identity is what counts. @param origin  of the rows, for graphs of files.
/// @return one for each row; empty if it was interrupted (is_interrupted).
/// @throws InputError as plan_of_row; naming the row that callgrind did not come to the end of; as
/// counting_problem().
std::vector<DrawingCounts> count_drawings(const std::vector<const RunRecord*>& rows,
                                          const StudyOrigin& origin = {});

/// Fills the columns of what count_drawings counts, in all rows of every drawing of the catalogue's
/// algorithms with at most max_n vertices. @return how many drawings; 0 also if it was interrupted.
/// @throws InputError as count_drawings.
/// Drawings of more vertices are not counted unless that is asked for.
inline constexpr std::int64_t kLargestCounted = 10000;
std::size_t fill_counts(Results& results, std::int64_t max_n);

/// Names what count_drawings runs under valgrind: `ar3d study draw-counted FILE`, a name that
/// programs use, not people. Draws what the lines of the file say: family, parameters, n, seed,
/// algorithm, options, between tabs. A family "file:PATH" is the only graph of that file.
inline constexpr const char* kDrawCountedVerb = "draw-counted";
/// @throws InputError as plan_of_row.
void draw_for_counting(const std::string& file);

}  // namespace ar3d
