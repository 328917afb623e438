// Parts of a graph, their vertices numbered anew.
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/two_bit_color_map.hpp>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "ar3d/bench/corpus/corpus.h"
#include "ar3d/model/boost_graph.h"

namespace ar3d {
namespace {

constexpr Vertex kAbsent = std::numeric_limits<Vertex>::max();

// new_name[v] is kAbsent for vertices that are left out.
Graph renamed(const Graph& graph, const std::vector<Vertex>& new_name, Vertex n) {
  std::vector<Edge> edges;
  for (const Edge edge : graph.edges()) {
    const Edge renamed{new_name[edge.u], new_name[edge.v]};
    if (renamed.u != kAbsent && renamed.v != kAbsent) edges.push_back(renamed);
  }
  return Graph(n, std::move(edges));
}

}  // namespace

Graph induced(const Graph& graph, const std::vector<bool>& keep) {
  std::vector<Vertex> new_name(graph.num_vertices(), kAbsent);
  Vertex n = 0;
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    if (keep[v]) new_name[v] = n++;
  }
  return renamed(graph, new_name, n);
}

Graph breadth_first_piece(const Graph& graph, std::uint64_t n) {
  if (n >= graph.num_vertices()) return graph;
  std::vector<Vertex> new_name(graph.num_vertices(), kAbsent);
  std::vector<Vertex> found;
  const auto find = boost::make_bfs_visitor(boost::write_property(
      boost::identity_property_map(), std::back_inserter(found), boost::on_discover_vertex()));
  auto colours =
      boost::make_two_bit_color_map(graph.num_vertices(), boost::identity_property_map());
  for (Vertex start = 0; found.size() < n; ++start) {
    if (get(colours, start) != boost::two_bit_white) continue;
    boost::queue<Vertex> waiting;
    boost::breadth_first_visit(graph, start, waiting, find, colours);
  }
  for (Vertex name = 0; name < n; ++name) new_name[found[name]] = name;
  return renamed(graph, new_name, static_cast<Vertex>(n));
}

}  // namespace ar3d
