// Step E.4: all take the first points at which what is drawn with them does not meet itself and no
// middle is flat. Then everything is compared; an edge that meets an older one takes its next
// point, and so on until nothing meets. Lemma E.5 counts how few points are closed, so at the scale
// LayoutScale::always_enough() this ends, and a smaller square fails by an answer, never by a wrong
// drawing. Cost: O(n) and owners_that_meet(), once in most drawings.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "ar3d/algorithms/two_bend_109/layout.h"
#include "ar3d/base/error.h"
#include "ar3d/base/random.h"

namespace ar3d::two_bend_109 {
namespace {

/// True if an edge that leaves its vertex along `stub` may go on along `ahead`.
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

/// The points of a square in a fixed pseudo-random order, round and round.
class SquareWalk {
 public:
  SquareWalk(std::uint64_t seed, Vertex v, std::int64_t points_a_side)
      : side_(static_cast<std::uint64_t>(points_a_side)) {
    expect(side_ < std::uint64_t{1} << 31, "the square's points are counted in 64 bits");
    RandomStream random(seed, v);
    at_ = random.next64() % count();
    step_ = (random.next64() | 1) % count();
    while (std::gcd(step_, side_) != 1) ++step_;  // so that every point is visited
  }
  std::uint64_t count() const { return side_ * side_; }
  std::uint64_t tried() const { return tried_; }
  Vector offset() const {
    return {static_cast<std::int64_t>(at_ / side_), static_cast<std::int64_t>(at_ % side_), 0};
  }
  void go_on() {
    at_ = (at_ + step_) % count();
    ++tried_;
  }

 private:
  std::uint64_t side_, at_, step_, tried_ = 1;
};

class VertexPlacer {
 public:
  VertexPlacer(const OrderedGraph& graph, std::span<const VertexPart> parts,
               const SlotArrangement& arrangement, const Layout& layout, Placement& made)
      : graph_(graph),
        parts_(parts),
        arrangement_(arrangement),
        layout_(layout),
        made_(made),
        first_vertex_(parts.front().vertices.front()),
        num_vertices_(parts.back().vertices.back() + 1 - first_vertex_),
        first_part_(arrangement.part[first_vertex_]),
        first_body_(parts.size()) {}

  bool run(std::uint64_t seed, MeetingSearch& find) {
    walks_.reserve(num_vertices_);
    for (const VertexPart& part : parts_) {
      const bool is_body = part.kind == PartKind::body;
      if (is_body) --first_body_;
      for (const Vertex v : owners_of(part)) {
        walks_.emplace_back(seed, graph_.numbers[v],
                            is_body ? layout_.scale.body_jitter : layout_.scale.jitter);
      }
    }
    // Those before the first that goes on never move again; so that one meets nothing older at the
    // latest when it has gone through its whole square, if a point is free there.
    const bool is_endless = layout_.scale == LayoutScale::always_enough(num_vertices_);
    for (DrawnSegments before; place_all(); before = std::exchange(drawn_, {})) {
      const std::vector<std::uint32_t> owners = find(drawn_, before);
      for (const std::uint32_t owner : owners) walks_[owner].go_on();
      const bool ends = std::any_of(owners.begin(), owners.end(), [&](std::uint32_t owner) {
        return walks_[owner].tried() > walks_[owner].count();
      });
      if (ends && !is_endless) return false;
      if (!owners.empty()) continue;
      for (const SquareWalk& walk : walks_) made_.tried += static_cast<std::int64_t>(walk.tried());
      return true;
    }
    return false;
  }

 private:
  /// All of its vertices, of a body the first one.
  static std::span<const Vertex> owners_of(const VertexPart& part) {
    return {part.vertices.data(), part.kind == PartKind::body ? 1 : part.vertices.size()};
  }

  /// True if each finds a point.
  bool place_all() {
    legs_.assign(parts_.size() - first_body_, {});
    const std::size_t most = std::size_t{2} * num_vertices_;
    drawn_.middles.reserve(std::min<std::size_t>(graph_.half_edges.size() / 2, most));
    drawn_.stubs.reserve(2 * most);
    owner_ = 0;
    for (const VertexPart& part : parts_) {
      for (const Vertex v : owners_of(part)) {
        if (!(part.kind == PartKind::body ? place_body(part) : place_vertex(v))) return false;
        ++owner_;
      }
    }
    return true;
  }

