// Step E.4: each vertex takes the first point of its square where nothing new meets anything,
// tested exactly. Lemma E.5 counts how few points are closed, so at the scale
// LayoutScale::always_enough() a point is always free, and a smaller square fails by an answer,
// never by a wrong drawing. Cost: O(n) for a point tried.
#include "ar3d/algorithms/two_bend_109/placement.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "ar3d/algorithms/two_bend_109/drawn_segments.h"
#include "ar3d/algorithms/two_bend_109/small_bodies.h"
#include "ar3d/algorithms/two_bend_109/stubs.h"
#include "ar3d/base/error.h"
#include "ar3d/base/random.h"

namespace ar3d::two_bend_109 {
namespace {

/// Whether an edge that leaves its vertex along `stub` may go on along `ahead`.
bool may_turn(Vector stub, Vector ahead) {
  const auto dot = [](Vector a, Vector b) {
    return 2 * static_cast<double>(a.x) * static_cast<double>(b.x) +
           6 * static_cast<double>(a.y) * static_cast<double>(b.y) +
           static_cast<double>(a.z) * static_cast<double>(b.z);
  };
  const double cosine = dot(stub, ahead) / std::sqrt(dot(stub, stub) * dot(ahead, ahead));
  constexpr double kDoubt = 1e-12;
  if (std::abs(cosine - 1.0 / 3) > kDoubt) return cosine > 1.0 / 3;
  return compare_cosine(kAxisLattice, -stub, ahead, {-1, 3}) <= 0;
}

/// An edge to be drawn from a placed vertex upwards.
struct NewEdge {
  Vertex below;
  std::uint8_t port_below;  ///< which of its stubs it takes there
  Vector stub;              ///< that stub
  Point from;               ///< the bend at its end
  std::uint8_t port;        ///< which stub of the new vertex it takes
};

class VertexPlacer {
 public:
  VertexPlacer(const Graph& graph, const std::vector<VertexPart>& parts,
               const SlotArrangement& arrangement, const Layout& layout, std::uint64_t seed,
               bool is_filtered)
      : graph_(graph),
        parts_(parts),
        arrangement_(arrangement),
        layout_(layout),
        seed_(seed),
        drawn_(is_filtered),
        drawn_at_(graph.num_vertices()),
        is_placed_(graph.num_vertices()),
        legs_(parts.size()) {
    made_.at.resize(graph.num_vertices());
    made_.ends.resize(graph.num_vertices());
  }

  std::optional<Placement> run() {
    for (const Vertex v : layout_.order) {
      if (!place_vertex(v)) return std::nullopt;
    }
    for (const VertexPart& part : parts_) {
      if (part.kind == PartKind::body && !place_body(part)) return std::nullopt;
    }
    return std::move(made_);
  }

 private:
  /// Calls fits(offset) for the points of a square until it is true.
  template <class Fits>
  bool choose(Vertex v, std::int64_t points_a_side, Fits&& fits) {
    const auto side = static_cast<std::uint64_t>(points_a_side);
    expect(side < std::uint64_t{1} << 31, "the square's points are counted in 64 bits");
    const std::uint64_t count = side * side;
    RandomStream random(seed_, v);
    std::uint64_t chosen = random.next64() % count;
    std::uint64_t step = (random.next64() | 1) % count;
    while (std::gcd(step, side) != 1) ++step;  // so that every point is visited
    for (std::uint64_t i = 0; i < count; ++i, chosen = (chosen + step) % count) {
      ++made_.tried;
      if (fits(Vector{static_cast<std::int64_t>(chosen / side),
                      static_cast<std::int64_t>(chosen % side), 0})) {
        return true;
      }
    }
    return false;
  }

  std::size_t index_of(Vertex v, Vertex to) const {
    const auto incident = graph_.incident(v);
    std::size_t i = 0;
    while (incident[i].to != to) ++i;
    return i;
  }

  Vector stub(Vertex v, std::size_t i) const {
    return arrangement_.stubs[v].ends[arrangement_.port[v][i]];
  }

