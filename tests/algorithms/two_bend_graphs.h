#pragma once

// Random graphs that reach every part of the two-bend construction: leaf blocks of all kinds, joint
// components with many two-edge cuts, and everything between a tree and a cubic graph.

#include <algorithm>
#include <vector>

#include "ar3d/generators/random_graphs.h"

namespace ar3d::testing {

/// A graph under construction, simple by construction.
class Sketch {
 public:
  explicit Sketch(Vertex n = 0) : degree_(n, 0) {}
  explicit Sketch(const Graph& graph) : Sketch(graph.num_vertices()) {
    for (const Edge e : graph.edges()) join(e.u, e.v);
  }

  Vertex size() const { return static_cast<Vertex>(degree_.size()); }
  unsigned degree(Vertex v) const { return degree_[v]; }
  const std::vector<Edge>& edges() const { return edges_; }

  Vertex add_vertex() {
    degree_.push_back(0);
    return size() - 1;
  }
  void join(Vertex u, Vertex v) {
    edges_.push_back({u, v});
    ++degree_[u];
    ++degree_[v];
  }
  void cut(std::size_t edge) {
    const Edge e = edges_[edge];
    edges_[edge] = edges_.back();
    edges_.pop_back();
    --degree_[e.u];
    --degree_[e.v];
  }
  /// Puts a new vertex on an edge and returns it.
  Vertex subdivide(std::size_t edge) {
    const Edge e = edges_[edge];
    cut(edge);
    const Vertex v = add_vertex();
    join(e.u, v);
    join(v, e.v);
    return v;
  }
  /// Copies a graph beside this one; returns the number its vertex 0 got.
  Vertex add_copy(const Sketch& other) {
    const Vertex first = size();
    for (Vertex v = 0; v < other.size(); ++v) add_vertex();
    for (const Edge e : other.edges()) join(e.u + first, e.v + first);
    return first;
  }
  Graph graph() const { return Graph(size(), edges_); }

 private:
  std::vector<unsigned> degree_;
  std::vector<Edge> edges_;
};

/// Cubic and connected, n >= 4 even.
inline Sketch random_cubic_sketch(Vertex n, RandomStream& random) {
  return Sketch(random_connected_regular(n, 3, random.next64()));
}

/// Cubic graph with one edge subdivided: a leaf block with 5, 7, 9 or 11 vertices; `end` is its
/// free vertex.
inline Sketch random_leaf_block(RandomStream& random, Vertex& end) {
  Sketch sketch = random_cubic_sketch(4 + 2 * random.below(4), random);
  end = sketch.subdivide(random.below(static_cast<std::uint32_t>(sketch.edges().size())));
  return sketch;
}

/// Hangs leaf blocks, pendant vertices or nothing on free places, `percent_blocks` and
/// `percent_pendants` of them.
inline void hang_leaves(Sketch& sketch, RandomStream& random, std::uint32_t percent_blocks,
                        std::uint32_t percent_pendants) {
  const Vertex n = sketch.size();
  for (Vertex v = 0; v < n; ++v) {
    while (sketch.degree(v) < 3) {
      const std::uint32_t choice = random.below(100);
      if (choice < percent_blocks) {
        Vertex end = 0;
        const Sketch leaf = random_leaf_block(random, end);
        sketch.join(v, sketch.add_copy(leaf) + end);
      } else if (choice < percent_blocks + percent_pendants) {
        sketch.join(v, sketch.add_vertex());
      } else {
        break;
      }
    }
  }
}

/// A ring of two or more cubic pieces, each opened at an edge: bridgeless, cubic, many 2-edge cuts.
inline Sketch random_necklace(std::uint32_t pieces, RandomStream& random) {
  Sketch sketch;
  Vertex first = 0;
  Vertex last = 0;
  for (std::uint32_t i = 0; i < pieces; ++i) {
    Sketch piece = random_cubic_sketch(4 + 2 * random.below(3), random);
    const auto edge = random.below(static_cast<std::uint32_t>(piece.edges().size()));
    const Edge e = piece.edges()[edge];
    piece.cut(edge);
    const Vertex base = sketch.add_copy(piece);
    if (i > 0) sketch.join(last, base + e.u);
    if (i == 0) first = e.u;
    last = base + e.v;
  }
  sketch.join(last, first);
  return sketch;
}

/// One of many kinds, about n vertices before leaves are hung.
inline Graph random_graph_of_any_kind(Vertex n, std::uint64_t seed) {
  RandomStream random(seed, 77);
  const Vertex even = std::max<Vertex>(4, n / 2 * 2);
  const auto some_edge = [&](const Sketch& s) {
    return random.below(static_cast<std::uint32_t>(s.edges().size()));
  };
  switch (random.below(8)) {
    case 0:
      return random_cubic_sketch(even, random).graph();
    case 1:
      return random_necklace(2 + n / 8, random).graph();
    case 2: {  // a tree with all kinds of leaves
      Sketch sketch(random_tree(std::max<Vertex>(1, n / 4), 3, random.next64()));
      hang_leaves(sketch, random, 30 + random.below(71), random.below(30));
      return sketch.graph();
    }
    case 3: {  // subdivided
      Sketch sketch = random_cubic_sketch(even, random);
      for (std::uint32_t i = random.below(n + 1); i > 0; --i) sketch.subdivide(some_edge(sketch));
      hang_leaves(sketch, random, random.below(50), random.below(50));
      return sketch.graph();
    }
    case 4: {  // a few edges subdivided often: parallel chains
      Sketch sketch = random_cubic_sketch(even, random);
      sketch.subdivide(some_edge(sketch));
      for (std::uint32_t i = random.below(5); i > 0; --i)
        sketch.subdivide(sketch.edges().size() - 1);
      return sketch.graph();
    }
    case 5: {  // edges removed, free places filled
      Sketch sketch = random_cubic_sketch(even, random);
      const std::uint32_t cuts = 1 + random.below(n / 3 + 1);
      for (std::uint32_t i = 0; i < cuts && !sketch.edges().empty(); ++i)
        sketch.cut(some_edge(sketch));
      hang_leaves(sketch, random, random.below(101), random.below(30));
      return sketch.graph();
    }
    case 6: {  // a cycle with leaves
      Sketch sketch(std::max<Vertex>(3, n / 3));
      for (Vertex v = 0; v < sketch.size(); ++v) sketch.join(v, (v + 1) % sketch.size());
      hang_leaves(sketch, random, random.below(101), random.below(30));
      return sketch.graph();
    }
    default: {  // a union
      Sketch sketch = random_necklace(2, random);
      sketch.add_copy(random_cubic_sketch(4 + 2 * random.below(3), random));
      sketch.add_copy(Sketch(random_tree(std::max<Vertex>(1, n / 3), 3, random.next64())));
      hang_leaves(sketch, random, random.below(50), random.below(50));
      return sketch.graph();
    }
  }
}

}  // namespace ar3d::testing
