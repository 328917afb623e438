#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <limits>
#include <map>
#include <string>

#include "ar3d/store/columns/curves.h"
#include "ar3d/store/run_storage.h"

namespace ar3d {

/// Says what a history follows of every cell.
enum class Measure : std::uint8_t { time, instructions, cycles, volume, bends, crossings, angle };
inline constexpr std::array kMeasures = {Measure::time,   Measure::instructions, Measure::cycles,
                                         Measure::volume, Measure::bends,        Measure::crossings,
                                         Measure::angle};
/// "time", "instructions", "cycles", "volume", …
const char* to_string(Measure measure);

/// A curve at one size with the very graphs that were drawn: values of other graphs are another
/// cell's.
struct HistoryCell {
  CurveKey curve;
  std::int64_t n = -1;
  std::string graphs;  ///< a hash of all of them
  friend auto operator<=>(const HistoryCell&, const HistoryCell&) = default;
};

/// A measure of a cell in one results file; missing (NaN) where a row of the cell has none.
struct CellValue {
  /// time: seconds, the geometric mean over the graphs of the median of the repetitions, of the
  /// timing phase if the cell has it; there each in units of the yardsticks near it, times the
  /// file's typical ones. instructions: counted by callgrind, geometric mean;
  /// cycles: estimated from its simulated cache, likewise.
  /// volume: lattice points, geometric mean; of measured drawings in smallest distances of
  /// vertices. bends: per edge. crossings, angle (the smallest, degrees): of measured drawings,
  /// arithmetic mean.
  double value = kMissing;
  std::string exact = {};  ///< of a drawing: a hash of those of every single graph; what is
                           ///< measured has three digits there
};
using CellValues = std::array<CellValue, kMeasures.size()>;

struct CellTable {
  std::map<HistoryCell, CellValues> cells;
  std::size_t unfinished = 0;      ///< rows neither ok nor measured: their cells have no values
  double rows_at_a_time = 1;       ///< the largest concurrency
  std::string build_kind;          ///< of a row that has one
  double log_slowness = kMissing;  ///< median of that of the rows
};

/// One pass over the rows; those of batches (strong, weak) are left out. Memory: that of the
/// graphs. Cost: O(r log r) for r rows.
CellTable cell_values(const RowView& rows);

}  // namespace ar3d
