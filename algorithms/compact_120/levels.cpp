// Step D.6: four levels, so that the ends of an edge are far apart in a narrow strip, and few
// sources and sinks. Nothing is proved of it but that the order is right: Lemma D.8 gives the moved
// order to every component of the graph on which the sweeps fail. Cost: O(n) for each of a bounded
// number of sweeps; O(n log n) where a component gets the moved order, whose paths are measured
// rank by rank.
#include <algorithm>
#include <array>

#include "ar3d/algorithms/compact_120/order.h"

namespace ar3d::compact_120 {
namespace {

constexpr unsigned kLevels = 4;
constexpr int kSweeps = 5;  ///< before owners are tried
constexpr int kSweepsOfRepair = 4;

// What is known of a vertex, in a byte: its level, how many neighbours are to the left, whether it
// has degree 3; and whether it is among those that a repair touched.
constexpr unsigned kOneLeft = 4;
constexpr unsigned kDegree3 = 16;
constexpr unsigned kStates = 32;
constexpr unsigned kTouched = 32;
constexpr unsigned level_of(unsigned state) { return state & 3; }
constexpr unsigned left_of(unsigned state) { return state / kOneLeft & 3; }

/// Four small numbers, one for each level, in four bits each.
using PerLevel = std::uint16_t;
constexpr PerLevel kOneEach = 0x1111;

/// For every level, whether it is beyond the index.
constexpr std::array<PerLevel, kLevels> kBeyond = {0x1110, 0x1100, 0x1000, 0x0000};

/// 1 for each level where the number is 0 or 3.
constexpr unsigned is_0_or_3(unsigned per_level) {
  return ~(per_level ^ per_level >> 1) & kOneEach;
}

/// By rank of v and state of a neighbour: for each new level of v, whether the neighbour would be a
/// source or sink of degree 3.
constexpr std::array<std::array<PerLevel, kStates>, kLevels> extremes_of_neighbours() {
  std::array<std::array<PerLevel, kStates>, kLevels> extremes{};
  for (unsigned own = 0; own < kLevels; ++own) {
    for (unsigned state = kDegree3; state < kStates; ++state) {
      const unsigned rank = level_of(state);
      for (unsigned level = 0; level < kLevels; ++level) {
        const unsigned left = left_of(state) + (level < rank ? 1 : 0) - (own < rank ? 1 : 0);
        if (left != 0 && left != 3) continue;
        extremes[own][state] = static_cast<PerLevel>(extremes[own][state] | 1u << 4 * level);
      }
    }
  }
  return extremes;
}
constexpr std::array<std::array<PerLevel, kStates>, kLevels> kExtremes = extremes_of_neighbours();

/// Levels of all vertices. One byte per vertex holds all that a sweep reads of neighbours, so that
/// it stays in the cache where graphs do not; and what levels do to a neighbour is looked up for
/// all four levels at once.
class Sweeper {
 public:
  Sweeper(const UnwrittenVector<PaddedRow>& rows, const strips::NumbersAhead& random)
      : rows_(rows), random_(random), state_(rows.size(), 0) {
    for_each(rows, [&](const PaddedRow& row) {
      const unsigned used = levels_of_neighbours(row);
      unsigned level = random_level();
      while ((used >> level & 1) != 0) level = random_level();
      state_[row.v] = static_cast<std::uint8_t>(level);
    });
    for_each(rows, [&](const PaddedRow& row) {
      unsigned left = 0;
      for (const HalfEdge& edge : row.edges()) {
        left += level_of(state_[edge.to]) < level_of(state_[row.v]) ? 1 : 0;
      }
      state_[row.v] = static_cast<std::uint8_t>(state_[row.v] | left * kOneLeft |
                                                (row.degree == 3 ? kDegree3 : 0));
    });
  }

  void sweep() {
    for_each(rows_, [&](const PaddedRow& row) { improve(row); });
  }

  /// Some vertices and their neighbours, from a new random start: there the sweeps are stuck. Their
  /// rows are copied, so that all but the first pass read them forwards.
  /// @return the vertices that moved, and their neighbours.
  const std::vector<Vertex>& repair(const std::vector<Vertex>& vertices) {
    touch_ = kTouched;
    UnwrittenVector<PaddedRow> rows;
    rows.reserve(4 * vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const std::size_t twice_ahead = i + kAhead + kAhead;
      if (twice_ahead < vertices.size()) __builtin_prefetch(&rows_[vertices[twice_ahead]]);
      if (i + kAhead < vertices.size()) {
        for (const HalfEdge& edge : rows_[vertices[i + kAhead]].edges()) {
          __builtin_prefetch(&rows_[edge.to]);
        }
      }
      const PaddedRow& row = rows_[vertices[i]];
      rows.push_back(row);
      for (const HalfEdge& edge : row.edges()) rows.push_back(rows_[edge.to]);
      const unsigned level = random_level();
      if ((levels_of_neighbours(row) >> level & 1) == 0) move(row, level);
    }
    for (int sweep = 0; sweep < kSweepsOfRepair; ++sweep) {
      for_each(rows, [&](const PaddedRow& row) { improve(row); });
    }
    touched_.resize(state_.size());
    std::size_t count = 0;
    for (Vertex v = 0; v < state_.size(); ++v) {
      touched_[count] = v;
      count += (state_[v] & kTouched) != 0 ? 1 : 0;
      state_[v] = static_cast<std::uint8_t>(state_[v] & ~kTouched);
    }
    touched_.resize(count);
    return touched_;
  }

  /// The order, sources of degree 3 at the lowest level, sinks at the highest one.
  Order order() const {
    Order result;
    result.rank.reserve(state_.size());
    for (const unsigned state : state_) {
      const unsigned left = (state & kDegree3) == 0 ? 1 : left_of(state);
      const unsigned level = left == 0 ? 0 : left == 3 ? kLevels - 1 : level_of(state);
      result.rank.push_back(static_cast<std::uint16_t>(level));
    }
    return result;
  }

