// Checks of single promises: edges, lattice, range, plane, bends, directions, distinct vertices,
// box. Edges are compared as sorted lists, because a file may list them in any order.
#include "ar3d/verify/checks/checks.h"

namespace ar3d::verify {

namespace {

using Ends = std::pair<Vertex, Vertex>;  // the smaller one first
Ends ends_of(Edge edge) { return std::minmax(edge.u, edge.v); }

/// Edges with their numbers in the list that they come from.
using NumberedEdges = std::vector<std::pair<Ends, EdgeId>>;

bool same_list(const Graph& graph, const Drawing& drawing) {
  if (graph.num_edges() != drawing.num_edges()) return false;
  for (EdgeId e = 0; e < graph.num_edges(); ++e) {
    if (ends_of(graph.edge(e)) != ends_of(drawing.edge(e))) return false;
  }
  return true;
}

/// Finds missing, extra and repeated edges by merging both sorted lists.
void merge(const NumberedEdges& wanted, const NumberedEdges& drawn, Findings& findings) {
  const auto add = [&](Ends ends, std::vector<EdgeId> ids, const std::string& message) {
    findings.add({ViolationKind::edge_set, {ends.first, ends.second}, std::move(ids), {}, message});
  };
  const auto add_missing = [&](Ends ends, EdgeId id) {
    add(ends, {},
        fmt::format("the graph's edge {} ({}-{}) is not drawn", id, ends.first, ends.second));
  };
  auto next = wanted.begin();
  for (std::size_t i = 0; i < drawn.size() && !findings.done(); ++i) {
    const auto& [ends, id] = drawn[i];
    for (; next != wanted.end() && next->first < ends; ++next) {
      add_missing(next->first, next->second);
    }
    if (i > 0 && drawn[i - 1].first == ends) {
      const EdgeId before = drawn[i - 1].second;
      add(ends, {before, id},
          fmt::format("edges {} and {} of the drawing both join {} and {}", before, id, ends.first,
                      ends.second));
    } else if (next != wanted.end() && next->first == ends) {
      ++next;
    } else {
      add(ends, {id},
          fmt::format("edge {} ({}-{}) of the drawing is not an edge of the graph", id, ends.first,
                      ends.second));
    }
  }
  for (; next != wanted.end() && !findings.done(); ++next) add_missing(next->first, next->second);
}

void check_edges(const Graph& graph, const Drawing& drawing, Findings& findings) {
  if (same_list(graph, drawing)) return;  // a Graph is simple: nothing can be drawn twice
  NumberedEdges wanted, drawn;
  for (EdgeId e = 0; e < graph.num_edges(); ++e) wanted.emplace_back(ends_of(graph.edge(e)), e);
  for (EdgeId e = 0; e < drawing.num_edges(); ++e) drawn.emplace_back(ends_of(drawing.edge(e)), e);
  std::sort(wanted.begin(), wanted.end());
  std::sort(drawn.begin(), drawn.end());
  merge(wanted, drawn, findings);
}

void check_lengths(const Drawing& drawing, EdgeId e, const std::vector<Point>& points,
                   Findings& findings) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i - 1] != points[i]) continue;
    findings.add(ViolationKind::degenerate_segment, {}, {e}, {points[i]}, "{} repeats the point {}",
                 describe_edge(drawing, e), to_string(points[i]));
  }
}

}  // namespace

void check_graph(const Graph& graph, const Drawing& drawing, Findings& findings) {
  if (graph.num_vertices() != drawing.num_vertices()) {
    findings.add(ViolationKind::vertex_count, {}, {}, {},
                 "the graph has {} vertices, the drawing {}", graph.num_vertices(),
                 drawing.num_vertices());
  }
  check_edges(graph, drawing, findings);
}

// Checks of single places: the lattice, the range of coordinates, the plane of the vertices, the
// box.

void check_lattice(const Drawing& drawing, const Guarantee& guarantee, Findings& findings) {
  const Lattice& drawn = drawing.lattice();
  const Lattice& promised = guarantee.lattice;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      // Products of two 32-bit numbers.
      const std::int64_t left = std::int64_t{drawn.gram[i][j]} * promised.gram_denominator;
      const std::int64_t right = std::int64_t{promised.gram[i][j]} * drawn.gram_denominator;
      if (left == right) continue;
      findings.add(ViolationKind::lattice, {}, {}, {},
                   "gram[{}][{}] is {}/{}, the guarantee speaks of {}/{}", i, j, drawn.gram[i][j],
                   drawn.gram_denominator, promised.gram[i][j], promised.gram_denominator);
      return;
    }
  }
}

