#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <string>

#include "ar3d/analysis/compare/file_times.h"
#include "ar3d/store/columns/curves.h"
#include "ar3d/store/run_storage.h"

namespace ar3d {

/// Says what a history follows of every cell.
enum class Measure : std::uint8_t { time, instructions, cycles, volume, bends, crossings, angle };
inline constexpr std::array kMeasures = {Measure::time,   Measure::instructions, Measure::cycles,
                                         Measure::volume, Measure::bends,        Measure::crossings,
                                         Measure::angle};
/// Returns "time", "instructions", "cycles", "volume", …
const char* to_string(Measure measure);

/// Describes a curve at one size with the very graphs that were drawn: values of other graphs are
/// another cell's.
struct HistoryCell {
  CurveKey curve;
  std::int64_t n = -1;
  std::string graphs;  ///< a hash of all of them
  friend auto operator<=>(const HistoryCell&, const HistoryCell&) = default;
};

/// Is a measure of a cell in one results file; missing (NaN) where a row of the cell has none.
struct CellValue {
  /// Geometric means over the graphs but of bends (per edge), crossings and the smallest angle in
  /// degrees (arithmetic ones). Volumes are lattice points; of measured drawings they are in smallest
  /// distances of vertices.
  double value = kMissing;
  std::string exact = {};  ///< of a drawing: a hash of those of every single graph; what is
                           ///< measured has three digits there
};

/// Describes the measures of a cell in one results file.
struct CellValues {
  SideTimes times;                             ///< of the timing phase if the cell has it
  std::array<CellValue, kMeasures.size()> of;  ///< but the time
};

struct CellTable {
  std::map<HistoryCell, CellValues> cells;
  std::size_t unfinished = 0;  ///< rows neither ok nor measured: their cells have no values
  double rows_at_a_time = 1;   ///< the largest concurrency
  std::string build_kind;      ///< of a row that has one
  /// Holds medians of the logarithms of the yardsticks near the rows; NaN without any.
  std::array<double, 3> yardsticks{};
};

/// Passes once over the rows; those of batches (strong, weak) are left out. Memory: that of the
/// graphs. Cost: O(r log r) for r rows.
CellTable cell_values(const RowView& rows);

}  // namespace ar3d
