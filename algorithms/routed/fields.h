#pragma once

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
  static constexpr int kVector = 8;  ///< rows are read in so many costs, also beyond their end

  explicit CostFields(const PointClass& points) : points_(points) {}

  /// Fills fields for fewer than `layers` bends, in a window that holds all routes of at most so
  /// many steps from an end to within a radius of a point. With radius 0 nothing passes that point;
  /// else it is taken for free.
  /// @return whether routes of more steps could matter. Cost: O(layers x directions x window).
  bool open(const CostBox& box, const End& from, Spot to, int radius, int steps, int layers);

  int num_layers() const { return num_layers_; }
  /// The field for a number of bends and a last direction; null if no route ends so.
  const Cost* field(int layer, int d) const {
    return fields_[static_cast<std::size_t>(layer)][static_cast<std::size_t>(d)];
  }
  Spot low() const { return low_; }    ///< the low corner, in the box
  Spot from() const { return from_; }  ///< the end, in the window
  /// Whether a point of the class lies in the window, and then its index in every field.
  bool is_open(Spot p) const;
  std::size_t index(Spot p) const {
    return static_cast<std::size_t>(row(p.x, p.y) * stride_ + (p.z >> 1) + 1);
  }
  /// Cost of passing a point, its step included.
  Cost cost(std::size_t i) const { return costs_[i]; }

 private:
  struct Range {
    int low;
    int high;
  };
  std::ptrdiff_t row(int x, int y) const {
    return std::ptrdiff_t{x} * rows_ + (points_.is_body() ? y >> 1 : y);
  }
  int parity(int x, int y) const { return points_.is_body() ? x & 1 : (x + y) & 1; }
  void clip_rows(Spot to, int radius, int steps);
  void copy_costs(const CostBox& box);
  void allot(int layers, Directions first);
  void fill_rays();
  void sweep(int layer, int d);

  const PointClass& points_;
  Spot low_;
  Spot from_;
  int width_ = 0;
  int rows_ = 0;
  int stride_ = 0;
  std::vector<Range> clip_;  // of y, by x
  std::vector<Cost> costs_;
  std::vector<Cost> storage_;
  std::array<std::array<Cost*, kMostDirections>, kMostBends + 1> fields_{};
  int num_layers_ = 0;
};

}  // namespace ar3d::routed
