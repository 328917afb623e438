#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ar3d/algorithms/grid/colouring.h"
#include "ar3d/algorithms/grid/heights.h"
#include "ar3d/algorithms/grid/planes.h"

namespace ar3d::grid {

/// Finds numbers for one component after the other such that X_0 + X_1 stays small at every vertex
/// as long as the defects are few or local: then one side of the box is short and the volume grows
/// like n^2. A heuristic: (I1)-(I3) hold by construction, (I4) and (I5) are tested at the end.
class Flat {
 public:
  Flat(std::span<const NeighbourPlaces> neighbours, Colouring& colouring);

  /// Numbers one component. May change its labels, which leave the colouring's ports if they belong
  /// to a defect.
  /// @param defects  those of the component.
  /// @return false if a rule for a defect could not be kept; then its numbers and labels mean
  /// nothing. Cost: O(n log n) expected for n vertices of the component.
  bool number(PlaceRange part, std::span<const ColourDefect> defects);

  /// By place.
  std::span<const PlaneNumbers> numbers() const { return x_; }
  /// Of the last component numbered.
  const std::vector<ColourDefect>& defects() const { return defects_; }
  const std::vector<Slot>& slots() const { return slots_; }
  /// Of all components so far; the labelling's are not among them.
  const StepCounts& steps() const { return steps_; }

 private:
  bool number_once(PlaceRange part);

  std::span<const NeighbourPlaces> neighbours_;
  Colouring& colouring_;
  UnwrittenVector<PlaneNumbers> x_;
  std::vector<ColourDefect> defects_;
  std::vector<std::size_t> to_turn_;  // defects whose rules the last attempt could not keep
  std::vector<std::uint32_t> path_of_;
  std::vector<Place> buffer_;
  std::vector<Slot> slots_;
  StepCounts steps_;
};

}  // namespace ar3d::grid
