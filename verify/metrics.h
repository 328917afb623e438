#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"
#include "ar3d/model/guarantee.h"

namespace ar3d {

/// The sizes of one drawing. Extents are integers and exact; the other figures are rounded doubles,
/// equal for equal drawings. What does not exist (a distance of fewer than two vertices, a slack
/// without a bound) is NaN.
struct Metrics {
  std::array<std::int64_t, 3> extents{};
  double log2_volume = 0;
  double volume_per_n3 = 0;
  std::vector<std::uint64_t> bend_histogram;  ///< entry b: number of edges with b bends
  double total_edge_length = 0;
  double longest_edge_length = 0;
  double smallest_vertex_distance = 0;
  std::array<double, 3> theorem_bound{};
  std::array<double, 3> slack{};
};

/// All of them. Nothing is checked: certify() does that.
/// @pre every coordinate is in range.
/// @throws InputError if the drawing's Gram matrix is not positive definite.
/// Cost: O(n + m + S) expected time, O(n) memory.
Metrics measure(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee);

/// One row of the catalogue of metrics.
struct Metric {
  std::string name;
  std::string unit;
  std::string definition;
  double (*value)(const Metrics&) = nullptr;
};

/// All metrics, in the order in which they are listed.
const std::vector<Metric>& metrics();

}  // namespace ar3d