  std::vector<NewEdge> edges_down(Vertex v) const {
    std::vector<NewEdge> edges;
    const auto incident = graph_.incident(v);
    for (std::size_t i = 0; i < incident.size(); ++i) {
      const Vertex w = incident[i].to;
      if (!is_placed_[w] || arrangement_.part[w] > arrangement_.part[v]) continue;
      const std::size_t j = index_of(w, v);
      edges.push_back(
          {w, arrangement_.port[w][j], stub(w, j), made_.ends[w][j], arrangement_.port[v][i]});
    }
    return edges;
  }

  bool place_vertex(Vertex v) {
    const std::vector<NewEdge> edges = edges_down(v);
    if (!choose(v, layout_.scale.jitter,
                [&](Vector offset) { return fits(v, layout_.place[v] + offset, edges); })) {
      return false;
    }
    commit(v, edges);
    return true;
  }

  /// Sets the place of v and its ends, and says whether it may stay there.
  bool fits(Vertex v, Point at, const std::vector<NewEdge>& edges) {
    made_.at[v] = at;
    for (std::size_t i = 0; i < graph_.degree(v); ++i) made_.ends[v][i] = at + stub(v, i);
    const std::array<Vector, 4>& stubs = arrangement_.stubs[v].ends;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const NewEdge& edge = edges[i];
      const LatticeSegment line{edge.from, at + stubs[edge.port]};
      expect(may_turn(edge.stub, line.to - line.from) &&
                 may_turn(stubs[edge.port], line.from - line.to),
             "slots and heights keep all turns small");
      for (std::uint8_t other = 0; other < 4; ++other) {
        if (other != edge.port && meet(line, {at, at + stubs[other]})) return false;
      }
      for (std::size_t j = 0; j < i; ++j) {
        if (meet(line, {edges[j].from, at + stubs[edges[j].port]})) return false;
      }
      if (meets_drawn(line, edge)) return false;
    }
    return keeps_legs_apart(v);
  }

  /// All that was drawn before the lower end of the edge lies lower.
  bool meets_drawn(const LatticeSegment& line, const NewEdge& edge) const {
    return drawn_.meets_any(line, drawn_at_[edge.below], edge.port_below);
  }

  /// No two edges to one body are the diagonals of a trapezium wherever the body stands.
  bool keeps_legs_apart(Vertex v) const {
    const auto incident = graph_.incident(v);
    for (std::size_t i = 0; i < incident.size(); ++i) {
      const std::optional<Point> end = leg_end(incident[i].to);
      if (!end) continue;
      for (const LatticeSegment& other : legs_[arrangement_.part[incident[i].to]]) {
        if (are_parallel(made_.ends[v][i] - other.from, *end - other.to)) return false;
      }
    }
    return true;
  }

  /// In the body's own coordinates, if w is in a body.
  std::optional<Point> leg_end(Vertex w) const {
    const VertexPart& part = parts_[arrangement_.part[w]];
    if (part.kind != PartKind::body) return std::nullopt;
    for (const SmallBody::BodyLeg& leg : part.body->legs) {
      if (part.vertices[leg.v] == w) return leg.end;
    }
    throw InternalError("internal error: a vertex of a body with an edge down has a leg");
  }

  void commit(Vertex v, const std::vector<NewEdge>& edges) {
    is_placed_[v] = true;
    drawn_at_[v] = drawn_.size();
    const std::array<Vector, 4>& stubs = arrangement_.stubs[v].ends;
    drawn_.add_star({made_.at[v], stubs});
    for (const NewEdge& edge : edges) drawn_.add_line({edge.from, made_.at[v] + stubs[edge.port]});
    const auto incident = graph_.incident(v);
    for (std::size_t i = 0; i < incident.size(); ++i) {
      const std::optional<Point> end = leg_end(incident[i].to);
      if (end) legs_[arrangement_.part[incident[i].to]].push_back({made_.ends[v][i], *end});
    }
  }