  /// Goes on until fits(offset) for a point of the square.
  template <class Fits>
  bool choose(Fits&& fits) {
    SquareWalk& walk = walks_[owner_];
    for (std::uint64_t i = 0; i < walk.count(); ++i, walk.go_on()) {
      if (fits(walk.offset())) return true;
    }
    return false;
  }

  std::size_t index_of(Vertex v, Vertex to) const {
    const auto incident = graph_.incident(v);
    std::size_t i = 0;
    while (incident[i].to != to) ++i;
    return i;
  }

  /// The stub of v that ends at the bend.
  Vector stub(Vertex v, EdgeId bend) const {
    return stubs_by_number(arrangement_.stubs[v]).ends[arrangement_.port[bend]];
  }

  /// Adds those to vertices below `first`.
  void add_edges_down(Vertex v, Vertex first, std::vector<NewEdge>& edges) const {
    for (const auto [w, bend] : graph_.incident(v)) {
      if (w >= first) continue;
      const Vector stub_below = stub(w, bend ^ 1);
      edges.push_back({w, arrangement_.port[bend ^ 1], stub_below, made_.at[w] + stub_below,
                       arrangement_.port[bend]});
    }
  }

  bool place_vertex(Vertex v) {
    graph_.prefetch_neighbours(v + kAhead, made_.at.data());
    edges_.clear();
    add_edges_down(v, v, edges_);
    if (!choose([&](Vector offset) { return fits(v, layout_.position[v] + offset, edges_); })) {
      return false;
    }
    commit(v, edges_);
    return true;
  }

  /// Sets the place of v and its ends, and says whether it may stay there.
  bool fits(Vertex v, Point at, const std::vector<NewEdge>& edges) {
    made_.at[v] = at;
    const auto incident = graph_.incident(v);
    for (std::size_t i = 0; i < incident.size(); ++i) {
      made_.ends[v][i] = at + stub(v, incident[i].edge);
    }
    std::array<std::uint8_t, 4> ports = {0, 1, 2, 3};  // first those of the edges
    for (std::size_t i = 0; i < edges.size(); ++i) {
      std::swap(ports[i], *std::find(ports.begin(), ports.end(), edges[i].port));
    }
    const std::array<Vector, 4>& stubs = stubs_by_number(arrangement_.stubs[v]).ends;
    std::array<LatticeSegment, 4> own;
    for (std::size_t i = 0; i < 4; ++i) own[i] = {at, at + stubs[ports[i]]};
    return middles_fit(edges, own) && keeps_legs_apart(v);
  }

  /// The i-th edge ends with the i-th of the segments of its own upper end. A flat middle is
  /// refused: it would meet other flat ones often, and without them almost nothing meets.
  static bool middles_fit(const std::vector<NewEdge>& edges, std::span<const LatticeSegment> own) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const LatticeSegment line{edges[i].from, own[i].to};
      if (line.from.y == line.to.y) return false;
      expect(may_turn(edges[i].stub, line.to - line.from) &&
                 may_turn(own[i].to - own[i].from, line.from - line.to),
             "slots and heights keep all turns small");
      for (std::size_t j = 0; j < own.size(); ++j) {
        if (j != i && meet(line, own[j])) return false;
      }
      for (std::size_t j = 0; j < i; ++j) {
        if (meet(line, {edges[j].from, own[j].to})) return false;
      }
    }
    return true;
  }

  /// No two edges to one body are the diagonals of a trapezium wherever the body stands.
  bool keeps_legs_apart(Vertex v) {
    const auto incident = graph_.incident(v);
    for (std::size_t i = 0; i < incident.size(); ++i) {
      const std::optional<Point> end = leg_end(incident[i].to);
      if (!end) continue;
      for (const LatticeSegment& other : legs_to(incident[i].to)) {
        if (are_parallel(made_.ends[v][i] - other.from, *end - other.to)) return false;
      }
    }
    return true;
  }

