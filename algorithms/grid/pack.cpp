// Step 3.7. Components side by side: rows, layers of rows, the thickest first ("shelves"; Coffman,
// Garey, Johnson and Tarjan 1980). A move by a multiple of 6 adds integers to plane numbers and
// slots and leaves all residues. O(n + m + k log k) for k components.
#include <algorithm>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "ar3d/algorithms/grid/planes.h"
#include "ar3d/base/error.h"
#include "ar3d/model/drawing.h"

namespace ar3d::grid {
namespace {

__extension__ using Int128 = __int128;

constexpr std::int64_t kUnit = 6;  // moves by it along an axis change plane numbers by 1

/// A component's box in units: it covers [low, high) on every axis, bends included.
using Parcel = Box;

Point floor_units(Point p) {
  const auto floor = [](std::int64_t x) { return (x >= 0 ? x : x - (kUnit - 1)) / kUnit; };
  return {floor(p.x), floor(p.y), floor(p.z)};
}

class Packer {
 public:
  Packer(const Graph& graph, const ProcessingOrder& order, Planes& planes)
      : graph_(graph), order_(order), planes_(planes), routes_(planes.labels, planes.slots) {}

  void run() {
    for (std::size_t i = 0; i < order_.parts.size(); ++i) parcels_.push_back(measure(i));
    const std::vector<Point> at = positions();
    for (std::size_t i = 0; i < parcels_.size(); ++i) {
      const Point low = parcels_[i].low;
      move(i, {at[i].x - low.x, at[i].y - low.y, at[i].z - low.z});
    }
  }

 private:
  std::span<const Vertex> vertices(std::size_t part) const {
    const OrderPart& p = order_.parts[part];
    return {&order_.sequence[p.begin], p.end - p.begin};
  }

  Parcel measure(std::size_t part) {
    GrowingBox box;
    for (const Vertex v : vertices(part)) {
      const Point at_v = position(planes_.of[v]);
      box.add(at_v);
      for (const HalfEdge& half : graph_.incident(v)) {
        if (half.to < v) continue;
        bends_.clear();
        routes_.append_bends(half.edge, {v, half.to}, at_v, position(planes_.of[half.to]), bends_);
        for (const Point bend : bends_) box.add(bend);
      }
    }
    return {floor_units(box.low()), floor_units(box.high()) + Vector{1, 1, 1}};
  }

  /// The side of the layers: every parcel fits, and together they would fill about one layer.
  std::int64_t layer_side() const {
    std::int64_t side = 1;
    Int128 area = 0;
    for (const Parcel& parcel : parcels_) {
      const auto [thickness, length, width] = parcel.extents();
      side = std::max({side, length, width});
      area += static_cast<Int128>(length) * width;
    }
    std::int64_t too_small = 0;
    std::int64_t enough = 1;
    while (static_cast<Int128>(enough) * enough < area) enough *= 2;
    while (enough - too_small > 1) {
      const std::int64_t middle = too_small + (enough - too_small) / 2;
      (static_cast<Int128>(middle) * middle < area ? too_small : enough) = middle;
    }
    return std::max(side, enough);
  }

  /// Rows along y, rows side by side along z, layers of rows along x.
  std::vector<Point> positions() const {
    std::vector<std::size_t> sorted(parcels_.size());
    std::iota(sorted.begin(), sorted.end(), std::size_t{0});
    std::ranges::stable_sort(sorted, [&](std::size_t i, std::size_t j) {
      const auto a = parcels_[i].extents();
      const auto b = parcels_[j].extents();
      return a[0] != b[0] ? a[0] > b[0] : a[2] > b[2];
    });
    const std::int64_t side = layer_side();
    std::vector<Point> at(parcels_.size());
    Point next;              // where the next parcel goes
    std::int64_t layer = 0;  // thickness of the present layer
    std::int64_t row = 0;    // width of the present row
    for (const std::size_t i : sorted) {
      const auto [thickness, length, width] = parcels_[i].extents();
      if (next.y + length > side) next = {next.x, 0, next.z + std::exchange(row, std::int64_t{0})};
      if (next.z + width > side) {
        next = {next.x + std::exchange(layer, std::int64_t{0}), 0, 0};
        row = 0;
      }
      at[i] = next;
      next.y += length;
      row = std::max(row, width);
      layer = std::max(layer, thickness);
    }
    return at;
  }

  void move(std::size_t part, Point by) {
    const PlaneNumbers shift = {narrow(by.x + by.y - by.z), narrow(by.x - by.y + by.z),
                                narrow(by.y + by.z - by.x)};
    for (const Vertex v : vertices(part)) {
      for (const HalfEdge& half : graph_.incident(v)) {
        if (v < half.to) move_slot(half.edge, v, half.to, shift);
      }
      for (Colour c = 0; c < kColours; ++c) {
        planes_.of[v][c] = narrow(std::int64_t{planes_.of[v][c]} + shift[c]);
      }
    }
  }

  void move_slot(EdgeId e, Vertex v, Vertex to, const PlaneNumbers& shift) {
    const Colour here = planes_.labels.at(e, v, to);
    const Colour there = planes_.labels.at(e, to, v);
    if (here == there) return;
    const auto slot = std::ranges::lower_bound(planes_.slots, e, {}, &Slot::edge);
    if (slot != planes_.slots.end() && slot->edge == e) slot->k += shift[3 - here - there];
  }

  const Graph& graph_;
  const ProcessingOrder& order_;
  Planes& planes_;
  const Routes routes_;
  std::vector<Parcel> parcels_;
  std::vector<Point> bends_;
};

}  // namespace

void pack_components(const Graph& graph, const ProcessingOrder& order, Planes& planes) {
  if (order.parts.size() > 1) Packer(graph, order, planes).run();
}

}  // namespace ar3d::grid
