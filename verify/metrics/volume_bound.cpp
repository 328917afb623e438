// How small a drawing can be: distinct lattice points of what is drawn, and a cut through the
// middle, for the drawings of one guarantee (docs/lower-bounds.md). Nothing here looks at a
// drawing.
#include "ar3d/verify/metrics/volume_bound.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

namespace ar3d {
namespace {

constexpr std::uint64_t kSmallestCut = 512;   // below, points gave more
constexpr std::uint64_t kLargestCut = 16384;  // above, few sources could be afforded
constexpr std::uint64_t kMostVisits = std::uint64_t{1} << 26;
constexpr std::uint64_t kFirstSources = 16;

std::uint64_t rounded_up(std::uint64_t a, std::uint64_t b) { return (a + b - 1) / b; }

/// The vertices of the largest component, the first of equally large ones.
std::vector<Vertex> largest_component(const Graph& graph) {
  const Components components = connected_components_of(graph);
  std::vector<std::uint64_t> sizes(components.count);
  for (const std::uint32_t c : components.of) ++sizes[c];
  const auto largest = std::max_element(sizes.begin(), sizes.end()) - sizes.begin();
  std::vector<Vertex> vertices;
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    if (components.of[v] == static_cast<std::uint32_t>(largest)) vertices.push_back(v);
  }
  return vertices;
}

/// The units that one source after the other sends to all vertices.
class Routing {
 public:
  explicit Routing(const Graph& graph)
      : graph_(graph),
        distance_(graph.num_vertices(), kUnseen),
        units_(graph.num_vertices()),
        load_(graph.num_edges()) {}

  /// Of the edges to nearer vertices a vertex takes the one with the smallest load so far.
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
  const auto sum_of_unit = [](Vector d) {  // of absolute values; 0 if one is above 1
    const std::int64_t x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
    return std::max({x, y, z}) == 1 ? x + y + z : 0;
  };
  const auto all_sum_to = [&](std::int64_t sum) {
    return all_directions(guarantee, [&](Vector d) { return sum_of_unit(d) == sum; });
  };
  if (guarantee.cosine == Cosine{-1, 3} && all_sum_to(3)) return DrawnSteps::body_diagonals;
  if (guarantee.cosine == Cosine{-1, 2} && all_sum_to(2)) return DrawnSteps::face_diagonals;
  return DrawnSteps::any;
}

// Lemma L.1: in such drawings every edge has a bend outside of the plane of the vertices.
bool leaves_the_plane(const Guarantee& guarantee) {
  return guarantee.vertices_in_plane &&
         all_directions(guarantee, [](Vector d) { return d.z != 0; });
}

/// The least c >= b such that the box of a x b x c points holds what is needed.
std::uint64_t third_side(const BoxNeeds& needs, std::uint64_t a, std::uint64_t b) {
  switch (needs.steps) {
    case DrawnSteps::any:
      return std::max({b, rounded_up(needs.points, a * b), rounded_up(needs.in_plane, b)});
    case DrawnSteps::face_diagonals:  // half of the points, rounded up
      return std::max({b, rounded_up(2 * needs.points - 1, a * b),
                       needs.in_plane == 0 ? 1 : rounded_up(2 * needs.in_plane - 1, b)});
    case DrawnSteps::body_diagonals:
      break;
  }
  const std::uint64_t even =
      ((a + 1) / 2) * ((b + 1) / 2);  // points of even layers, and of odd ones
  const std::uint64_t both = even + (a / 2) * (b / 2);
  const std::uint64_t pairs = (needs.points - 1) / both;  // of layers
  const std::uint64_t c = 2 * pairs + (needs.points - pairs * both <= even ? 1 : 2);
  const std::uint64_t wide = rounded_up(needs.in_plane, (b + 1) / 2);
  return std::max({b, c, wide == 0 ? 1 : 2 * wide - 1});
}

/// The least b >= a such that a layer of a x b points holds what is needed.
std::uint64_t second_side(const BoxNeeds& needs, std::uint64_t a) {
  if (needs.in_layer == 0) return a;
  switch (needs.steps) {
    case DrawnSteps::any:
      return std::max(a, rounded_up(needs.in_layer, a));
    case DrawnSteps::face_diagonals:
      return std::max(a, rounded_up(2 * needs.in_layer - 1, a));
    case DrawnSteps::body_diagonals:
      break;
  }
  return std::max(a, 2 * rounded_up(needs.in_layer, (a + 1) / 2) - 1);
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
    for (std::uint64_t b = second_side(needs, a); a * b * b < best; ++b) {
      best = std::min(best, a * b * third_side(needs, a, b));
    }
  }
  return best;
}

GraphNeeds needs_of(const Graph& graph, bool with_bisection) {
  GraphNeeds needs{graph.num_vertices(), graph.num_edges(), 0, 0};
  const std::vector<Vertex> part =
      graph.num_vertices() == 0 ? std::vector<Vertex>() : largest_component(graph);
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
