#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "ar3d/algorithms/grid/colouring.h"

namespace ar3d::grid {

/// Changes the labels of one component's defects by swapping two labels on the chain that begins at
/// a defect's end. Ports hold no half-edges of defects, so such a chain ends at a vertex of degree
/// below 3 or at the end of a defect, whose label there changes, too. A defect whose labels become
/// equal turns into an edge of the ports.
class Relabelling {
 public:
  /// @param ports  loses the half-edges of the defects.
  /// @param n  vertices of the component; chains are followed for about kStepsPerVertex n steps.
  Relabelling(std::span<const NeighbourPlaces> neighbours, std::span<Ports> ports,
              std::vector<ColourDefect>& defects, std::int64_t n);

  /// Edges of chains followed, and defects met there.
  std::int64_t steps() const { return steps_; }
  /// Whether they are all used up.
  bool exhausted() const { return steps_ > most_steps_; }

  /// Swaps, splits or moves the defects with labels 0 and 1, which flat numbers do not support. To
  /// be called after all turns.
  /// @return whether none is left; false if exhausted().
  bool avoid_labels_0_1();
  /// Of a defect whose labels differ. Gives x the label 2, or y the label of x: if the edge is
  /// still a defect, the old y is on top.
  void turn(std::size_t defect);
  /// Likewise. Moves the defect to another edge at x or y, which swaps two labels there.
  /// @return false if that edge does not exist or is a defect.
  bool slide(std::size_t defect, bool at_x);
  /// Forgets the defects that are none any more. Ends the use of this object.
  void drop_healed();

 private:
  struct End {
    std::size_t defect = 0;
    bool is_x = false;
  };
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  Place place_of(const End& end) const;
  Colour& label_of(const End& end);
  /// The end of a defect, if any, where the chain from `end` ends that swaps its label with
  /// `wanted`.
  End other_end(const End& end, Colour wanted);
  End find(Place v, Colour label);
  bool makes_labels_0_1(const End& end, Colour wanted);
  bool swap_or_split(std::size_t defect);
  bool split(const End& end);
  EdgeId edge_between(Place v, Place other) const;
  void swap_chain(const End& end, Colour wanted);
  void settle(std::size_t defect);

  std::span<const NeighbourPlaces> neighbours_;
  std::span<Ports> ports_;
  std::vector<ColourDefect>& defects_;
  const std::int64_t most_steps_;
  std::int64_t steps_ = 0;
  std::unordered_multimap<Place, std::size_t> by_place_;  // may name defects that have moved away
};

}  // namespace ar3d::grid