  bool place_body(const VertexPart& part) {
    std::vector<NewEdge> edges;  // port: the leg
    const std::vector<SmallBody::BodyLeg>& legs = part.body->legs;
    for (std::size_t leg = 0; leg < legs.size(); ++leg) {
      for (NewEdge edge : edges_down(part.vertices[legs[leg].v])) {
        edge.port = static_cast<std::uint8_t>(leg);
        edges.push_back(edge);
      }
    }
    const Point origin = layout_.place[part.vertices[0]] + -as_vector(part.body->vertices[0]);
    Vector chosen;
    if (!choose(part.vertices[0], layout_.scale.body_jitter, [&](Vector offset) {
          chosen = offset;
          return body_fits(part, origin + offset, edges);
        })) {
      return false;
    }
    commit_body(part, origin + chosen, edges);
    return true;
  }

  static Vector as_vector(Point p) { return {p.x, p.y, p.z}; }

  static std::vector<LatticeSegment> segments_of(const SmallBody& body, Point origin,
                                                 const std::vector<NewEdge>& edges) {
    const auto at = [&](Point p) { return origin + as_vector(p); };
    std::vector<LatticeSegment> segments;
    for (const NewEdge& edge : edges) {  // first, in the order of the edges
      const SmallBody::BodyLeg& leg = body.legs[edge.port];
      segments.push_back({at(body.vertices[leg.v]), at(leg.end)});
    }
    for (const SmallBody::BodyLink& link : body.links) {
      segments.push_back({at(body.vertices[link.u]), at(link.bend_at_u)});
      segments.push_back({at(link.bend_at_u), at(link.bend_at_v)});
      segments.push_back({at(link.bend_at_v), at(body.vertices[link.v])});
    }
    return segments;
  }

  bool body_fits(const VertexPart& part, Point origin, const std::vector<NewEdge>& edges) const {
    const std::vector<LatticeSegment> own = segments_of(*part.body, origin, edges);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const LatticeSegment line{edges[i].from, own[i].to};
      expect(may_turn(edges[i].stub, line.to - line.from) &&
                 may_turn(own[i].to - own[i].from, line.from - line.to),
             "the height of a body keeps all turns small");
      for (std::size_t j = 0; j < own.size(); ++j) {
        if (j != i && meet(line, own[j])) return false;
      }
      for (std::size_t j = 0; j < i; ++j) {
        if (meet(line, {edges[j].from, own[j].to})) return false;
      }
      if (meets_drawn(line, edges[i])) return false;
    }
    return true;
  }

  void commit_body(const VertexPart& part, Point origin, const std::vector<NewEdge>& edges) {
    const SmallBody& body = *part.body;
    const std::vector<LatticeSegment> own = segments_of(body, origin, edges);
    for (const LatticeSegment& segment : own) drawn_.add_line(segment);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      drawn_.add_line({edges[i].from, own[i].to});
      const Vertex v = part.vertices[body.legs[edges[i].port].v];
      made_.ends[v][index_of(v, edges[i].below)] = own[i].to;
    }
    for (std::size_t i = 0; i < part.vertices.size(); ++i) {
      made_.at[part.vertices[i]] = origin + as_vector(body.vertices[i]);
    }
    for (const SmallBody::BodyLink& link : body.links) {
      const Vertex u = part.vertices[link.u];
      const Vertex v = part.vertices[link.v];
      made_.ends[u][index_of(u, v)] = origin + as_vector(link.bend_at_u);
      made_.ends[v][index_of(v, u)] = origin + as_vector(link.bend_at_v);
    }
  }

  const Graph& graph_;
  const std::vector<VertexPart>& parts_;
  const SlotArrangement& arrangement_;
  const Layout& layout_;
  std::uint64_t seed_;
  Placement made_;
  DrawnSegments drawn_;
  std::vector<DrawnCount> drawn_at_;  ///< of each placed vertex: what was drawn before it
  std::vector<bool> is_placed_;       ///< vertices that are not in bodies
  /// Of each body: the bend that will be joined to it and the end of its leg, in the body's
  /// coordinates, for those whose lower vertex is placed.
  std::vector<std::vector<LatticeSegment>> legs_;
};

}  // namespace

std::optional<Placement> place(const Graph& graph, const std::vector<VertexPart>& parts,
                               const SlotArrangement& arrangement, const Layout& layout,
                               std::uint64_t seed, bool is_filtered) {
  return VertexPlacer(graph, parts, arrangement, layout, seed, is_filtered).run();
}

}  // namespace ar3d::two_bend_109
