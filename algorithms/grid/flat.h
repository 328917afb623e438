#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "ar3d/algorithms/grid/labels.h"
#include "ar3d/algorithms/grid/number_search.h"
#include "ar3d/algorithms/grid/planes.h"

namespace ar3d::grid {

/// Holds where the three labelled half-edges of a vertex lead; one cache line holds four.
struct alignas(16) Ports {
  std::array<Index, kColours> to{kNoIndex, kNoIndex, kNoIndex};  ///< by label; kNoIndex: none
  std::uint32_t has_defect = 0;  ///< 1 if the labels of a half-edge to an earlier vertex differ
};

/// An edge whose two labels differ: label_x at x, label_y at y. One of them is 2 and belongs to y,
/// unless the labels are 0 and 1.
struct ColourDefect {
  Index x = 0;
  Index y = 0;
  EdgeId edge = 0;
  Colour label_x = 0;
  Colour label_y = 0;
};

/// Labels of all half-edges, with few defects.
/// Invariant: the labels at a vertex differ; the two labels of an edge are equal except on the edges
/// in `defects`. A component has at most one defect with labels 0 and 1.
struct Colouring {
  UnwrittenVector<Ports> ports;       // by index
  std::vector<ColourDefect> defects;  // component by component, in processing order
  std::uint64_t chain_steps = 0;      ///< edges of Kempe chains followed
};

/// Labels greedily in processing order and swaps Kempe chains where two earlier neighbours offer
/// the same label.
/// @param longest_chain  edges of the longest chain that is followed; 0: none.
/// Cost: O(n) and at most kStepsPerVertex chain steps per vertex on average.
Colouring colour_half_edges(const ProcessingOrder& order, std::span<const PlacedRow> neighbours,
                            std::uint64_t longest_chain);

/// All chains together take at most this many steps per vertex, so the time is linear on every
/// input.
inline constexpr std::uint64_t kStepsPerVertex = 100;

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
  /// @param x  numbers of all indices; those of the component are unset.
  HeightPool(std::span<const Ports> ports, const OrderPart& part, std::span<PlaneNumbers> x)
      : ports_(ports),
        part_(part),
        x_(x),
        taken_{NumberSet(part.size()), NumberSet(part.size())},
        frontier_(-part.size() / 4) {}

  const OrderPart& part() const { return part_; }
  Index neighbour(Index v, Colour c) const { return ports_[v].to[c]; }
  bool ends_chain(Index v) const {
    return neighbour(v, 0) == kNoIndex || neighbour(v, 1) == kNoIndex;
  }
  bool has_height(Index v, Colour c) const { return x_[v][c] != kUnsetNumber; }
  bool is_numbered(Index v) const { return has_height(v, 0) && has_height(v, 1); }
  std::int64_t height(Index v, Colour c) const {
    return c == 0 ? x_[v][0] : -std::int64_t{x_[v][1]};
  }

  void set_height(Index v, Colour c, std::int64_t h) { x_[v][c] = narrow(c == 0 ? h : -h); }
  /// Marks a height as used.
  void take(Colour c, std::int64_t h);
  /// Marks a height as used; later chains begin near it or above.
  void take_and_advance(Colour c, std::int64_t h);

  /// Returns whether h, as v's height of colour c, keeps v's pair sum away from its partner's, as
  /// far as both are known.
  bool suits(Index v, Colour c, std::int64_t h) const;
  bool is_far_from_partner(Index v, std::int64_t pair) const;

