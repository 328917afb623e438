#pragma once

// Makes ar3d::Graph a model of Boost.Graph's VertexListGraph, EdgeListGraph, IncidenceGraph,
// AdjacencyGraph and BidirectionalGraph (undirected), and builds it from any model of
// VertexListGraph and EdgeListGraph. Include this header before calling Boost's algorithms on an
// ar3d::Graph.

#include <boost/graph/adjacency_iterator.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>
#include <cstdint>
#include <functional>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/model/graph.h"

namespace ar3d {

/// Boost's edge descriptor: directed as it was reached, equal if the edge is the same.
struct BoostEdge {
  Vertex from = 0;
  Vertex to = 0;
  EdgeId id = 0;
  friend bool operator==(const BoostEdge& a, const BoostEdge& b) { return a.id == b.id; }
  friend bool operator<(const BoostEdge& a, const BoostEdge& b) { return a.id < b.id; }
};

namespace boost_detail {
struct EdgeAt {
  const Graph* graph = nullptr;
  BoostEdge operator()(EdgeId e) const { return {graph->edge(e).u, graph->edge(e).v, e}; }
};
template <bool leads_out>
struct EdgeOfHalf {
  Vertex at = 0;
  BoostEdge operator()(const HalfEdge& half) const {
    return {leads_out ? at : half.to, leads_out ? half.to : at, half.edge};
  }
};
struct TraversalCategory : boost::bidirectional_graph_tag,
                           boost::adjacency_graph_tag,
                           boost::vertex_list_graph_tag,
                           boost::edge_list_graph_tag {};
}  // namespace boost_detail
}  // namespace ar3d

template <>
struct boost::graph_traits<ar3d::Graph> {
  using vertex_descriptor = ar3d::Vertex;
  using edge_descriptor = ar3d::BoostEdge;
  using directed_category = boost::undirected_tag;
  using edge_parallel_category = boost::disallow_parallel_edge_tag;
  using traversal_category = ar3d::boost_detail::TraversalCategory;
  using vertices_size_type = ar3d::Vertex;
  using edges_size_type = ar3d::EdgeId;
  using degree_size_type = std::uint32_t;
  using vertex_iterator = boost::counting_iterator<ar3d::Vertex>;
  using edge_iterator =
      boost::transform_iterator<ar3d::boost_detail::EdgeAt, boost::counting_iterator<ar3d::EdgeId>>;
  using out_edge_iterator =
      boost::transform_iterator<ar3d::boost_detail::EdgeOfHalf<true>, const ar3d::HalfEdge*>;
  using in_edge_iterator =
      boost::transform_iterator<ar3d::boost_detail::EdgeOfHalf<false>, const ar3d::HalfEdge*>;
  using adjacency_iterator =
      boost::adjacency_iterator_generator<ar3d::Graph, ar3d::Vertex, out_edge_iterator>::type;
  static vertex_descriptor null_vertex() { return static_cast<ar3d::Vertex>(-1); }
};
template <>  // some algorithms of Boost ask for the traits of the const type
struct boost::graph_traits<const ar3d::Graph> : boost::graph_traits<ar3d::Graph> {};

