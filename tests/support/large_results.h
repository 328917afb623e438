#pragma once

#include <cstddef>
#include <string>

namespace ar3d::testing {

/// What a large results file of made-up rows looks like: `rows` rows in the order of a study, each
/// graph drawn by four algorithms; families and sizes in turns, so that every size of every family
/// has as many graphs.
struct LargeResults {
  std::size_t rows = 0;
  std::size_t families = 20;
  std::size_t sizes = 10;      ///< 16, 32, 64, …
  std::size_t violated = 0;    ///< so many rows, spread evenly, are violated
  std::size_t unfinished = 0;  ///< so many others are timeouts
};

/// Writes such a file with the program's own writer, row by row: all rows but those are proved and
/// inside their bounds. Memory: 10 bytes per row.
void write_large_results(const LargeResults& like, const std::string& path);

}  // namespace ar3d::testing
