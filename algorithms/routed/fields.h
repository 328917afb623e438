#pragma once

#include <span>
#include <vector>

#include "ar3d/algorithms/routed/box.h"

namespace ar3d::routed {

/// A vertex as an end of routes.
struct End {
  Spot at;
  Directions arms = 0;  ///< that a route may use
};

/// Least costs of reaching the points of a window from an end, for each number of bends and each
/// last direction. Points of the window have coordinates from its low corner on.
class CostFields {
 public:
  using Cost = std::int16_t;
  static constexpr Cost kInfinite = CostBox::kBlocked;
  static constexpr int kVector = 8;  ///< costs that are computed at once

  explicit CostFields(const PointClass& points) : points_(points) {}

  /// Fills fields for fewer than `layers` bends, in a window that holds all routes of at most so
  /// many steps from an end to within a radius of a point. With radius 0 nothing passes that point;
  /// else it is taken for free.
  /// @return whether routes of more steps could matter. Cost: O(layers x directions x window).
  bool open(const CostBox& box, const End& from, Spot to, int radius, int steps, int layers);

  int num_layers() const { return num_layers_; }
  /// The field for a number of bends and a last direction, of points of the window that can be
  /// passed; null if no route ends so.
  const Cost* field(int layer, int d) const {
    return fields_[static_cast<std::size_t>(layer)][static_cast<std::size_t>(d)];
  }
  Spot low() const { return low_; }    ///< the low corner, in the box
  Spot from() const { return from_; }  ///< the end, in the window
  /// Index of a point of the class in every field, if the point is at most a step outside.
  std::size_t index(Spot p) const {
    return static_cast<std::size_t>(parts_[row(p.x, p.y)].base + std::ptrdiff_t{p.z >> 1});
  }
  /// Cost of passing a point, its step included; kInfinite outside.
  Cost cost(std::size_t i) const { return costs_[i]; }
  /// Writes what it costs at least to arrive in direction d at the points of rows that begin in the
  /// box at p, p + (0, 0, 2) ...
  /// @param costs  row after row, of a multiple of kVector of points each.
  void write_arrivals(int d, std::span<const Spot> rows, std::span<Cost> costs) const;

 private:
  static constexpr int kPad = 2;  // infinite costs on both sides of what a row holds
  /// The part of a row that fields hold, in halves of z from its first point on.
  struct Row {
    int base = kPad;  // index of z = 0 or 1
    int first = 0;
    int vectors = 0;
    int points = 0;
    int in_box = 0;  // index of the first point
    std::size_t parity = 0;
  };
  std::size_t row(int x, int y) const {
    return static_cast<std::size_t>(std::ptrdiff_t{x + 1} * rows_ +
                                    (points_.is_body() ? y >> 1 : y) + 1);
  }
  int parity(int x, int y) const { return points_.is_body() ? x & 1 : (x + y) & 1; }
  int choose_rows(const CostBox& box, Spot to, int radius, int steps, Spot high);
  void copy_costs(const CostBox& box, int size);
  void allot(int layers, Directions first);
  void fill_rays();
  template <std::size_t kTurns>
  void sweep(int layer, int d);

  const PointClass& points_;
  Spot low_;
  Spot from_;
  int rows_ = 0;                   // of one x, with a border
  std::vector<Row> parts_;         // by row, with a border
  std::vector<std::size_t> used_;  // rows that are not empty, in order
  std::vector<Cost> costs_;
  std::vector<Cost> storage_;
  std::array<std::array<Cost*, kMostDirections>, kMostBends + 1> fields_{};
  int num_layers_ = 0;
};

}  // namespace ar3d::routed