  /// In the body's own coordinates, if w is in a body.
  std::optional<Point> leg_end(Vertex w) const {
    if (legs_.empty() || arrangement_.part[w] - first_part_ < first_body_) return std::nullopt;
    const VertexPart& part = parts_[arrangement_.part[w] - first_part_];
    for (const auto& [v, end] : part.body->legs) {
      if (part.vertices[v] == w) return end;
    }
    throw InternalError("internal error: a vertex of a body with an edge down has a leg");
  }

  std::vector<LatticeSegment>& legs_to(Vertex w) {
    return legs_[arrangement_.part[w] - first_part_ - first_body_];
  }

  void commit(Vertex v, const std::vector<NewEdge>& edges) {
    const std::array<Vector, 4>& stubs = stubs_by_number(arrangement_.stubs[v]).ends;
    for (const Vector stub : stubs) add_stub({made_.at[v], made_.at[v] + stub});
    for (const NewEdge& edge : edges) add_middle(edge, made_.at[v] + stubs[edge.port]);
    const auto incident = graph_.incident(v);
    for (std::size_t i = 0; i < incident.size(); ++i) {
      const std::optional<Point> end = leg_end(incident[i].to);
      if (end) legs_to(incident[i].to).push_back({made_.ends[v][i], *end});
    }
  }

  void add_stub(const LatticeSegment& s) {
    drawn_.stubs.push_back({s.from.z <= s.to.z ? s : LatticeSegment{s.to, s.from}, owner_, 0});
  }

  void add_middle(const NewEdge& edge, Point to) {
    const std::uint32_t below = edge.below - first_vertex_;
    drawn_.middles.push_back({{edge.from, to}, owner_, 4 * below + edge.port_below});
  }

  bool place_body(const VertexPart& part) {
    std::vector<NewEdge> edges;  // port: the leg
    const auto& legs = part.body->legs;
    for (std::size_t leg = 0; leg < legs.size(); ++leg) {
      const std::size_t before = edges.size();
      add_edges_down(part.vertices[legs[leg].first], part.vertices[0], edges);
      for (std::size_t i = before; i < edges.size(); ++i) {
        edges[i].port = static_cast<std::uint8_t>(leg);
      }
    }
    const Point origin = layout_.position[part.vertices[0]] + -as_vector(part.body->vertices[0]);
    Vector chosen;
    if (!choose([&](Vector offset) {
          chosen = offset;
          return middles_fit(edges, segments_of(*part.body, origin + offset, edges));
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
      const auto& [v, end] = body.legs[edge.port];
      segments.push_back({at(body.vertices[v]), at(end)});
    }
    for (const SmallBody::BodyLink& link : body.links) {
      segments.push_back({at(body.vertices[link.u]), at(link.bend_at_u)});
      segments.push_back({at(link.bend_at_u), at(link.bend_at_v)});
      segments.push_back({at(link.bend_at_v), at(body.vertices[link.v])});
    }
    return segments;
  }

  void commit_body(const VertexPart& part, Point origin, const std::vector<NewEdge>& edges) {
    const SmallBody& body = *part.body;
    const std::vector<LatticeSegment> own = segments_of(body, origin, edges);
    for (const LatticeSegment& segment : own) add_stub(segment);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      add_middle(edges[i], own[i].to);
      const Vertex v = part.vertices[body.legs[edges[i].port].first];
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

  const OrderedGraph& graph_;
  std::span<const VertexPart> parts_;
  const SlotArrangement& arrangement_;
  const Layout& layout_;
  Placement& made_;
  Vertex first_vertex_, num_vertices_;   ///< of the component
  std::size_t first_part_, first_body_;  ///< by index into all parts, into those here
  std::vector<SquareWalk> walks_;  ///< by owner: the vertices off bodies in their order, the bodies
  std::uint32_t owner_ = 0;        ///< who is placed now
  DrawnSegments drawn_;
  std::vector<NewEdge> edges_;
  /// Holds of each body the bend that will be joined to it and the end of its leg, in the body's
  /// coordinates, for those whose lower vertex is placed.
  std::vector<std::vector<LatticeSegment>> legs_;
};

}  // namespace

bool place(const OrderedGraph& graph, std::span<const VertexPart> parts,
           const SlotArrangement& arrangement, const Layout& layout, std::uint64_t seed,
           Placement& made, MeetingSearch& find) {
  return VertexPlacer(graph, parts, arrangement, layout, made).run(seed, find);
}

}  // namespace ar3d::two_bend_109
