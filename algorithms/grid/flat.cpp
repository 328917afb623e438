#include "ar3d/algorithms/grid/flat.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>

#include "ar3d/algorithms/grid/number_search.h"
#include "ar3d/model/error.h"

namespace ar3d::grid {
namespace {

constexpr std::int32_t kUnset = std::numeric_limits<std::int32_t>::min();
constexpr Vertex kNone = static_cast<Vertex>(-1);
constexpr std::uint64_t kSeed = 0x677269642d330002;

class Flat {
 public:
  Flat(const Graph& graph, const Labels& labels)
      : graph_(graph),
        x_(graph.num_vertices(), {kUnset, kUnset, kUnset}),
        neighbours_(graph.num_vertices(), {kNone, kNone, kNone}),
        labels_(labels.of),
        taken_{NumberSet(graph.num_vertices()), NumberSet(graph.num_vertices()),
               NumberSet(graph.num_vertices())},
        sums_(2 * std::int64_t{graph.num_vertices()}),
        random_(kSeed),
        search_(sums_, random_, 10 * std::int64_t{graph.num_vertices()} + 36),
        frontier_(-std::int64_t{graph.num_vertices()} / 4) {}

  bool all_edges_have_one_colour() {
    for (Vertex v = 0; v < graph_.num_vertices(); ++v) {
      for (const HalfEdge& half : graph_.incident(v)) {
        const Colour label = labels_.at(half.edge, v, half.to);
        if (label == kNoColour || label != labels_.at(half.edge, half.to, v)) return false;
        neighbours_[v][label] = half.to;
      }
    }
    return true;
  }

  void number_chains() {
    // First the paths, from an end; what remains are cycles.
    for (Vertex v = 0; v < graph_.num_vertices(); ++v) {
      const bool ends_chain = neighbours_[v][0] == kNone || neighbours_[v][1] == kNone;
      if (ends_chain && x_[v][0] == kUnset && x_[v][1] == kUnset) number_path(v);
    }
    for (Vertex v = 0; v < graph_.num_vertices(); ++v) {
      if (x_[v][0] == kUnset) number_cycle(v);
    }
  }

  /// Colour 2: every edge gets the first number that makes both sums new and far from their
  /// neighbours' sums.
  void number_third_colour() {
    std::int64_t cursor = -std::int64_t{graph_.num_vertices()} / 2;
    for (Vertex v = 0; v < graph_.num_vertices(); ++v) {
      if (x_[v][2] != kUnset) continue;
      const Vertex partner = neighbours_[v][2];
      std::array<SumRule, 2> rules{rule_of(v), {}};
      if (partner != kNone) rules[1] = rule_of(partner);
      constexpr std::int64_t kBack = 64;
      const std::int64_t low = cursor - kBack;
      const auto found =
          search_.find(Direction::up, taken_[2], {rules.data(), partner != kNone ? 2u : 1u},
                       {low, low + 10 * std::int64_t{graph_.num_vertices()} + 36});
      cursor = std::max(cursor, found.value());
      taken_[2].insert(*found);
      for (const Vertex end : {v, partner}) {
        if (end == kNone) continue;
        x_[end][2] = static_cast<std::int32_t>(*found);
        expect(sums_.insert(sum_of(x_[end])), "sums are distinct (I1)");
      }
    }
  }

  Planes result() && { return {std::move(x_), std::move(labels_), {}, {}}; }

 private:
  /// One number of a chain: the plane of an edge of colour 0 or 1, or a free number at the end of a
  /// path.
  struct Link {
    Colour colour = 0;
    std::int64_t height = 0;  // X_0 = height, X_1 = -height
  };

  /// X_0 + X_1 of a vertex between two links.
  static std::int64_t pair_sum(const Link& a, const Link& b) {
    return a.colour == 0 ? a.height - b.height : b.height - a.height;
  }

  bool is_far_from_partner(Vertex v, std::int64_t pair) const {
    const Vertex partner = neighbours_[v][2];
    if (partner == kNone || x_[partner][0] == kUnset || x_[partner][1] == kUnset) return true;
    return std::abs(pair - (std::int64_t{x_[partner][0]} + x_[partner][1])) >= 2;
  }

