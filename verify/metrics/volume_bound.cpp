// How small a drawing can be: distinct lattice points of what is drawn, and a cut through the
// middle, for the drawings of one guarantee (docs/lower-bounds.md). Nothing here looks at a
// drawing. Sources whose edges carry least give the same bound with a third of the searches that
// other sources need, and 64 of them in one search take a quarter of the time.
#include "ar3d/verify/metrics/volume_bound.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace ar3d {
namespace {

constexpr std::uint64_t kSmallestCut = 512;   // below, points gave more
constexpr std::uint64_t kLargestCut = 16384;  // above, few sources could be afforded
constexpr std::uint32_t kMostVisits = 32000000;

std::uint64_t rounded_up(std::uint64_t a, std::uint64_t b) { return (a + b - 1) / b; }

/// The units that sources send to all vertices, 64 sources at a time: a word has a bit, and a vertex
/// a lane, for each of them.
class Routing {
 public:
  static constexpr std::size_t kLanes = 64;

  /// @pre degree at most 4, fewer than 2^16 vertices.
  explicit Routing(const Graph& graph)
      : n_(graph.num_vertices()), ways_(n_), units_(n_ + 1), load_(graph.num_edges() + 1) {
    for (Vertex v = 0; v < n_; ++v) {
      ways_[v].fill({static_cast<Vertex>(n_), graph.num_edges()});  // never nearer
      std::copy(graph.incident(v).begin(), graph.incident(v).end(), ways_[v].begin());
    }
  }

  /// Adds up to 64 sources: of edges to nearer vertices each vertex takes one with the least load.
  /// False if some vertex is too far away.
  bool add_sources(std::span<const Vertex> sources) {
    if (!search_from(sources)) return false;
    std::array<std::uint16_t, kLanes> own;
    own.fill(1);
    std::fill(units_.begin(), units_.end(), own);
    for (std::size_t distance = levels_.size(); --distance > 0;) {
      for (Vertex v = 0; v < n_; ++v) {
        if (levels_[distance][v] != 0) send_on(v, levels_[distance][v], levels_[distance - 1]);
      }
    }
    return true;
  }
  /// Of the vertices whose edges have the least load with n units more, up to 64 that are no
  /// neighbours and have none in common. (One edge gets up to twice its share.)
  std::vector<Vertex> next_sources(std::span<const Vertex> vertices) const {
    constexpr std::uint32_t kSpread = 2654435761;  // of equal ones over the labels
    std::vector<std::array<std::uint32_t, 3>> by_load;
    for (const Vertex v : vertices) {
      std::uint32_t heaviest = 0, degree = 0;
      for (const HalfEdge& way : ways_[v]) {
        heaviest = std::max(heaviest, load_[way.edge]);
        degree += way.to != n_;
      }
      by_load.push_back({heaviest + 2 * static_cast<std::uint32_t>(n_) / degree, v * kSpread, v});
    }
    const auto some = by_load.begin() + std::min<std::ptrdiff_t>(std::ssize(by_load), 8 * kLanes);
    std::partial_sort(by_load.begin(), some, by_load.end());
    by_load.erase(some, by_load.end());
    std::vector<Vertex> sources;
    std::vector<bool> is_near(n_ + 1);
    for (const auto& [heaviest, spread, v] : by_load) {
      bool is_apart = !is_near[v] && sources.size() < kLanes;
      for (const HalfEdge& way : ways_[v]) is_apart &= !is_near[way.to];
      if (!is_apart) continue;
      sources.push_back(v);
      is_near[v] = true;
      for (const HalfEdge& way : ways_[v]) is_near[way.to] = way.to != n_;
    }
    return sources;
  }

  std::uint64_t largest_load() const { return *std::max_element(load_.begin(), load_.end()); }
  /// Of all paths taken.
  std::uint64_t length() const {
    return std::accumulate(load_.begin(), load_.end(), std::uint64_t{0});
  }

 private:
  using Words = std::vector<std::uint64_t>;  ///< of the vertices, and of one that is nowhere

  bool search_from(std::span<const Vertex> sources) {
    constexpr std::size_t kFarthest = 256;  // deeper graphs have small bisections
    levels_.assign(1, Words(n_ + 1));
    for (std::size_t i = 0; i < sources.size(); ++i) {
      levels_[0][sources[i]] |= std::uint64_t{1} << i;
    }
    Words seen = levels_[0];
    for (std::uint64_t any = 1; any != 0 && levels_.size() <= kFarthest;) {
      const Words& last = levels_.back();
      Words next(n_ + 1);
      any = 0;
      for (Vertex v = 0; v < n_; ++v) {
        std::uint64_t reached = 0;
        for (const HalfEdge& way : ways_[v]) reached |= last[way.to];
        any |= next[v] = reached & ~seen[v];
        seen[v] |= reached;
      }
      levels_.push_back(std::move(next));  // the last one is empty
    }
    return levels_.size() <= kFarthest;
  }

