#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <tuple>
#include <vector>

#include "ar3d/verify/checks/checks.h"

namespace ar3d::verify {
namespace {

/// An edge with its smaller end first and its number in the list that it comes from.
struct Named {
  Vertex low;
  Vertex high;
  EdgeId id;
  std::pair<Vertex, Vertex> ends() const { return {low, high}; }
};

Named named(Edge edge, EdgeId id) {
  return {std::min(edge.u, edge.v), std::max(edge.u, edge.v), id};
}

void sort_by_ends(std::vector<Named>& edges) {
  std::sort(edges.begin(), edges.end(), [](const Named& a, const Named& b) {
    return std::tie(a.low, a.high, a.id) < std::tie(b.low, b.high, b.id);
  });
}

bool same_list(const Graph& graph, const Drawing& drawing) {
  if (graph.num_edges() != drawing.num_edges()) return false;
  for (EdgeId e = 0; e < graph.num_edges(); ++e) {
    if (named(graph.edge(e), e).ends() != named(drawing.edge(e), e).ends()) return false;
  }
  return true;
}

void add_missing(const Named& edge, Findings& findings) {
  findings.add(
      {ViolationKind::edge_set,
       {edge.low, edge.high},
       {},
       {},
       fmt::format("the graph's edge {} ({}-{}) is not drawn", edge.id, edge.low, edge.high)});
}

void add_extra(const Named& edge, Findings& findings) {
  findings.add({ViolationKind::edge_set,
                {edge.low, edge.high},
                {edge.id},
                {},
                fmt::format("edge {} ({}-{}) of the drawing is not an edge of the graph", edge.id,
                            edge.low, edge.high)});
}

void add_repeated(const Named& edge, EdgeId first, Findings& findings) {
  findings.add({ViolationKind::edge_set,
                {edge.low, edge.high},
                {first, edge.id},
                {},
                fmt::format("edges {} and {} of the drawing both join {} and {}", first, edge.id,
                            edge.low, edge.high)});
}

/// Both lists sorted: a merge tells missing, extra and repeated edges apart.
void merge(const std::vector<Named>& wanted, const std::vector<Named>& drawn, Findings& findings) {
  std::size_t next = 0;
  for (std::size_t i = 0; i < drawn.size() && !findings.done(); ++i) {
    while (next < wanted.size() && wanted[next].ends() < drawn[i].ends()) {
      add_missing(wanted[next++], findings);
    }
    if (i > 0 && drawn[i - 1].ends() == drawn[i].ends()) {
      add_repeated(drawn[i], drawn[i - 1].id, findings);
    } else if (next < wanted.size() && wanted[next].ends() == drawn[i].ends()) {
      ++next;
    } else {
      add_extra(drawn[i], findings);
    }
  }
  while (next < wanted.size() && !findings.done()) add_missing(wanted[next++], findings);
}

void check_edges(const Graph& graph, const Drawing& drawing, Findings& findings) {
  if (same_list(graph, drawing)) return;  // a Graph is simple: nothing can be drawn twice
  std::vector<Named> wanted;
  std::vector<Named> drawn;
  for (EdgeId e = 0; e < graph.num_edges(); ++e) wanted.push_back(named(graph.edge(e), e));
  for (EdgeId e = 0; e < drawing.num_edges(); ++e) drawn.push_back(named(drawing.edge(e), e));
  sort_by_ends(wanted);
  sort_by_ends(drawn);
  merge(wanted, drawn, findings);
}

}  // namespace

void check_graph(const Graph& graph, const Drawing& drawing, Findings& findings) {
  if (graph.num_vertices() != drawing.num_vertices()) {
    findings.add({ViolationKind::vertex_count,
                  {},
                  {},
                  {},
                  fmt::format("the graph has {} vertices, the drawing {}", graph.num_vertices(),
                              drawing.num_vertices())});
  }
  check_edges(graph, drawing, findings);
}

}  // namespace ar3d::verify
