#pragma once

#include <cstdint>
#include <string>

namespace ar3d::limits {

struct FamiliesScale {
  std::uint64_t max_n = 0;
  int repetitions = 0;  ///< at most
  std::string only;     ///< rows ALGORITHM/FAMILY that this regular expression finds
};

/// Prints a table in Markdown: for every algorithm that proves its drawings, at its default effort,
/// and every family it draws, the CPU time of drawing in nanoseconds per vertex and its ratio to a
/// breadth-first search, for n = 10^3, 10^4, … up to max_n, vertices shuffled; the exponent of n
/// with which that ratio grows; and at the end the largest of them for each algorithm.
void print_families(const FamiliesScale& scale);

}  // namespace ar3d::limits