  // Which lane takes which way is no question of a branch.
  void send_on(Vertex v, std::uint64_t lanes, const Words& nearer) {
    std::array<HalfEdge, 4> ways = ways_[v];
    const auto order = [&](std::size_t i, std::size_t j) {
      const bool is_less = load_[ways[j].edge] < load_[ways[i].edge];
      const HalfEdge less = is_less ? ways[j] : ways[i];
      ways[j] = is_less ? ways[i] : ways[j];
      ways[i] = less;
    };
    order(0, 1), order(2, 3), order(0, 2), order(1, 3), order(1, 2);
    std::array<std::uint64_t, 4> taken;
    std::uint64_t rest = lanes;
    for (std::size_t i = 0; i < 4; ++i) {
      taken[i] = nearer[ways[i].to] & rest;
      rest &= ~taken[i];
    }
    const std::uint64_t low = taken[1] | taken[3], high = taken[2] | taken[3];
    std::array<std::uint32_t, 4> sent{};
    for (; lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
      const std::size_t i = (low >> lane & 1) + 2 * (high >> lane & 1);
      const std::uint16_t units = units_[v][lane];
      units_[ways[i].to][lane] += units;
      sent[i] += units;
    }
    for (std::size_t i = 0; i < 4; ++i) load_[ways[i].edge] += sent[i];
  }

  std::size_t n_;
  std::vector<std::array<HalfEdge, 4>> ways_;  ///< of a vertex
  std::vector<std::array<std::uint16_t, kLanes>> units_;
  std::vector<std::uint32_t> load_;
  std::vector<Words> levels_;  ///< by distance: the sources that are so far away
};

/// The edges between the half of a component that a breadth-first search finds first and the rest.
std::uint64_t some_bisection(const Graph& graph, Vertex first) {
  std::vector<bool> is_seen(graph.num_vertices()), is_inside(graph.num_vertices());
  std::vector<Vertex> order{first};
  is_seen[first] = true;
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (const HalfEdge& half : graph.incident(order[i])) {
      if (!is_seen[half.to]) order.push_back(half.to);
      is_seen[half.to] = true;
    }
  }
  std::uint64_t crossing = 0;
  for (std::size_t i = 0; i < order.size() / 2; ++i) is_inside[order[i]] = true;
  for (const auto [u, v] : graph.edges()) crossing += is_inside[u] != is_inside[v];
  return crossing;
}

template <class IsOne>
bool all_directions(const Guarantee& guarantee, const IsOne& is_one) {
  const auto& directions = guarantee.directions;
  return !directions.empty() && std::all_of(directions.begin(), directions.end(), is_one);
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

std::vector<RoutedBisection> route_bisection(
    const Graph& graph, std::span<const Vertex> vertices, std::uint32_t most_visits,
    const std::function<bool(const RoutedBisection&)>& is_worth) {
  const std::uint64_t n = vertices.size(), m = graph.num_edges();
  const std::uint64_t most = std::max<std::uint64_t>(most_visits / (n + 2 * m), 1);
  std::vector<RoutedBisection> steps{{0, some_bisection(graph, vertices[0])}};
  if (!is_worth(steps[0])) return steps;
  Routing routing(graph);
  std::uint64_t sources = 0;
  do {
    for (const std::uint64_t end = std::clamp<std::uint64_t>(2 * sources, 1, most);
         sources < end;) {
      const std::vector<Vertex> next = routing.next_sources(vertices);
      if (!routing.add_sources(next)) return steps;
      sources += next.size();
    }
    auto [at_least, reachable] = steps.back();
    const std::uint64_t bound = rounded_up(sources * (n / 2), routing.largest_load());
    // Edges carry at least the mean, so k sources with paths of length L in all give k (n / 2) m / L
    // at most (others are taken to give 5/4 of it), and K give K / k times what k of them gave.
    reachable = std::min({reachable, rounded_up(bound * std::max(most, sources), sources),
                          5 * (sources * (n / 2) * m / routing.length() + 1) / 4});
    at_least = std::max(at_least, std::min(bound, reachable));
    const std::uint64_t quarter = steps.size() > 2 ? steps.end()[-2].first : 0;
    if (10 * at_least < 11 * quarter || sources >= most) reachable = at_least;
    steps.emplace_back(at_least, reachable);
  } while (steps.back().second > steps.back().first && is_worth(steps.back()));
  return steps;
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
  GraphNeeds needs;
  needs.vertices = graph.num_vertices();
  needs.edges = graph.num_edges();
  const std::vector<bool> inside = in_largest_component(graph);
  needs.part_vertices = static_cast<std::uint64_t>(std::count(inside.begin(), inside.end(), true));
  return needs;
}

void seek_bisection(const Graph& graph, const Guarantee& guarantee, GraphNeeds& needs) {
  if (needs.part_vertices < kSmallestCut || needs.part_vertices > kLargestCut) return;
  if (graph.max_degree() > 4 || steps_of(guarantee) == DrawnSteps::any) return;
  const auto volume_with = [&](std::uint64_t bisection) {
    GraphNeeds with = needs;
    with.bisection = bisection;
    return volume_at_least(with, guarantee);
  };
  const auto is_worth = [&](const RoutedBisection& found) {
    return 49 * volume_with(found.second) > 50 * volume_with(found.first);
  };
  auto& found = needs.bisections;
  auto last = std::find_if_not(found.begin(), found.end(), is_worth);
  if (last == found.end()) {
    const std::vector<bool> inside = in_largest_component(graph);
    std::vector<Vertex> part;
    for (Vertex v = 0; v < graph.num_vertices(); ++v) {
      if (inside[v]) part.push_back(v);
    }
    found = route_bisection(graph, part, kMostVisits, is_worth);
    last = std::prev(found.end());
  }
  needs.bisection = last->first;
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
