#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "ar3d/records/run_storage.h"

namespace ar3d {

/// What one curve of a study has in common: an algorithm with its options on a family with its
/// parameters.
struct CellKey {
  std::string algorithm;
  std::string options;
  std::string family;
  std::string parameters;
  friend auto operator<=>(const CellKey&, const CellKey&) = default;
};

/// "diamond (effort=1)", "cubic (k=2)": names for people; empty options and parameters leave no
/// brackets.
std::string algorithm_label(const CellKey& key);
std::string family_label(const CellKey& key);

/// The repetitions of one graph in one cell, as indices into Results::runs in file order; never
/// empty.
struct InstanceRows {
  std::int64_t n = -1;
  std::vector<std::size_t> rows;
};

/// The rows of one curve.
struct Cell {
  CellKey key;
  std::vector<std::size_t> rows;  ///< indices into Results::runs, in file order; never empty
  std::vector<InstanceRows>
      instances;  ///< the same rows by instance, sorted by n, then in file order
};

/// All cells in the order of their first rows. Cost: O(r log r) for r rows.
std::vector<Cell> cells(const Results& results);

/// The instance's first row with status ok, or nullptr.
const RunRecord* first_ok(const Results& results, const InstanceRows& instance);

}  // namespace ar3d
