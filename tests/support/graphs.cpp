#include "support/graphs.h"

#include <cstdio>
#include <memory>
#include <numeric>
#include <stdexcept>

#include "ar3d/base/random.h"
#include "ar3d/generators/families.h"

namespace ar3d::testing {

Graph path(Vertex n) { return path_graph(n); }
Graph cycle(Vertex n) { return cycle_graph(n); }
Graph complete(Vertex n) { return complete_graph(n); }
Graph petersen() { return generalised_petersen(5, 2); }
Graph octahedron() { return octahedron_graph(); }
Graph squared_cycle(Vertex n) { return ar3d::squared_cycle(n); }

Graph disjoint_union(const std::vector<Graph>& parts) {
  GraphBuilder builder(0);
  for (const Graph& part : parts) builder.append(part);
  return builder.finish();
}

Graph shuffled(const Graph& graph, std::uint64_t seed) {
  RandomStream random(seed, 1);
  std::vector<Vertex> name(graph.num_vertices());
  std::iota(name.begin(), name.end(), 0u);
  random.shuffle(std::span<Vertex>(name));
  std::vector<Edge> edges;
  for (const Edge e : graph.edges()) {
    edges.push_back(random.chance(1, 2) ? Edge{name[e.u], name[e.v]} : Edge{name[e.v], name[e.u]});
  }
  random.shuffle(std::span<Edge>(edges));
  return Graph(graph.num_vertices(), std::move(edges));
}

std::vector<Graph> geng(const std::string& arguments) {
  const std::string command = "nauty-geng -q " + arguments;
  std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  if (!pipe) throw std::runtime_error("cannot run " + command);
  std::vector<Graph> graphs;
  char line[4096];
  while (std::fgets(line, sizeof line, pipe.get())) {
    const int n = line[0] - 63;  // geng's graphs have at most 62 vertices
    std::vector<Edge> edges;
    int bit = 0;
    for (int v = 1; v < n; ++v) {
      for (int u = 0; u < v; ++u, ++bit) {
        if (((line[1 + bit / 6] - 63) >> (5 - bit % 6)) & 1) {
          edges.push_back({static_cast<Vertex>(u), static_cast<Vertex>(v)});
        }
      }
    }
    graphs.emplace_back(static_cast<std::uint64_t>(n), std::move(edges));
  }
  if (pclose(pipe.release()) != 0) {
    throw std::runtime_error(command + " failed, so its list may be cut; is nauty installed?");
  }
  if (graphs.empty()) throw std::runtime_error(command + " printed nothing");
  return graphs;
}

}  // namespace ar3d::testing
