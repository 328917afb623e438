// Small dense graphs, what is glued together from them, and their disjoint unions: each forces a
// special case of some drawer, as its comment in the header says.
#include <array>
#include <bit>

#include "ar3d/base/random.h"
#include "ar3d/generators/families.h"

namespace ar3d {

Graph copies_of(const Graph& part, Count copies) {
  GraphBuilder builder(0, copies * part.num_edges());
  for (Count i = 0; i < copies; ++i) builder.append(part);
  return builder.finish();
}

Graph complete_graph(Count n) {
  GraphBuilder builder(n);
  for (Count v = 1; v < n; ++v) {
    for (Count u = 0; u < v; ++u) builder.edge(u, v);
  }
  return builder.finish();
}

Graph complete_bipartite(Count a, Count b) {
  GraphBuilder builder(a + b);
  for (Count u = 0; u < a; ++u) {
    for (Count v = 0; v < b; ++v) builder.edge(u, a + v);
  }
  return builder.finish();
}

Graph octahedron_graph() {
  GraphBuilder builder(6);
  for (Count v = 1; v < 6; ++v) {
    for (Count u = 0; u < v; ++u) {
      if (u + v != 5) builder.edge(u, v);
    }
  }
  return builder.finish();
}

Graph odd_graph(unsigned k) {
  std::vector<std::uint32_t> sets;
  for (std::uint32_t set = 0; set < (1u << (2 * k - 1)); ++set) {
    if (std::popcount(set) + 1 == static_cast<int>(k)) sets.push_back(set);
  }
  GraphBuilder builder(sets.size());
  for (Count v = 1; v < sets.size(); ++v) {
    for (Count u = 0; u < v; ++u) {
      if ((sets[u] & sets[v]) == 0) builder.edge(u, v);
    }
  }
  return builder.finish();
}

namespace {

/// K4 without the edge between its vertices 0 and 3; returns the number of vertex 0.
Count add_diamond(GraphBuilder& builder) {
  const Count v = builder.add_vertices(4);
  builder.edges(std::array<Edge, 5>{{{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}}}, v);
  return v;
}

}  // namespace

Graph block_chain(Count links) {
  GraphBuilder builder(0, 6 * links + 15);
  Count open = builder.append(leaf_block(5));
  for (Count i = 0; i < links; ++i) {
    const Count diamond = add_diamond(builder);
    builder.edge(open, diamond);
    open = diamond + 3;
  }
  const Count last = builder.append(leaf_block(5));
  builder.edge(open, last);
  return builder.finish();
}

Graph diamond_necklace(Count k) {
  GraphBuilder builder(0, 6 * k);
  for (Count i = 0; i < k; ++i) {
    const Count diamond = add_diamond(builder);
    if (i > 0) builder.edge(diamond - 1, diamond);
  }
  builder.edge(4 * k - 1, 0);
  return builder.finish();
}

Graph random_cactus(Count cycles, Count length, std::uint64_t seed) {
  RandomStream random(seed, /*stream=*/20);
  GraphBuilder builder(length, cycles * length);
  builder.cycle(0, length);
  std::vector<Count> single;  // vertices on exactly one cycle
  for (Count v = 0; v < length; ++v) single.push_back(v);
  for (Count i = 1; i < cycles; ++i) {
    std::swap(single[random.below(static_cast<std::uint32_t>(single.size()))], single.back());
    const Count joint = single.back();
    single.pop_back();
    const Count first = builder.add_vertices(length - 1);
    builder.path(first, length - 1);
    builder.edge(joint, first);
    builder.edge(joint, first + length - 2);
    for (Count v = first; v < builder.num_vertices(); ++v) single.push_back(v);
  }
  return builder.finish();
}

Graph contained_cycles(Count k) {
  const Count half = 3 * k;  // the long cycle is 0, half, 1, half + 1, ...
  GraphBuilder builder(2 * half, 4 * half);
  for (Count first = 0; first < 2 * half; first += 3) builder.cycle(first, 3);
  for (Count i = 0; i < half; ++i) {
    builder.edge(i, half + i);
    builder.edge(half + i, (i + 1) % half);
  }
  return builder.finish();
}

Graph mixed_union(Count k) {
  const std::vector<Graph> parts = {
      complete_graph(3), complete_graph(4),          block_chain(0) /* 10 vertices */,
      prism(3),          generalised_petersen(5, 2), cycle_graph(3)};
  GraphBuilder builder(0, 54 * k);
  for (Count i = 0; i < k; ++i) {
    for (const Graph& part : parts) builder.append(part);
  }
  return builder.finish();
}

}  // namespace ar3d