namespace ar3d {

using BoostTraits = boost::graph_traits<Graph>;

inline Vertex num_vertices(const Graph& g) { return g.num_vertices(); }
inline EdgeId num_edges(const Graph& g) { return g.num_edges(); }
inline std::pair<BoostTraits::vertex_iterator, BoostTraits::vertex_iterator> vertices(
    const Graph& g) {
  return {BoostTraits::vertex_iterator(0), BoostTraits::vertex_iterator(g.num_vertices())};
}
inline std::pair<BoostTraits::edge_iterator, BoostTraits::edge_iterator> edges(const Graph& g) {
  const boost_detail::EdgeAt at{&g};
  return {{boost::counting_iterator<EdgeId>(0), at},
          {boost::counting_iterator<EdgeId>(g.num_edges()), at}};
}
inline Vertex source(const BoostEdge& e, const Graph&) { return e.from; }
inline Vertex target(const BoostEdge& e, const Graph&) { return e.to; }
inline std::uint32_t out_degree(Vertex v, const Graph& g) { return g.degree(v); }
inline std::uint32_t in_degree(Vertex v, const Graph& g) { return g.degree(v); }
inline std::uint32_t degree(Vertex v, const Graph& g) { return g.degree(v); }
inline std::pair<BoostTraits::out_edge_iterator, BoostTraits::out_edge_iterator> out_edges(
    Vertex v, const Graph& g) {
  const auto row = g.incident(v);
  return {{row.data(), {v}}, {row.data() + row.size(), {v}}};
}
inline std::pair<BoostTraits::in_edge_iterator, BoostTraits::in_edge_iterator> in_edges(
    Vertex v, const Graph& g) {
  const auto row = g.incident(v);
  return {{row.data(), {v}}, {row.data() + row.size(), {v}}};
}
inline std::pair<BoostTraits::adjacency_iterator, BoostTraits::adjacency_iterator>
adjacent_vertices(Vertex v, const Graph& g) {
  const auto [begin, end] = out_edges(v, g);
  return {{begin, &g}, {end, &g}};
}

/// Boost's edge_index map: the edge's number, in Graph's order.
using EdgeIndexMap =
    boost::function_property_map<decltype(std::mem_fn(&BoostEdge::id)), BoostEdge, EdgeId>;
inline boost::identity_property_map get(boost::vertex_index_t, const Graph&) { return {}; }
inline Vertex get(boost::vertex_index_t, const Graph&, Vertex v) { return v; }
inline EdgeIndexMap get(boost::edge_index_t, const Graph&) { return std::mem_fn(&BoostEdge::id); }
inline EdgeId get(boost::edge_index_t, const Graph&, const BoostEdge& e) { return e.id; }

/// Builds a Graph from any model of VertexListGraph and EdgeListGraph; vertices are numbered
/// by the index map and edges in Graph's order, whatever that of edges(g).
/// @param index  readable property map: vertex descriptor -> 0..n-1. Of a filtered graph n is the
/// number of vertices that are left, so its index map has to be its own.
/// @throws InputError on loops, parallel edges and another index map. Cost: O(n + m).
template <class BoostGraph, class IndexMap>
Graph from_boost(const BoostGraph& g, IndexMap index) {
  const auto [first, last] = vertices(g);
  const auto count = static_cast<std::uint64_t>(std::distance(first, last));
  std::vector<bool> taken(count);
  for (auto v = first; v != last; ++v) {
    const auto at = static_cast<std::uint64_t>(get(index, *v));
    if (at >= count || taken[at]) {
      throw InputError("the index map gives a vertex the number " + std::to_string(get(index, *v)) +
                       ", but " + std::to_string(count) + " vertices have 0 to " +
                       std::to_string(count - 1) + ", each once");
    }
    taken[at] = true;
  }
  std::vector<Edge> list;
  list.reserve(num_edges(g));
  const auto [begin, end] = edges(g);
  for (auto e = begin; e != end; ++e) {
    list.push_back({static_cast<Vertex>(get(index, source(*e, g))),
                    static_cast<Vertex>(get(index, target(*e, g)))});
  }
  return Graph(count, std::move(list));
}

template <class BoostGraph>
Graph from_boost(const BoostGraph& g) {
  return from_boost(g, get(boost::vertex_index, g));
}

}  // namespace ar3d

template <>
struct boost::property_map<ar3d::Graph, boost::vertex_index_t> {
  using type = boost::identity_property_map;
  using const_type = type;
};
template <>
struct boost::property_map<ar3d::Graph, boost::edge_index_t> {
  using type = ar3d::EdgeIndexMap;
  using const_type = type;
};
