// Steps 3.6 and 3.9 to 3.13 or 3.2 to 3.5 for each component: flat numbers where they can be had,
// else the core. The zone of the core begins small and doubles until it holds every number, which
// Lemma 3.5 says it does at 11n + 20. O(n log n) expected.
#include "ar3d/algorithms/grid/planes.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "ar3d/algorithms/grid/flat.h"
#include "ar3d/algorithms/grid/placed_graph.h"
#include "ar3d/algorithms/grid/placement.h"
#include "ar3d/base/error.h"

namespace ar3d::grid {
namespace {

bool all_within(std::int64_t bound, const PlaneNumbers& numbers) {
  return std::ranges::all_of(numbers, [&](std::int64_t x) { return -bound <= x && x <= bound; });
}

/// Numbers and labels that nobody has chosen yet.
Planes unset_planes(std::size_t vertices, EdgeId edges) {
  return {std::vector<PlaneNumbers>(vertices, {kUnsetNumber, kUnsetNumber, kUnsetNumber}),
          EdgeLabels(edges),
          {},
          {},
          {}};
}

/// @param planes  of the placed graph.
void number_by_core(const PlacedGraph& graph, const OrderPart& part, Planes& planes) {
  const PlaceRange range{static_cast<Place>(part.begin), static_cast<Place>(part.end)};
  const ZoneProof proof{range.size()};
  const std::int64_t window = proof.window();
  std::int64_t zone = window + 2;
  ++planes.counts.core_parts;
  while (!Placement(graph, range, part.cubic, planes, window, zone).place_all()) {
    expect(zone < proof.largest_zone(), "the size proof's zone holds every number");
    zone = std::min(2 * zone, proof.largest_zone());
    ++planes.counts.restarts;
  }
  for (Place v = range.begin; v < range.end; ++v) {
    expect(all_within(proved_plane_bound(proof.n), planes.of[v]),
           "plane numbers keep the size proof's bound");
  }
}

/// Copies one component's numbers and labels from places to vertices.
void adopt_core(const ProcessingOrder& order, const PlacedGraph& graph, const OrderPart& part,
                const Planes& core, Planes& planes) {
  for (auto i = static_cast<Place>(part.begin); i < part.end; ++i) {
    if (i + kAhead < part.end) {
      __builtin_prefetch(&planes.of[order.sequence[i + kAhead]], 1);
      for (const HalfEdge& half : graph.incident(i + kAhead)) {
        planes.labels.ask_for(graph.edge_of(half.edge));
      }
    }
    planes.of[order.sequence[i]] = core.of[i];
    for (const HalfEdge& half : graph.incident(i)) {
      planes.labels.set(graph.edge_of(half.edge), order.sequence[i], order.sequence[half.to],
                        core.labels.at(half.edge, i, half.to));
    }
  }
}

/// Numbers the components in the graph renamed by places.
void number_by_core(const Graph& graph, const ProcessingOrder& order,
                    std::span<const OrderPart> parts, Planes& planes) {
  const PlacedGraph placed(neighbours_in_order(graph, order));
  Planes core = unset_planes(placed.num_vertices(), placed.num_edges());
  core.labels = label_half_edges(placed, order).of;
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

/// Copies one component's labels and numbers from places to vertices.
void adopt_flat(const ProcessingOrder& order, std::span<const NeighbourPlaces> neighbours,
                const Colouring& colouring, const OrderPart& part, const Flat& flat,
                Planes& planes) {
  const auto set_label = [&](EdgeId e, Place at, Place to, Colour label) {
    planes.labels.set(e, order.sequence[at], order.sequence[to], label);
  };
  for (auto i = static_cast<Place>(part.begin); i < part.end; ++i) {
    if (i + kAhead < part.end) __builtin_prefetch(&planes.of[order.sequence[i + kAhead]], 1);
    planes.of[order.sequence[i]] = flat.numbers()[i];
    const auto& to = colouring.ports[i].to;
    for (unsigned j = 0; j < neighbours[i].degree; ++j) {
      const Place other = neighbours[i].to[j];
      const Colour label = to[0] == other ? 0 : to[1] == other ? 1 : 2;
      set_label(neighbours[i].edge[j], i, other, label);
    }
  }
  for (const ColourDefect& defect : flat.defects()) {
    set_label(defect.edge, defect.x, defect.y, defect.label_x);
    set_label(defect.edge, defect.y, defect.x, defect.label_y);
  }
  planes.slots.insert(planes.slots.end(), flat.slots().begin(), flat.slots().end());
  planes.counts.flat_defects += static_cast<std::int64_t>(flat.defects().size());
}

/// Numbers what can be flat; returns the components that cannot.
std::vector<OrderPart> number_flat(const Graph& graph, const ProcessingOrder& order,
                                   const PlaneOptions& options, Planes& planes) {
  const UnwrittenVector<NeighbourPlaces> neighbours = neighbours_in_order(graph, order);
  Colouring colouring = colour_half_edges(order, neighbours, options.longest_chain);
  Flat flat(neighbours, colouring);
  planes.steps.chain_steps += static_cast<std::int64_t>(colouring.chain_steps);
  std::vector<OrderPart> left;
  std::span<const ColourDefect> defects(colouring.defects);
  for (const OrderPart& part : order.parts) {
    const auto of_part = std::ranges::find_if(
        defects, [&](const ColourDefect& defect) { return defect.x >= part.end; });
    const auto mine = defects.first(static_cast<std::size_t>(of_part - defects.begin()));
    defects = defects.subspan(mine.size());
    const PlaceRange range{static_cast<Place>(part.begin), static_cast<Place>(part.end)};
    const std::span<const PlaneNumbers> numbers(&flat.numbers()[part.begin], part.end - part.begin);
    const bool is_flat = flat.number(range, mine);
    if (is_flat && std::ranges::all_of(numbers, [&](const PlaneNumbers& x) {
          return all_within(2 * range.size() + options.flat_allowance, x);
        })) {
      adopt_flat(order, neighbours, colouring, part, flat, planes);
    } else {
      left.push_back(part);
    }
  }
  planes.steps += flat.steps();
  return left;
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
