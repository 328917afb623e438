#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "ar3d/algorithms/two_bend_120/cubic.h"

namespace ar3d::two_bend_120 {

/// An inner vertex of a numbering: its stem is alone on its side, its prongs are on the other one.
struct Fork {
  bool opens_up = false;  ///< a U: the prongs are above; else a D: they are below
  Vertex stem = 0;
  std::array<Vertex, 2> prongs{};
};

/// The vertices from the bottom S to the top T, so that each of the others is a fork. S and its
/// neighbours come first, T and its neighbours last, these in the order of their slots; no neighbour
/// of S is one of T or T itself.
struct ForkOrder {
  std::vector<Vertex> order;
  // Named by their index in the order:
  CubicGraph graph;
  std::vector<Fork> forks;  ///< S opens up, T down, and neither has a stem or prongs
};

/// Step F.3: S, T and the numbering, by trial of the ends in a fixed order, until one is accepted or
/// 100 have not been.
/// @param graph  connected, without bridges.
/// @return nothing if there is none, which happens only with at most ten vertices (Lemma F.3), with
/// two edges that cut the graph, or if none is accepted. Cost: O(n) for every pair of ends that is
/// tried.
std::optional<ForkOrder> find_numbering(const CubicGraph& graph,
                                        const std::function<bool(const ForkOrder&)>& accepts);

/// The two orders of Lemma F.4: the forks but S and T, ascending by a and by b. Of a D and the U
/// above it, which have equal a and equal b, only the D is listed.
struct Orders {
  std::vector<Vertex> a, b;
};

/// Step F.4: orders that keep the conditions 1 to 4.
/// @return nothing if none are found, which needs two edges that cut the graph.
/// Cost: O(n log n).
std::optional<Orders> find_orders(const std::vector<Fork>& forks);

}  // namespace ar3d::two_bend_120
