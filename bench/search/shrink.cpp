#include "ar3d/bench/search/shrink.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace ar3d {
namespace {

/// The graph on the vertices with keep[v], renamed in order.
Graph induced(const Graph& graph, const std::vector<bool>& keep) {
  std::vector<Vertex> name(graph.num_vertices());
  Vertex count = 0;
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    if (keep[v]) name[v] = count++;
  }
  std::vector<Edge> edges;
  for (const Edge edge : graph.edges()) {
    if (keep[edge.u] && keep[edge.v]) edges.push_back({name[edge.u], name[edge.v]});
  }
  return Graph(count, std::move(edges));
}

Graph without_components(const Graph& graph, std::size_t first, std::size_t last) {
  const Components components = connected_components_of(graph);
  std::vector<bool> keep(graph.num_vertices());
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    keep[v] = components.of[v] < first || components.of[v] >= last;
  }
  return induced(graph, keep);
}

Graph without_vertices(const Graph& graph, std::size_t first, std::size_t last) {
  std::vector<bool> keep(graph.num_vertices(), true);
  for (std::size_t v = first; v < last; ++v) keep[v] = false;
  return induced(graph, keep);
}

Graph without_edges(const Graph& graph, std::size_t first, std::size_t last) {
  std::vector<Edge> edges(graph.edges().begin(), graph.edges().end());
  edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(first),
              edges.begin() + static_cast<std::ptrdiff_t>(last));
  return Graph(graph.num_vertices(), std::move(edges));
}

/// One kind of part that can be removed.
struct Parts {
  std::size_t (*count)(const Graph&);
  Graph (*without)(const Graph&, std::size_t first, std::size_t last);
};

const std::vector<Parts>& kinds_of_parts() {
  static const std::vector<Parts> kinds = {
      {[](const Graph& g) { return std::size_t{connected_components_of(g).count}; },
       without_components},
      {[](const Graph& g) { return std::size_t{g.num_vertices()}; }, without_vertices},
      {[](const Graph& g) { return std::size_t{g.num_edges()}; }, without_edges}};
  return kinds;
}

class Shrinker {
 public:
  Shrinker(const Graph& graph, const std::function<bool(const Graph&)>& keeps,
           std::uint64_t max_evaluations)
      : keeps_(keeps), max_evaluations_(max_evaluations) {
    result_.graph = graph;
  }

  ShrinkResult run() {
    bool has_shrunk = true;
    while (has_shrunk && has_budget()) {
      has_shrunk = false;
      for (const Parts& parts : kinds_of_parts()) has_shrunk |= remove_chunks(parts);
    }
    result_.minimal = !has_shrunk;
    return std::move(result_);
  }

 private:
  bool has_budget() const { return result_.evaluations < max_evaluations_; }

  /// Chunks of half of the parts, then a quarter, … then single ones until none can go.
  bool remove_chunks(const Parts& parts) {
    bool has_shrunk = false;
    std::size_t chunk = std::max<std::size_t>(1, parts.count(result_.graph) / 2);
    while (true) {
      const bool removed = remove_once(parts, chunk);
      has_shrunk |= removed;
      if (chunk == 1 && !removed) return has_shrunk;
      if (!has_budget()) return true;
      if (!removed || chunk > parts.count(result_.graph))
        chunk = std::max<std::size_t>(1, chunk / 2);
    }
  }

  /// One pass over all chunks of that size, from the end, so that the places of the others stay.
  bool remove_once(const Parts& parts, std::size_t chunk) {
    bool removed = false;
    std::size_t last = parts.count(result_.graph);
    while (last > 0 && has_budget()) {
      const std::size_t first = last > chunk ? last - chunk : 0;
      Graph candidate = parts.without(result_.graph, first, last);
      ++result_.evaluations;
      if (keeps_(candidate)) {
        result_.graph = std::move(candidate);
        removed = true;
      }
      last = std::min(first, parts.count(result_.graph));
    }
    return removed;
  }

  const std::function<bool(const Graph&)>& keeps_;
  std::uint64_t max_evaluations_;
  ShrinkResult result_;
};

}  // namespace

ShrinkResult shrink(const Graph& graph, const std::function<bool(const Graph&)>& keeps,
                    std::uint64_t max_evaluations) {
  return Shrinker(graph, keeps, max_evaluations).run();
}

}  // namespace ar3d
