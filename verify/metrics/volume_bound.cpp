// How small a drawing can be: distinct lattice points of what is drawn, and a cut through the
// middle, for the drawings of one guarantee (docs/lower-bounds.md). Nothing here looks at a
// drawing.
#include "ar3d/verify/metrics/volume_bound.h"

#include <algorithm>

namespace ar3d {
namespace {

constexpr std::uint64_t kSmallestCut = 512;   // below, points gave more
constexpr std::uint64_t kLargestCut = 16384;  // above, few sources could be afforded
constexpr std::uint32_t kMostVisits = 40000000;
constexpr std::uint64_t kFirstSources = 16;

std::uint64_t rounded_up(std::uint64_t a, std::uint64_t b) { return (a + b - 1) / b; }

/// The units that one source after the other sends to all vertices. Half of the edges that are
/// looked at lead to a vertex that was seen, so nothing here asks by a branch.
class Routing {
 public:
  explicit Routing(const Graph& graph)
      : graph_(graph),
        order_(graph.num_vertices() + std::size_t{1}),
        distance_(graph.num_vertices(), kUnseen),
        units_(graph.num_vertices()),
        load_(graph.num_edges()),
        heaviest_(graph.num_vertices()) {}

  /// Adds a source: of edges to nearer vertices each vertex takes the one with the least load.
  void add_source(Vertex source) {
    const std::size_t size = search_from(source);
    for (std::size_t i = size; --i > 0;) send_on(order_[i]);
    for (std::size_t i = 0; i < size; ++i) distance_[order_[i]] = kUnseen;
    heaviest_[source] = kUnseen;
  }
  /// The vertex whose edges have the least load, of those that are no source yet.
  Vertex next_source(std::span<const Vertex> vertices) const {
    return *std::min_element(vertices.begin(), vertices.end(),
                             [this](Vertex u, Vertex v) { return heaviest_[u] < heaviest_[v]; });
  }

  std::uint64_t largest_load() const { return largest_; }
  /// Of all paths taken.
  std::uint64_t length() const { return length_; }

 private:
  static constexpr std::uint32_t kUnseen = std::numeric_limits<std::uint32_t>::max() - 1;

  std::size_t search_from(Vertex source) {
    order_[0] = source;
    distance_[source] = 0;
    std::size_t end = 1;
    for (std::size_t i = 0; i < end; ++i) {
      const Vertex v = order_[i];
      const std::uint32_t next = distance_[v] + 1;
      units_[v] = 1;
      for (const HalfEdge& half : graph_.incident(v)) {
        std::uint32_t& distance = distance_[half.to];
        order_[end] = half.to;
        end += distance == kUnseen;
        distance = std::min(distance, next);
      }
    }
    return end;
  }

  void send_on(Vertex v) {
    const std::uint32_t nearer = distance_[v] - 1;
    std::uint32_t least = kUnseen;
    HalfEdge way;
    for (const HalfEdge& half : graph_.incident(v)) {
      const std::uint32_t load = distance_[half.to] == nearer ? load_[half.edge] : kUnseen;
      const bool is_less = load < least;
      way.to = is_less ? half.to : way.to;
      way.edge = is_less ? half.edge : way.edge;
      least = std::min(least, load);
    }
    const std::uint32_t load = load_[way.edge] = least + units_[v];
    units_[way.to] += units_[v];
    length_ += nearer + 1;
    largest_ = std::max(largest_, load);
    heaviest_[v] = std::max(heaviest_[v], load);
    heaviest_[way.to] = std::max(heaviest_[way.to], load);
  }

  const Graph& graph_;
  std::vector<Vertex> order_;
  std::vector<std::uint32_t> distance_, units_, load_;
  std::vector<std::uint32_t> heaviest_;  ///< load of an edge at the vertex; kUnseen at a source
  std::uint32_t largest_ = 0;
  std::uint64_t length_ = 0;
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

RoutedBisection route_bisection(const Graph& graph, std::span<const Vertex> vertices,
                                std::uint32_t most_visits,
                                const std::function<bool(const RoutedBisection&)>& is_worth) {
  constexpr std::uint64_t kStride = 2654435761;  // spreads the first sources over the labels
  const std::uint64_t n = vertices.size(), m = graph.num_edges();
  const std::uint64_t most = std::min(n, most_visits / (n + 2 * m));
  Routing routing(graph);
  RoutedBisection result;
  std::uint64_t half = 0, quarter = 0, sources = 0;  // bounds with that many of the sources
  for (std::uint64_t next = std::min(most, kFirstSources); sources < next;
       next = std::min(most, 2 * next)) {
    for (; sources < next; ++sources) {
      routing.add_source(sources < kFirstSources ? vertices[sources * kStride % n]
                                                 : routing.next_source(vertices));
    }
    quarter = std::exchange(half, result.at_least);
    const std::uint64_t bound = rounded_up(sources * (n / 2), routing.largest_load());
    // Edges carry at least the mean, and no less with more sources.
    result.reachable = std::min({result.reachable, rounded_up(bound * most, sources),
                                 5 * (sources * (n / 2) * m / routing.length() + 1) / 4});
    result.at_least = std::max(result.at_least, std::min(bound, result.reachable));
    if (10 * result.at_least < 11 * quarter || sources == most) break;
    if (!is_worth(result)) return result;
  }
  result.reachable = result.at_least;
  return result;
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

GraphNeeds needs_of(const Graph& graph) {
  GraphNeeds needs{.vertices = graph.num_vertices(), .edges = graph.num_edges()};
  const std::vector<bool> inside = in_largest_component(graph);
  needs.part_vertices = static_cast<std::uint64_t>(std::count(inside.begin(), inside.end(), true));
  return needs;
}

void seek_bisection(const Graph& graph, const Guarantee& guarantee, GraphNeeds& needs) {
  if (needs.part_vertices < kSmallestCut || needs.part_vertices > kLargestCut) return;
  if (steps_of(guarantee) == DrawnSteps::any) return;
  const auto volume_with = [&](std::uint64_t bisection) {
    GraphNeeds with = needs;
    with.bisection = bisection;
    return volume_at_least(with, guarantee);
  };
  const auto is_worth = [&](const RoutedBisection& found) {
    return volume_with(found.reachable) > volume_with(found.at_least);
  };
  if (!is_worth({needs.bisection, std::min(needs.reachable_bisection, needs.edges)})) return;
  const std::vector<bool> inside = in_largest_component(graph);
  std::vector<Vertex> part;
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    if (inside[v]) part.push_back(v);
  }
  const RoutedBisection found = route_bisection(graph, part, kMostVisits, is_worth);
  needs.bisection = found.at_least;
  needs.reachable_bisection = found.reachable;
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
