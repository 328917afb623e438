#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "ar3d/model/graph.h"

namespace ar3d::two_bend_paper {

/// A vertex of the graph while it shrinks: those of the input, then one for every contraction.
using Node = std::uint32_t;

/// The edges at a node.
using Star = boost::container::static_vector<HalfEdge, 3>;

/// Says what is contracted, by its members' indices in Contraction::members:
///   triangle  0, 1, 2
///   diamond   tips 0 and 1, mids 2 and 3, which have no edge to the outside
///   fat_leaf  0, the common neighbour of the tips 1 and 2; mids 3 and 4
enum class FigureKind : std::uint8_t { triangle, diamond, fat_leaf };

/// An end of an edge that leaves the figure, by its slot (0: the edge's u, 1: its v).
using OuterEnd = std::pair<EdgeId, std::uint8_t>;

/// An edge within the figure, and the members at its slots 0 and 1.
using InnerEdge = std::tuple<EdgeId, std::size_t, std::size_t>;

/// One contraction. Members with edges to the outside come first among the corners of a triangle
/// and among the tips of a diamond.
struct Contraction {
  FigureKind figure{};
  Node result = 0;
  boost::container::static_vector<Node, 5> members;
  std::vector<InnerEdge> inner;
  std::vector<OuterEnd> outer;  ///< in order of members
};

/// The graph after all contractions: simple, and its only triangles are those of components K4.
struct ContractedGraph {
  std::vector<Star> stars;                ///< of all nodes; those of dead ones mean nothing
  std::vector<bool> alive;                ///< nodes that are left
  std::vector<std::array<Node, 2>> ends;  ///< last ends of every edge by slot
  std::vector<Contraction> contractions;  ///< in order of time
  Node num_nodes() const { return static_cast<Node>(stars.size()); }
};

/// Contracts triangles until none is left outside components K4 (Step P.1).
/// @param graph  of maximum degree 3. Cost: O(n + m).
ContractedGraph contract(const Graph& graph);

/// True if the node and its three neighbours are all adjacent to each other: a component K4.
bool is_in_k4(const ContractedGraph& graph, Node node);

}  // namespace ar3d::two_bend_paper
