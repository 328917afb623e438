#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ar3d/algorithms/grid/colouring.h"
#include "ar3d/algorithms/grid/number_set.h"
#include "ar3d/algorithms/grid/planes.h"

namespace ar3d::grid {

/// Defects that hang on one another can ask for ever higher heights. They stop at this one, which
/// breaks a rule of theirs and leaves the component of n vertices to the core.
inline std::int64_t height_limit(std::int64_t n) {
  return std::min(64 * n + 10'000, std::int64_t{1} << 30);
}

/// Colours 0 and 1 of one component's numbers as heights: X_0 = h_0 and X_1 = -h_1, so a vertex
/// whose two heights are close together has a small X_0 + X_1. Invariant: every height of a colour
/// is taken once; the sums h_0 - h_1 of two vertices joined by an edge of colour 2 differ by at
/// least 2, which is (I2) for that edge.
class HeightPool {
 public:
  /// @param ports  without the half-edges of defects.
  /// @param x  numbers of all places; those of the component are unset.
  HeightPool(std::span<const Ports> ports, PlaceRange part, std::span<PlaneNumbers> x)
      : ports_(ports),
        part_(part),
        x_(x),
        taken_{NumberSet(part.size()), NumberSet(part.size())},
        frontier_(-part.size() / 4) {}

  PlaceRange part() const { return part_; }
  Place neighbour(Place v, Colour c) const { return ports_[v].to[c]; }
  bool ends_chain(Place v) const {
    return neighbour(v, 0) == kNoPlace || neighbour(v, 1) == kNoPlace;
  }
  bool has_height(Place v, Colour c) const { return x_[v][c] != kUnsetNumber; }
  bool is_numbered(Place v) const { return has_height(v, 0) && has_height(v, 1); }
  std::int64_t height(Place v, Colour c) const {
    return c == 0 ? x_[v][0] : -std::int64_t{x_[v][1]};
  }

  void set_height(Place v, Colour c, std::int64_t h) { x_[v][c] = narrow(c == 0 ? h : -h); }
  /// Marks a height as used.
  void take(Colour c, std::int64_t h);
  /// Marks a height as used; later chains begin near it or above.
  void take_and_advance(Colour c, std::int64_t h);

  /// Whether h, as v's height of colour c, keeps v's pair sum away from its partner's, as far as
  /// both are known.
  bool suits(Place v, Colour c, std::int64_t h) const;
  bool is_far_from_partner(Place v, std::int64_t pair) const;

  /// Asks for the memory of v, and then of its partner, before they are needed.
  [[gnu::always_inline]] void ask_for(Place v) const {
    __builtin_prefetch(&ports_[v]);
    __builtin_prefetch(&x_[v], 1);
  }
  [[gnu::always_inline]] void ask_for_neighbours(Place v) const { __builtin_prefetch(&ports_[v]); }
  [[gnu::always_inline]] void ask_for_partner(Place v) const {
    if (neighbour(v, 2) != kNoPlace) __builtin_prefetch(&x_[neighbour(v, 2)]);
  }

  /// The lowest free height >= from, and the lowest one whose successor is free, too.
  std::int64_t next_free(Colour c, std::int64_t from) {
    ++heights_tried_;
    return taken_[c].next_outside(from);
  }
  std::int64_t next_free_pair(Colour c, std::int64_t from) {
    ++heights_tried_;
    if (pairs_taken_.empty()) pairs_taken_ = {taken_[0].pairs(), taken_[1].pairs()};
    return pairs_taken_[c].next_outside(from);
  }
  /// Where a new chain begins: a free height near the frontier.
  std::int64_t chain_start(Colour c);
  /// Free heights looked at so far.
  std::int64_t heights_tried() const { return heights_tried_; }

 private:
  std::span<const Ports> ports_;
  PlaceRange part_;
  std::span<PlaneNumbers> x_;
  std::array<NumberSet, 2> taken_;
  std::vector<NumberSet>
      pairs_taken_;  // by colour: h with h or h + 1 taken; from the first slot on
  std::int64_t heights_tried_ = 0;
  std::int64_t frontier_;  // every chain begins near it
};

/// Numbers a path of colours 0 and 1 upwards from the end given.
void number_path(HeightPool& pool, Place end);

/// Numbers a cycle of colours 0 and 1 upwards along both of its sides at once, so that the sides
/// meet at about the same height. `buffer` is scratch.
void number_cycle(HeightPool& pool, Place start, std::vector<Place>& buffer);

}  // namespace ar3d::grid
