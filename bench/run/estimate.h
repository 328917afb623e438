#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ar3d/bench/plan/plan.h"

namespace ar3d {

/// Describes a cell: all rows of a family with parameters, at one size, by one algorithm with
/// options at one level.
struct CellEstimate {
  CurveKey curve;
  std::uint64_t n = 0;
  std::size_t instances = 0;
  std::size_t rows = 0;   ///< without the optional ones
  bool is_known = false;  ///< false: a program draws it, or no drawing came of a trial
  double row_s = 0;       ///< estimated: generating, drawing and certifying one graph
  double draw_s = 0;      ///< estimated: drawing alone
  double total_s = 0;     ///< estimated: all rows, on one core
  double row_bytes = 0;   ///< estimated: peak of a row above the program's own memory
};

/// Holds what a study will cost, extrapolated from runs at small sizes on this machine: for each
/// family and algorithm power laws through two sizes for the CPU time and the memory (exponents
/// between 1 and 2.5), or by the space that the algorithm names. An estimate: expect it to be right
/// within a factor of about three.
struct StudyEstimate {
  std::vector<CellEstimate> cells;  ///< in the plan's order
  std::size_t rows = 0;             ///< without the optional ones
  std::size_t optional_rows = 0;
  std::size_t unknown_rows = 0;  ///< of `rows`, those of cells that nothing is known of
  int threads = 1;               ///< rows at a time in the metrics phase
  double wall_s = 0;  ///< of the whole study on so many threads, without the unknown rows
  double largest_row_bytes = 0;
  double counting_s = 0;  ///< of counting all drawings by callgrind, which wall_s does not hold
  std::uint64_t calibration_n = 0;  ///< the largest size that was drawn for it
};

/// Draws each family with each algorithm at two sizes, the larger one 3000 or a thirtieth of the
/// largest planned, but at most 33,333: a few seconds for the whole catalogue. Slow drawings are
/// made at smaller sizes. Each is made in a process of its own, which may use twice what the plan's
/// budget gives such a row. To be called while no other thread runs.
/// @throws InputError naming a cell of which that is not enough.
StudyEstimate estimate(const StudyPlan& plan, int threads);

/// Returns "616 GB": three digits and a decimal unit.
std::string bytes_text(double bytes);

/// Returns memory that this process may use in bytes: the machine's, or its control group's if that
/// is less.
double available_memory();

/// @throws InputError naming the first cell that is impossible: estimated above the machine's
/// memory, or more than twice above the budget's row_memory_bytes or row_time_s; or if the largest
/// rows that may be made at the same time are above the memory together.
void refuse_impossible(const StudyPlan& plan, const StudyEstimate& estimate, double memory_bytes);

}  // namespace ar3d
