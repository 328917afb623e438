// Edges of a graph under construction; that the graph is simple is checked once, by Graph.
#include "ar3d/generators/graph_builder.h"

#include "ar3d/base/error.h"

namespace ar3d {

GraphBuilder::GraphBuilder(Count num_vertices, Count expected_edges) : num_vertices_(num_vertices) {
  edges_.reserve(expected_edges);
}

Count GraphBuilder::add_vertices(Count count) {
  const Count first = num_vertices_;
  num_vertices_ += count;
  return first;
}

void GraphBuilder::edge(Count u, Count v) {
  expect(u < num_vertices_ && v < num_vertices_,
         "an edge under construction has its ends in range");
  edges_.push_back({static_cast<Vertex>(u), static_cast<Vertex>(v)});
}

void GraphBuilder::path(Count first, Count count) {
  for (Count i = 1; i < count; ++i) edge(first + i - 1, first + i);
}

void GraphBuilder::cycle(Count first, Count count) {
  path(first, count);
  edge(first + count - 1, first);
}

Count GraphBuilder::append(const Graph& part) {
  const Count first = add_vertices(part.num_vertices());
  edges(part.edges(), first);
  return first;
}

Graph GraphBuilder::finish() { return Graph(num_vertices_, std::exchange(edges_, {})); }

}  // namespace ar3d