 private:
  static constexpr std::uint32_t kAhead = 16;

  template <class Visit>
  void for_each(const UnwrittenVector<PaddedRow>& rows, Visit visit) {
    const std::span<const PaddedRow> all(rows);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i + kAhead < all.size()) {
        for (const HalfEdge& edge : all[i + kAhead].half) __builtin_prefetch(&state_[edge.to]);
      }
      visit(all[i]);
    }
  }

  unsigned random_level() { return random_.below(kLevels); }

  /// A bit for each.
  unsigned levels_of_neighbours(const PaddedRow& row) const {
    unsigned used = 0;
    for (const HalfEdge& edge : row.edges()) used |= 1u << level_of(state_[edge.to]);
    return used;
  }

  /// Moves a vertex to the level with the fewest sources and sinks among it and its neighbours, a
  /// random one of equals: standing still would end in a poor order.
  void improve(const PaddedRow& row) {
    const unsigned own = level_of(state_[row.v]);
    unsigned used = 1u << own;
    unsigned extremes = 0;
    unsigned left = 0;  // of the vertex
    for (const HalfEdge& edge : row.edges()) {
      const unsigned state = state_[edge.to];
      used |= 1u << level_of(state);
      extremes += kExtremes[own][state % kStates];
      left += kBeyond[level_of(state)];
    }
    if ((state_[row.v] & kDegree3) != 0) extremes += is_0_or_3(left);
    // The least number wins: few extremes, then late among levels from a random one on, the own one
    // last. Without branches on what is random.
    const unsigned first = random_level();
    unsigned best = (extremes >> 4 * own & 15) << 5 | 7u << 2 | own;
    for (unsigned level = 0; level < kLevels; ++level) {
      const unsigned number = (extremes >> 4 * level & 15) << 5 | (first - level - 1) % kLevels
                                                                      << 2;
      best = std::min(best, number | level | (used >> level & 1) << 16);
    }
    move(row, level_of(best));
  }

  void move(const PaddedRow& row, unsigned level) {
    const unsigned own = level_of(state_[row.v]);
    const unsigned touched = level == own ? 0 : touch_;
    unsigned left = 0;
    for (const HalfEdge& edge : row.edges()) {
      std::uint8_t& state = state_[edge.to];
      const unsigned other = level_of(state);
      const unsigned more = (level < other ? 1u : 0u) - (own < other ? 1u : 0u);
      state = static_cast<std::uint8_t>((state + more * kOneLeft) | touched);
      left += other < level ? 1 : 0;
    }
    state_[row.v] = static_cast<std::uint8_t>((state_[row.v] & (kDegree3 | kTouched)) | level |
                                              left * kOneLeft | touched);
  }

  const UnwrittenVector<PaddedRow>& rows_;
  strips::NumbersAhead random_;
  LongVector<std::uint8_t> state_;  ///< by vertex
  unsigned touch_ = 0;              ///< kTouched in repairs
  std::vector<Vertex> touched_;
};

std::vector<Position> positions_by_level(const Order& order) {
  std::vector<Position> position;
  position.reserve(order.rank.size());
  for (const std::uint32_t level : order.rank) {
    position.push_back(static_cast<Position>(100 * level / (kLevels - 1)));
  }
  return position;
}

/// The longest ascending paths to and from every vertex, as a share.
std::vector<Position> positions_by_paths(const Graph& graph, const Order& order) {
  const Order before = in_levels(graph, order);
  Order reversed = order;
  const std::uint32_t most =
      order.rank.empty() ? 0 : *std::max_element(order.rank.begin(), order.rank.end());
  for (std::uint16_t& rank : reversed.rank) rank = static_cast<std::uint16_t>(most - rank);
  const Order after = in_levels(graph, reversed);
  std::vector<Position> position(order.rank.size(), 50);
  for (std::size_t v = 0; v < position.size(); ++v) {
    const std::uint32_t both = before.rank[v] + after.rank[v];
    if (both > 0) position[v] = static_cast<Position>(100 * before.rank[v] / both);
  }
  return position;
}

}  // namespace

NarrowOrder narrow_order(const Graph& graph, const strips::NumbersAhead& random, int repairs) {
  const UnwrittenVector<PaddedRow> rows = rows_of(graph);
  Sweeper sweeper(rows, random);
  for (int i = 0; i < kSweeps; ++i) sweeper.sweep();
  Order order = sweeper.order();
  ChangingOwners changing(rows, order);
  const std::vector<Vertex>& crowded = changing.owners().crowded;
  for (int i = 0; i < repairs && !crowded.empty(); ++i) {
    const std::vector<Vertex>& moved = sweeper.repair(crowded);
    order = sweeper.order();
    changing.change(order, moved);
  }
  NarrowOrder result;
  result.position = positions_by_level(order);
  if (crowded.empty()) {
    result.links = assign_arms(graph, order, changing.owners());
    return result;
  }
  const Components components = connected_components_of(graph);
  std::vector<bool> is_crowded(components.count, false);
  for (const Vertex v : crowded) is_crowded[components.of[v]] = true;
  result.moved_components = std::count(is_crowded.begin(), is_crowded.end(), true);
  const Order moved = moved_order(graph);
  const std::vector<Position> by_paths = positions_by_paths(graph, moved);
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    if (!is_crowded[components.of[v]]) continue;
    order.rank[v] = moved.rank[v];
    result.position[v] = by_paths[v];
  }
  result.links = assign_arms(graph, order, choose_owners(graph, order));
  return result;
}

}  // namespace ar3d::compact_120
