#pragma once

#include <string>

#include "ar3d/algorithms/routed/routed.h"
#include "ar3d/verify/certificate.h"
#include "support/counters.h"
#include "support/graphs.h"

namespace ar3d::testing {

/// What is wrong with the routed drawing; "" if it is certified and has at most the bends asked for.
/// @param fall_backs  counts drawings of graphs with edges that are not routed.
inline std::string routed_fault(const Graph& graph, const Algorithm& row, std::int64_t bends,
                                std::int64_t effort, int* fall_backs = nullptr) {
  const Drawing drawing = draw(row, graph, {{"bends", bends}, {"effort", effort}});
  const Certificate certificate = certify(graph, drawing, row.guarantee);
  if (!certificate.valid()) return certificate.violations.front().message;
  std::string fault;
  for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& points) {
    if (static_cast<std::int64_t>(points.size()) > bends + 2) {
      fault = "edge " + std::to_string(e) + " has too many bends";
    }
  });
  if (fall_backs && graph.num_edges() > 0) {  // points alone fit on a line
    *fall_backs += value_of(drawing.counters, "routed") == 0;
  }
  return fault;
}

}  // namespace ar3d::testing