  void settle(Vertex v, const Link& a, const Link& b) {
    for (const Link& link : {a, b}) {
      x_[v][link.colour] = static_cast<std::int32_t>(link.colour == 0 ? link.height : -link.height);
    }
  }

  /// The lowest free height from `low` on that keeps v's pair sum away from its partner's.
  /// `closing`, if not kNone, is the last vertex of a cycle, between the new link and `end`.
  Link next_link(Vertex v, const Link& from, Vertex closing, const Link& end) {
    Link link{1 - from.colour, 0};
    for (std::int64_t h = std::max(from.height - 1, floor_);; ++h) {
      h = taken_[link.colour].next_outside(h);
      link.height = h;
      if (!is_far_from_partner(v, pair_sum(from, link))) continue;
      if (closing != kNone) {
        const std::int64_t pair = pair_sum(link, end);
        if (!is_far_from_partner(closing, pair)) continue;
        if (neighbours_[closing][2] == v && std::abs(pair - pair_sum(from, link)) < 2) continue;
      }
      take(link);
      settle(v, from, link);
      return link;
    }
  }

  void take(const Link& link) {
    expect(taken_[link.colour].insert(link.height), "every plane number is fresh (I3)");
    frontier_ = std::max(frontier_, link.height);
  }

  Link first_link(Colour c) {
    constexpr std::int64_t kBack = 8;
    const Link link{c, taken_[c].next_outside(frontier_ - kBack)};
    floor_ = link.height;
    take(link);
    return link;
  }

  void number_path(Vertex end) {
    const Colour towards = neighbours_[end][0] != kNone ? 0 : 1;
    Link link = first_link(1 - towards);
    for (Vertex v = end; v != kNone;) {
      const Link after = next_link(v, link, kNone, {});
      v = neighbours_[v][after.colour];
      link = after;
    }
  }

  /// Numbers a cycle upwards along both of its sides at once, so that the sides meet at about the
  /// same height.
  void number_cycle(Vertex start) {
    cycle_.clear();
    Colour c = 0;
    for (Vertex v = start; cycle_.empty() || v != start; c = 1 - c) {
      cycle_.push_back(v);
      v = neighbours_[v][c];
    }
    std::size_t a = 0;  // cycle_[a] .. cycle_[b - 1] have no numbers yet
    std::size_t b = cycle_.size();
    Link low = first_link(1);
    Link high = low;
    while (b - a > 1) {
      const bool from_front = low.height <= high.height;
      Link& side = from_front ? low : high;
      const Link& other = from_front ? high : low;
      const Vertex v = from_front ? cycle_[a++] : cycle_[--b];
      side = next_link(v, side, b - a == 1 ? cycle_[a] : kNone, other);
    }
    settle(cycle_[a], low, high);
  }

  SumRule rule_of(Vertex v) const {
    SumRule rule;
    rule.known = std::int64_t{x_[v][0]} + x_[v][1];
    for (const Colour c : {0u, 1u}) {
      const Vertex w = neighbours_[v][c];
      if (w != kNone && x_[w][2] != kUnset) rule.join(sum_of(x_[w]));
    }
    return rule;
  }

  const Graph& graph_;
  std::vector<PlaneNumbers> x_;
  std::vector<std::array<Vertex, kColours>> neighbours_;  // by colour
  EdgeLabels labels_;
  std::array<NumberSet, kColours> taken_;  // of colours 0 and 1: heights
  NumberSet sums_;
  RandomStream random_;
  NumberSearch search_;
  std::vector<Vertex> cycle_;
  std::int64_t floor_ = 0;  // of the present chain: it grows upwards
  std::int64_t frontier_;   // largest height so far; every chain begins near it
};

}  // namespace

std::optional<Planes> flat_planes(const Graph& graph, const Labels& labels) {
  if (labels.clashes > 0) return std::nullopt;
  Flat flat(graph, labels);
  if (!flat.all_edges_have_one_colour()) return std::nullopt;
  flat.number_chains();
  flat.number_third_colour();
  return std::move(flat).result();
}

}  // namespace ar3d::grid
