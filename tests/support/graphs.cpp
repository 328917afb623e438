#include "support/graphs.h"

#include <cstdio>
#include <memory>
#include <numeric>
#include <stdexcept>

#include "ar3d/base/random.h"

namespace ar3d::testing {

Graph path(Vertex n) {
  std::vector<Edge> edges;
  for (Vertex v = 1; v < n; ++v) edges.push_back({v - 1, v});
  return Graph(n, std::move(edges));
}

Graph cycle(Vertex n) {
  std::vector<Edge> edges;
  for (Vertex v = 0; v < n; ++v) edges.push_back({v, (v + 1) % n});
  return Graph(n, std::move(edges));
}

Graph complete(Vertex n) {
  std::vector<Edge> edges;
  for (Vertex v = 0; v < n; ++v) {
    for (Vertex u = 0; u < v; ++u) edges.push_back({u, v});
  }
  return Graph(n, std::move(edges));
}

Graph petersen() {
  std::vector<Edge> edges;
  for (Vertex v = 0; v < 5; ++v) {
    edges.push_back({v, (v + 1) % 5});          // outer cycle
    edges.push_back({v, v + 5});                // spokes
    edges.push_back({v + 5, (v + 2) % 5 + 5});  // inner pentagram
  }
  return Graph(10, std::move(edges));
}

Graph octahedron() {
  std::vector<Edge> edges;
  for (Vertex v = 0; v < 6; ++v) {
    for (Vertex u = 0; u < v; ++u) {
      if (u + v != 5) edges.push_back({u, v});  // opposite corners sum to 5
    }
  }
  return Graph(6, std::move(edges));
}

Graph disjoint_union(const std::vector<Graph>& parts) {
  std::vector<Edge> edges;
  Vertex n = 0;
  for (const Graph& part : parts) {
    for (const Edge e : part.edges()) edges.push_back({e.u + n, e.v + n});
    n += part.num_vertices();
  }
  return Graph(n, std::move(edges));
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

Graph squared_cycle(Vertex n) {
  std::vector<Edge> edges;
  for (Vertex v = 0; v < n; ++v) {
    edges.push_back({v, (v + 1) % n});
    edges.push_back({v, (v + 2) % n});
  }
  return Graph(n, std::move(edges));
}

}  // namespace ar3d::testing
