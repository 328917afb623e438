#include "ar3d/algorithms/grid/planes.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>

#include "ar3d/algorithms/grid/placement.h"
#include "ar3d/model/error.h"

namespace ar3d::grid {

Planes assign_planes(const Graph& graph, const ProcessingOrder& order, Labels labels,
                     const PlaneOptions& options) {
  const ZoneProof proof{graph.num_vertices()};
  std::int64_t zone = proof.window(options) + 2;
  for (std::int64_t restarts = 0;; ++restarts) {
    Placement placement(graph, order, labels, options, zone);
    if (placement.place_all()) {
      Planes planes = std::move(placement).result();
      planes.counts.restarts = restarts;
      return planes;
    }
    expect(zone < proof.largest_zone(), "the size proof's zone holds every number");
    zone = std::min(2 * zone, proof.largest_zone());
  }
}

}  // namespace ar3d::grid