  /// Prefetches what is kept of v, and then of its partner.
  [[gnu::always_inline]] void prefetch(Index v) const {
    __builtin_prefetch(&ports_[v]);
    __builtin_prefetch(&x_[v], 1);
  }
  [[gnu::always_inline]] void prefetch_neighbours(Index v) const { __builtin_prefetch(&ports_[v]); }
  [[gnu::always_inline]] void prefetch_partner(Index v) const {
    if (neighbour(v, 2) != kNoIndex) __builtin_prefetch(&x_[neighbour(v, 2)]);
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
  /// Returns where a new chain begins: a free height near the frontier.
  std::int64_t chain_start(Colour c);
  /// Free heights looked at so far.
  std::int64_t heights_tried() const { return heights_tried_; }

 private:
  std::span<const Ports> ports_;
  OrderPart part_;
  std::span<PlaneNumbers> x_;
  std::array<NumberSet, 2> taken_;
  std::vector<NumberSet>
      pairs_taken_;  // by colour: h with h or h + 1 taken; from the first slot on
  std::int64_t heights_tried_ = 0;
  std::int64_t frontier_;  // every chain begins near it
};

/// Numbers a path of colours 0 and 1 upwards from the end given.
void number_path(HeightPool& pool, Index end);

/// Numbers a cycle of colours 0 and 1 upwards along both of its sides at once, so that the sides
/// meet at about the same height. `buffer` is scratch.
void number_cycle(HeightPool& pool, Index start, std::vector<Index>& buffer);

/// The slot kept for a defect (x: label_x, y: 2): heights low and low + 1 of colour 1 - label_x.
struct HeightSlot {
  std::int64_t low = 0;
  std::int64_t below_x = 0;  ///< x's height of that colour minus low
};

/// The paths of colours 0 and 1 of one component that end at the x of a defect.
/// Every x is put above its y in both heights, with the defect's slot between:
/// h_k(y) < low, low + 1 < h_k(x), h_l(x) - h_l(y) >= low + 2 - h_k(y) with l = label_x, k = 1 - l.
/// A path is numbered from its middle upwards to both ends; paths that wait for no other come first,
/// one above the other; the rest grow side by side, so that their ends come last.
class DefectPaths {
 public:
  /// @param paths_of  scratch for all indices, kNoPath everywhere; used while this lives.
  DefectPaths(HeightPool& pool, std::span<const ColourDefect> defects,
              std::vector<std::uint32_t>& path_of);
  ~DefectPaths();
  DefectPaths(const DefectPaths&) = delete;
  DefectPaths& operator=(const DefectPaths&) = delete;

  bool contains(Index v) const { return path_of_[v] != kNoPath; }
  /// To be called when all other chains have numbers.
  /// @return some defects of those that ask for x above y in a circle; none if all is well.
  std::vector<std::size_t> number_all();
  /// One slot a defect, in their order.
  const std::vector<HeightSlot>& slots() const { return slots_; }
  /// Attempts to finish an end so far.
  std::int64_t end_visits() const { return end_visits_; }

  static constexpr std::uint32_t kNoPath = std::numeric_limits<std::uint32_t>::max();

 private:
  enum class EndState : std::uint8_t { open, in_progress, done };

  /// Joint i stands before vertices[i], the last joint after the last vertex. The first vertex is
  /// an x; the last may be one.
  struct Path {
    std::vector<Index> vertices;
    Colour first_colour = 0;  // of joint 0
    bool both_ends = false;
    bool grown = false;
    std::array<EndState, 2> end{};
    std::uint32_t waits_for = 0;  // paths that hold a y of this one's ends
    std::size_t first = 0;        // joints first .. last - 1 are numbered before the ends
    std::size_t last = 0;
    std::size_t left = 0;  // joints left .. right - 1 are numbered
    std::size_t right = 0;
    std::int64_t floor = 0;
    std::array<std::int64_t, 2> side{};  // heights of joints left and right - 1
    Colour colour_of(std::size_t joint) const {
      return (joint & 1) == 0 ? first_colour : 1 - first_colour;
    }
    std::size_t steps() const {
      return last <= first ? 0 : both_ends ? (last - first) / 2 : last - first - 1;
    }
  };

  bool is_x(Index v) const { return !defects_at(v).empty(); }
  std::span<const std::size_t> defects_at(Index x) const;
  std::vector<std::size_t> blocked();
  void collect(std::span<const ColourDefect> defects);
  void add(Path path);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> find_waiting();
  void begin(Path& path);
  void grow(Path& path, unsigned side);
  void grow_alone(Path& path);
  void grow_together();
  void set_joint(Path& path, std::size_t joint, std::int64_t h);
  bool finish_ends(std::uint32_t path, int depth);
  bool finish_end(std::uint32_t path, unsigned side, int depth);
  bool number_lower_ends(std::span<const Index> xs, int depth);
  void place(std::span<const Index> xs);
  void place_colour(std::span<const Index> xs, Index x, Colour c);
  void keep_slot(std::size_t defect);
  std::int64_t least_height(Index x, Colour c) const;

