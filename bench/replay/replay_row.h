#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "ar3d/bench/plan/plan.h"
#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/formats/text/output.h"
#include "ar3d/store/columns/run_record.h"
#include "ar3d/store/rows.h"

namespace ar3d {

/// Holds what rows were made of besides what they say themselves.
struct StudyOrigin {
  /// Holds the study with the files that it began with. Given: a row's key and its graph's seed are
  /// made from it again; else they are taken from the row.
  std::optional<Study> study = {};
  std::string moved_graphs = {};  ///< where the file of a row's graph is now; empty: where it was
  /// Holds the graphs of files that rows have needed, by their family: a folder is listed once.
  std::shared_ptr<std::map<std::string, std::vector<FamilyChoice>>> choices =
      std::make_shared<std::map<std::string, std::vector<FamilyChoice>>>();
};

/// Returns the origin of a study's rows, from its specification; nothing if that cannot be read any
/// more.
StudyOrigin study_origin(const StudyIdentity& identity);

/// Returns the plan of one recorded row: its instance with this single run.
/// @throws InputError naming an unknown family, algorithm, parameter or option; as corpora_of if
/// the graph is of a file.
PlannedInstance plan_of_row(const RunRecord& row, const StudyOrigin& origin = {});

/// Returns the drawing of a recorded row, drawn again. @throws InputError as plan_of_row.
Drawing redrawn(const RunRecord& row, const StudyOrigin& origin = {});

/// Returns the same if its hash is its row's; else nothing, and why.
std::optional<Drawing> drawn_again(const RunRecord& run, const StudyOrigin& origin,
                                   std::string& problem);

/// Makes a recorded row again: generates, draws, certifies. differing_columns(row, replayed(row))
/// is empty if nothing but measurements changed.
/// @throws InputError as plan_of_row.
RunRecord replayed(const RunRecord& row, const StudyOrigin& origin = {});

/// Returns the indices of `count` rows drawn at random without replacement, ascending; all if there
/// are fewer. A function of the seed and the rows. Rows that no replay can reproduce (timeout,
/// out_of_memory, crashed) are not drawn.
std::vector<std::size_t> sample_of_rows(const std::vector<RunRecord>& rows, std::size_t count,
                                        std::uint64_t seed);

/// Draws the rows again whose drawings are kept (of the metrics phase, one per drawing: graph,
/// algorithm, options), one at a time, and writes each drawing as a line of JSON, in the order of
/// the rows. A drawing is kept only if its hash is its row's.
/// worst: of each algorithm with options on a family with parameters the row with the largest share
/// of the theorem's bound on an axis; where there is no bound, with the largest miss of an angle,
/// and where there is none, with the largest volume. Of equal rows the first one.
/// Memory: 64 bytes per row kept, and the curves.
/// @return how many are kept, how many more rows have one of these, and a line for each drawing that
/// could not be kept.
/// @throws InputError if the file cannot be written; as corpora_of, before anything is drawn, if a
/// file of graphs is no longer what the study began with.
std::tuple<std::size_t, std::size_t, std::vector<std::string>> write_kept_drawings(
    const Rows& rows, KeptDrawings kept, OutputFile& file);

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
