// Steps 3.6 and 3.9 to 3.13 or 3.2 to 3.5 for each component: flat numbers where they can be had,
// else the core. The zone of the core begins small and doubles until it holds every number, which
// Lemma 3.5 says it does at 11n + 20. O(n log n) expected.
#include "ar3d/algorithms/grid/planes.h"

#include "ar3d/algorithms/grid/flat.h"
#include "ar3d/algorithms/grid/placement.h"

namespace ar3d::grid {
namespace {

/// Numbers and labels that are not chosen yet.
Planes unset_planes(std::size_t vertices, EdgeId edges) {
  return {std::vector<PlaneNumbers>(vertices, kUnsetNumbers), EdgeLabels(edges), {}, {}, {}};
}

/// @param planes  of the placed graph.
void number_by_core(const PlacedGraph& graph, const OrderPart& part, Planes& planes) {
  const ZoneProof proof{part.size()};
  const std::int64_t window = proof.window();
  std::int64_t zone = window + 2;
  ++planes.counts.core_parts;
  while (!Placement(graph, part, planes, window, zone).place_all()) {
    expect(zone < proof.largest_zone(), "the size proof's zone holds every number");
    zone = std::min(2 * zone, proof.largest_zone());
    ++planes.counts.restarts;
  }
  for (Index v = part.begin; v < part.end; ++v) {
    expect(all_within(proved_plane_bound(proof.n), planes.of[v]),
           "plane numbers keep the size proof's bound");
  }
}

/// Copies one component's numbers and labels from indices to vertices.
void adopt_core(const ProcessingOrder& order, const PlacedGraph& graph, const OrderPart& part,
                const Planes& core, Planes& planes) {
  for (Index i = part.begin; i < part.end; ++i) {
    if (i + kAhead < part.end) {
      __builtin_prefetch(&planes.of[order.sequence[i + kAhead]], 1);
      for (const HalfEdge& half : graph.incident(i + kAhead)) {
        planes.labels.prefetch(graph.edge_of(half.edge));
      }
    }
    planes.of[order.sequence[i]] = core.of[i];
    for (const HalfEdge& half : graph.incident(i)) {
      planes.labels.set(graph.edge_of(half.edge), order.sequence[i], order.sequence[half.to],
                        core.labels.at(half.edge, i, half.to));
    }
  }
}

/// Numbers the components in the graph renamed by indices.
void number_by_core(const Graph& graph, const ProcessingOrder& order,
                    std::span<const OrderPart> parts, Planes& planes) {
  const PlacedGraph placed(neighbours_in_order(graph, order));
  Planes core = unset_planes(placed.num_vertices(), placed.num_edges());
  core.labels = label_half_edges(placed, order);
  core.counts = planes.counts;
  core.steps = planes.steps;
  for (const OrderPart& part : parts) {
    number_by_core(placed, part, core);
    adopt_core(order, placed, part, core, planes);
  }
  planes.counts = core.counts;
  planes.steps = core.steps;
  for (const Slot& slot : core.slots) planes.slots.push_back({placed.edge_of(slot.edge), slot.k});
}

}  // namespace

Planes assign_planes(const Graph& graph, const ProcessingOrder& order,
                     const PlaneOptions& options) {
  Planes planes = unset_planes(graph.num_vertices(), graph.num_edges());
  const std::vector<OrderPart> left =
      options.flat ? number_flat(graph, order, options, planes) : order.parts;
  if (!left.empty()) number_by_core(graph, order, left, planes);
  std::ranges::sort(planes.slots, {}, &Slot::edge);
  return planes;
}

}  // namespace ar3d::grid
