// Step D.5: classes and arms. Own edges take the arms 01 and 20; of two arrivals one takes an own
// arm of its side that is free, which exists because the vertex owns an edge if it has degree 3
// (Lemma D.8). Cost: O(n).
#include "ar3d/algorithms/compact_120/order.h"
#include "ar3d/base/error.h"

namespace ar3d::compact_120 {
namespace {

/// The arm other than 12 at which an edge from that side may arrive.
Arm side_arm(Class of, bool from_right) {
  if (of == Class::n) return from_right ? k01 : k20;
  return of == Class::s ? k20 : k01;
}

/// Arrivals of one vertex: one on 12, which at N is the one whose other arm is taken, at S and T
/// the one from farther away, since edges to their other arm pass far beyond their ends.
void assign_arrivals(Class of, const Order& order, const std::array<ArmLink, 3>& arrivals,
                     std::size_t count, std::array<ArmLink, 3>& at) {
  std::size_t on_12 = 0;
  const auto side = [&](std::size_t i) { return side_arm(of, arrivals[i].is_right); };
  if (count == 2) {
    const bool second_is_right = order.is_right(arrivals[0].to, arrivals[1].to);
    const bool second = of == Class::n ? at[side(1)].is_set() : second_is_right == (of == Class::s);
    on_12 = second ? 1 : 0;
  }
  for (std::size_t i = 0; i < count; ++i) {
    ArmLink& link = at[i == on_12 ? k12 : side(i)];
    expect(!link.is_set(), "an arm has one edge");
    link = arrivals[i];
  }
}

/// Stores at both ends of every edge where it arrives.
void tell_arrivals(Links& links, std::size_t num_edges) {
  LongVector<Arrival> arrival(num_edges);
  for (std::size_t v = 0; v < links.at.size(); ++v) {
    for (const Arm arm : kArms) {
      const ArmLink& link = links.at[v][arm];
      if (link.is_set() && link.is_out == 0) arrival[link.edge] = arrival_on(arm, links.of[v]);
    }
  }
  for (std::array<ArmLink, 3>& at : links.at) {
    for (ArmLink& link : at) {
      if (link.is_set()) link.at = static_cast<unsigned>(arrival[link.edge]) & 3u;
    }
  }
}

}  // namespace

Links assign_arms(const Graph& graph, const Order& order, const Owners& owners) {
  expect(owners.crowded.empty(), "a vertex owns one edge per side");
  Links links;
  links.at.resize(graph.num_vertices());
  links.of.resize(graph.num_vertices());
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    const unsigned rights = owners.right_edges(v);
    const std::span<const HalfEdge> row = graph.incident(v);
    if (row.size() == 3 && (rights == 0 || rights == 7)) {
      links.of[v] = rights == 7 ? Class::s : Class::t;
    }
    std::array<ArmLink, 3> arrivals;
    std::size_t count = 0;
    for (unsigned k = 0; k < row.size(); ++k) {
      const unsigned right = rights >> k & 1;
      const bool out = owners.owns(v, k);
      ArmLink& link = out ? links.at[v][right != 0 ? k01 : k20] : arrivals[count++];
      expect(!link.is_set(), "a vertex owns one edge per side");
      link.to = row[k].to;
      link.edge = row[k].edge & 0xfffffffu;
      link.is_out = out ? 1 : 0;
      link.is_right = right & 1u;
    }
    assign_arrivals(links.of[v], order, arrivals, count, links.at[v]);
  }
  tell_arrivals(links, graph.num_edges());
  return links;
}

}  // namespace ar3d::compact_120
