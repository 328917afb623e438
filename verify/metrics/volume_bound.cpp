// How small a drawing can be: distinct lattice points of what is drawn, and a cut through the
// middle, for the drawings of one guarantee (docs/lower-bounds.md). Nothing here looks at a
// drawing.
#include "ar3d/verify/metrics/volume_bound.h"

#include <algorithm>

namespace ar3d {
namespace {

constexpr std::uint64_t kSmallestCut = 512;   // below, points gave more
constexpr std::uint64_t kLargestCut = 16384;  // above, few sources could be afforded
constexpr std::uint64_t kMostVisits = std::uint64_t{1} << 26;
constexpr std::uint64_t kFirstSources = 16;

std::uint64_t rounded_up(std::uint64_t a, std::uint64_t b) { return (a + b - 1) / b; }

/// The units that one source after the other sends to all vertices.
class Routing {
 public:
  explicit Routing(const Graph& graph)
      : graph_(graph),
        distance_(graph.num_vertices(), kUnseen),
        units_(graph.num_vertices()),
        load_(graph.num_edges()) {}

  /// Adds a source: of edges to nearer vertices each vertex takes the one with the least load.
  void add_source(Vertex source) {
    search_from(source);
    for (std::size_t i = order_.size(); --i > 0;) {
      const Vertex v = order_[i];
      const HalfEdge* way = nullptr;
      for (const HalfEdge& half : graph_.incident(v)) {
        if (distance_[half.to] + 1 != distance_[v]) continue;
        if (way == nullptr || load_[half.edge] < load_[way->edge]) way = &half;
      }
      load_[way->edge] += units_[v];
      units_[way->to] += units_[v];
      largest_ = std::max(largest_, load_[way->edge]);
    }
    for (const Vertex v : order_) distance_[v] = kUnseen;
  }

  std::uint64_t largest_load() const { return largest_; }

 private:
  static constexpr Vertex kUnseen = std::numeric_limits<Vertex>::max() - 1;

  void search_from(Vertex source) {
    order_.assign(1, source);
    distance_[source] = 0;
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const Vertex v = order_[i];
      units_[v] = 1;
      for (const HalfEdge& half : graph_.incident(v)) {
        if (distance_[half.to] != kUnseen) continue;
        distance_[half.to] = distance_[v] + 1;
        order_.push_back(half.to);
      }
    }
  }

  const Graph& graph_;
  std::vector<Vertex> order_, distance_;
  std::vector<std::uint64_t> units_, load_;
  std::uint64_t largest_ = 0;
};

template <class IsOne>
bool all_directions(const Guarantee& guarantee, const IsOne& is_one) {
  const auto& directions = guarantee.directions;
  return !directions.empty() && std::all_of(directions.begin(), directions.end(), is_one);
}

DrawnSteps steps_of(const Guarantee& guarantee) {
  if (guarantee.lattice != kCubeLattice || guarantee.angle_rule != AngleRule::exactly) {
    return DrawnSteps::any;
  }
  const auto all_have = [&](std::int64_t squared) {
    return all_directions(guarantee,
                          [&](Vector d) { return d.x * d.x + d.y * d.y + d.z * d.z == squared; });
  };
  if (guarantee.cosine == Cosine{-1, 3} && all_have(3)) return DrawnSteps::body_diagonals;
  if (guarantee.cosine == Cosine{-1, 2} && all_have(2)) return DrawnSteps::face_diagonals;
  return DrawnSteps::any;
}

// Lemma L.1: in such drawings every edge has a bend outside of the plane of the vertices.
bool leaves_the_plane(const Guarantee& guarantee) {
  return guarantee.vertices_in_plane &&
         all_directions(guarantee, [](Vector d) { return d.z != 0; });
}

/// The points of a box, a layer or a plane that a drawing can use (Lemma L.2).
std::uint64_t usable(DrawnSteps steps, std::uint64_t a, std::uint64_t b, std::uint64_t c) {
  if (steps == DrawnSteps::any) return a * b * c;
  if (steps == DrawnSteps::face_diagonals) return (a * b * c + 1) / 2;
  return ((a + 1) / 2) * ((b + 1) / 2) * ((c + 1) / 2) + (a / 2) * (b / 2) * (c / 2);
}

/// The least side from `low` on that is long enough, as every longer one is.
template <class IsEnough>
std::uint64_t least_side(std::uint64_t low, const IsEnough& is_enough) {
  std::uint64_t high = low;
  for (std::uint64_t step = 1; !is_enough(high); step *= 2) {
    low = high + 1;
    high += step;
  }
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    is_enough(middle) ? high = middle : low = middle + 1;
  }
  return low;
}

}  // namespace