void check_coordinates(const Drawing& drawing, Findings& findings) {
  for (std::size_t i = 0; i < drawing.num_vertices(); ++i) {
    const auto v = static_cast<Vertex>(i);
    const Point p = drawing.vertex(v);
    if (in_range(p)) continue;
    findings.add(ViolationKind::coordinate_range, {v}, {}, {p},
                 "vertex {} at {}: a coordinate passes 2^61", v, to_string(p));
  }
  for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& points) {
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      if (in_range(points[i])) continue;
      findings.add(ViolationKind::coordinate_range, {}, {e}, {points[i]},
                   "{}, bend {}: a coordinate passes 2^61", describe_edge(drawing, e),
                   to_string(points[i]));
    }
  });
}

void check_plane(const Drawing& drawing, const Guarantee& guarantee, Findings& findings) {
  if (!guarantee.vertices_in_plane) return;
  for (std::size_t i = 0; i < drawing.num_vertices() && !findings.done(); ++i) {
    const auto v = static_cast<Vertex>(i);
    const Point p = drawing.vertex(v);
    if (p.z == 0) continue;
    findings.add(ViolationKind::plane, {v}, {}, {p}, "vertex {} at {} is not in the plane z = 0", v,
                 to_string(p));
  }
}

void check_size(const Graph& graph, const Box& box, const Guarantee& guarantee,
                Findings& findings) {
  const std::uint64_t n = graph.num_vertices();
  if (n == 0) return;  // bounds speak of n >= 1, and an empty drawing has no extents
  const auto extents = box.extents();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const AxisBound& bound = guarantee.bound.axes[axis];
    if (bound.holds(extents[axis], n)) continue;
    findings.add(ViolationKind::size, {}, {}, {box.low, box.high},
                 "the extent in {} is {}, more than {} for n = {}", "xyz"[axis], extents[axis],
                 bound.formula(), n);
  }
}

void check_bends(const Drawing& drawing, const Guarantee& guarantee, Findings& findings) {
  for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& points) {
    if (findings.done()) return;
    check_lengths(drawing, e, points, findings);
    const std::size_t bends = points.size() - 2;
    if (bends <= guarantee.max_bends) return;
    findings.add(ViolationKind::bends, {}, {e}, {}, "{} has {} bends, at most {} are promised",
                 describe_edge(drawing, e), bends, guarantee.max_bends);
  });
}

void check_directions(const Segments& segments, const Guarantee& guarantee, Findings& findings) {
  const auto& allowed = guarantee.directions;
  if (allowed.empty()) return;
  for (SegmentId s = 0; s < segments.size() && !findings.done(); ++s) {
    const Vector d = segments.direction(s);
    if (std::any_of(allowed.begin(), allowed.end(), [&](Vector a) { return parallel(d, a); }))
      continue;
    findings.add(ViolationKind::direction, {}, {segments.edge(s)},
                 {segments.from(s), segments.to(s)},
                 "{} is parallel to {}, not an allowed direction", segments.describe(s),
                 to_string(primitive(d)));
  }
}

void check_distinct_vertices(const Drawing& drawing, Findings& findings) {
  std::vector<std::pair<Point, Vertex>> vertices;
  vertices.reserve(drawing.num_vertices());
  for (std::size_t i = 0; i < drawing.num_vertices(); ++i) {
    const auto v = static_cast<Vertex>(i);
    vertices.push_back({drawing.vertex(v), v});
  }
  std::sort(vertices.begin(), vertices.end());
  for (std::size_t i = 1; i < vertices.size() && !findings.done(); ++i) {
    const auto& [at, v] = vertices[i];
    if (vertices[i - 1].first != at) continue;
    const Vertex u = vertices[i - 1].second;
    findings.add(ViolationKind::same_point, {u, v}, {}, {at}, "vertices {} and {} are both at {}",
                 u, v, to_string(at));
  }
}

}  // namespace ar3d::verify