  HeightPool& pool_;
  const std::int64_t height_limit_;
  const std::span<const ColourDefect> defects_;
  std::vector<std::size_t> by_x_;  // defects sorted by x
  std::vector<std::uint32_t>& path_of_;
  std::vector<Path> paths_;
  std::vector<HeightSlot> slots_;
  std::int64_t end_visits_ = 0;
};

/// The slot's number k in (I5): colour 0 counts heights upwards, colour 1 downwards.
inline std::int64_t slot_number(const ColourDefect& defect, const HeightSlot& slot) {
  return defect.label_x == 0 ? -slot.low : slot.low + 1;
}

/// X_2 of one component whose other numbers are known: every edge of colour 2 gets about the first
/// number that makes both sums new and far from their neighbours' sums, (I1) and (I2). Then the
/// label-2 ends y of the defects get theirs, below X_2(x) if label_x = 0 and above it if label_x =
/// 1, far enough for the slot.
/// @param blocks  counts the blocks of 64 numbers that are looked at.
/// @return a defect of a circle of ends y that depend on one another; none if all is well.
std::vector<std::size_t> number_third_colour(std::span<const Ports> ports, const OrderPart& part,
                                             std::span<const ColourDefect> defects,
                                             std::span<const HeightSlot> slots,
                                             std::span<PlaneNumbers> x, std::int64_t& blocks);

/// Changes the labels of one component's defects by swapping two labels on the chain that begins at
/// a defect's end. Ports hold no half-edges of defects, so such a chain ends at a vertex of degree
/// below 3 or at the end of a defect, whose label there changes, too. A defect whose labels become
/// equal turns into an edge of the ports.
class Relabelling {
 public:
  /// @param ports  loses the half-edges of the defects.
  /// @param n  vertices of the component; chains are followed for about kStepsPerVertex n steps.
  Relabelling(std::span<const PlacedRow> neighbours, std::span<Ports> ports,
              std::vector<ColourDefect>& defects, std::int64_t n);

  /// Edges of chains followed, and defects met there.
  std::int64_t steps() const { return steps_; }
  /// Returns whether they are all used up.
  bool exhausted() const { return steps_ > most_steps_; }

  /// Swaps, splits or moves the defects with labels 0 and 1, which flat numbers do not support. To
  /// be called after all turns.
  /// @return whether none is left; false if exhausted().
  bool avoid_labels_0_1();
  /// Gives x the label 2, or y the label of x, of a defect whose labels differ: if the edge is
  /// still a defect, the old y is on top.
  void turn(std::size_t defect);
  /// Likewise. Moves the defect to another edge at x or y, which swaps two labels there.
  /// @return false if that edge does not exist or is a defect.
  bool slide(std::size_t defect, bool at_x);
  /// Forgets the defects that are none any more. Ends the use of this object.
  void drop_healed();

 private:
  struct DefectEnd {
    std::size_t defect = 0;
    bool is_x = false;
  };
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  Index index_of(const DefectEnd& end) const;
  Colour& label_of(const DefectEnd& end);
  /// The end of a defect, if any, where the chain from `end` ends that swaps its label with
  /// `wanted`.
  DefectEnd other_end(const DefectEnd& end, Colour wanted);
  DefectEnd find(Index v, Colour label);
  bool makes_labels_0_1(const DefectEnd& end, Colour wanted);
  bool swap_or_split(std::size_t defect);
  bool split(const DefectEnd& end);
  EdgeId edge_between(Index v, Index other) const;
  void swap_chain(const DefectEnd& end, Colour wanted);
  void settle(std::size_t defect);

  std::span<const PlacedRow> neighbours_;
  std::span<Ports> ports_;
  std::vector<ColourDefect>& defects_;
  const std::int64_t most_steps_;
  std::int64_t steps_ = 0;
  std::unordered_multimap<Index, std::size_t> by_index_;  // may name defects that have moved away
};

/// Steps 3.9 to 3.13: numbers the components that can have flat numbers.
/// @return the other ones. Cost: O(n log n) expected.
std::vector<OrderPart> number_flat(const Graph& graph, const ProcessingOrder& order,
                                   const PlaneOptions& options, Planes& planes);

}  // namespace ar3d::grid