std::uint64_t bisection_at_least(const Graph& graph, std::span<const Vertex> vertices,
                                 std::uint64_t most_visits) {
  constexpr std::uint64_t kStride = 2654435761;  // spreads the first sources over the labels
  const std::uint64_t n = vertices.size();
  const std::uint64_t visits = n + 2 * std::uint64_t{graph.num_edges()};
  const std::uint64_t most = std::min(n, most_visits / visits);
  Routing routing(graph);
  std::uint64_t bound = 0, half = 0, quarter = 0, sources = 0;  // with that many of the sources
  for (std::uint64_t next = std::min(most, kFirstSources); sources < next;
       next = std::min(most, 2 * next)) {
    for (; sources < next; ++sources) routing.add_source(vertices[sources * kStride % n]);
    quarter = std::exchange(half, bound);
    bound = std::max(bound, rounded_up(sources * (n / 2), routing.largest_load()));
    if (10 * bound < 11 * quarter) break;
  }
  return bound;
}

std::uint64_t smallest_box(const BoxNeeds& needs) {
  std::uint64_t best = std::numeric_limits<std::uint64_t>::max();
  for (std::uint64_t a = needs.side; a * a * a < best; ++a) {
    std::uint64_t b = least_side(
        a, [&](std::uint64_t y) { return usable(needs.steps, a, y, 1) >= needs.in_layer; });
    for (; a * b * b < best; ++b) {
      const std::uint64_t c = least_side(b, [&](std::uint64_t z) {
        return usable(needs.steps, a, b, z) >= needs.points &&
               usable(needs.steps, 1, b, z) >= needs.in_plane;
      });
      best = std::min(best, a * b * c);
    }
  }
  return best;
}

GraphNeeds needs_of(const Graph& graph, bool with_bisection) {
  GraphNeeds needs{graph.num_vertices(), graph.num_edges(), 0, 0};
  const std::vector<bool> inside = in_largest_component(graph);
  std::vector<Vertex> part;
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    if (inside[v]) part.push_back(v);
  }
  needs.part_vertices = part.size();
  if (with_bisection && part.size() >= kSmallestCut && part.size() <= kLargestCut) {
    needs.bisection = bisection_at_least(graph, part, kMostVisits);
  }
  return needs;
}

std::int64_t volume_at_least(const GraphNeeds& needs, const Guarantee& guarantee) {
  if (guarantee.claim != Claim::proved) return -1;
  const bool leaves = leaves_the_plane(guarantee);
  const std::uint64_t points = needs.vertices + (leaves ? needs.edges : 0);
  const bool is_connected = needs.part_vertices == needs.vertices;
  BoxNeeds box{.steps = steps_of(guarantee)};
  box.points = std::max<std::uint64_t>(
      1, is_connected ? points : needs.part_vertices + (leaves ? needs.part_vertices - 1 : 0));
  if (guarantee.vertices_in_plane) box.in_plane = needs.part_vertices;
  if (box.steps == DrawnSteps::body_diagonals) {
    if (needs.part_vertices > 1) box.side = 2;
    box.in_layer = rounded_up(needs.bisection, 2);
  } else if (box.steps == DrawnSteps::face_diagonals) {
    box.in_layer = rounded_up(2 * needs.bisection, 3);
  }
  return static_cast<std::int64_t>(std::max(points, smallest_box(box)));
}

std::int64_t volume_at_least(const Graph& graph, const Guarantee& guarantee) {
  return volume_at_least(needs_of(graph), guarantee);
}

}  // namespace ar3d
