// Step E.3: slots get their x, spots their y, and vertices their heights in the order of the parts.
// A part begins so high that each edge down leans at most as much as its two stubs allow, as Lemma
// E.4 needs. Heights are computed in 128 bits and compared with 2^60, so they never wrap. Cost:
// O(n).
#include "ar3d/algorithms/two_bend_109/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "ar3d/base/error.h"

namespace ar3d::two_bend_109 {

__extension__ using Int128 = __int128;

std::int64_t LayoutScale::gap(SlotKind kind) const {
  switch (kind) {
    case SlotKind::single:
      return 5 * jitter + 95;
    case SlotKind::cycle:
      return 16 * jitter + 760;
    case SlotKind::triangle:
      return 40 * jitter + 1850;
  }
  throw InternalError("internal error: no gap for a kind of slot");
}

LayoutScale LayoutScale::always_enough(std::uint64_t num_vertices) {
  const auto n = static_cast<std::int64_t>(num_vertices);
  return {18 * n + 24, 36 * n + 64};
}

LayoutScale LayoutScale::next(std::uint64_t num_vertices) const {
  const LayoutScale enough = always_enough(num_vertices);
  return 2 * jitter < enough.jitter ? LayoutScale{2 * jitter, 2 * body_jitter} : enough;
}

namespace {

constexpr std::int64_t kLargest = std::int64_t{1} << 60;

class LayoutMaker {
 public:
  LayoutMaker(const OrderedGraph& graph, std::span<const VertexPart> parts,
              const SlotArrangement& arrangement, LayoutScale scale, std::uint32_t first_slot,
              Layout before)
      : graph_(graph),
        parts_(parts),
        arrangement_(arrangement),
        first_slot_(first_slot),
        made_(std::move(before)) {
    made_.scale = scale;
    made_.end_slot = first_slot;
    made_.position.resize(graph.num_vertices());
  }

  Layout run() {
    for (const VertexPart& part : parts_) {
      part.kind == PartKind::body ? raise_body(part) : raise(part);
    }
    return std::move(made_);
  }

 private:
  std::int64_t checked(Int128 value, Vertex v) const {
    if (value > kLargest || value < -kLargest) {
      throw InputError(fmt::format(
          "two-bend-109: a coordinate of vertex {} may pass 2^60, the graph is too large",
          graph_.names[v]));
    }
    return static_cast<std::int64_t>(value);
  }

  /// The slot's x, from that of the slot before it.
  Int128 x_of(std::uint32_t slot) {
    while (made_.end_slot <= slot) {
      const SlotKind* kind = &arrangement_.kind[made_.end_slot++];
      x_.push_back(x_.empty()
                       ? Int128{0}
                       : x_.back() + std::max(made_.scale.gap(kind[-1]), made_.scale.gap(kind[0])));
    }
    return x_[slot - first_slot_];
  }

  Vector offset_of(SlotSpot spot) const {
    const std::int64_t h = made_.scale.half_pair();
    const std::int64_t r = made_.scale.radius();
    switch (spot) {
      case SlotSpot::middle:
      case SlotSpot::centre:
        return {0, 0, 0};
      case SlotSpot::upper:
        return {0, h, 0};
      case SlotSpot::lower:
        return {0, -h, 0};
      case SlotSpot::right_corner:
        return {2 * r, 0, 0};
      case SlotSpot::upper_corner:
        return {-r, r, 0};
      case SlotSpot::lower_corner:
        return {-r, -r, 0};
      case SlotSpot::left_inside:
        return {-r / 2, 0, 0};
    }
    throw InternalError("internal error: no place for a spot");
  }

  /// Returns how much higher than b an end at `at` must be that leans by at most one part in
  /// `slope`, wherever both choose to stand, in squares of at most `jitter` points per side. The
  /// length of (dx, dy) is at most 3/2 dx + 5/2 dy.
  Int128 lift(Vertex b, Point at, std::int64_t slope, std::int64_t jitter) const {
    const Point p = made_.position[b];
    const Int128 dx = std::abs(at.x - p.x) + jitter + Int128{2} * kStubX;
    const Int128 dy = std::abs(at.y - p.y) + jitter + Int128{2} * kStubY;
    const std::int64_t least = std::max(slope, stubs_by_number(arrangement_.stubs[b]).up_slope);
    return least * ((3 * dx + 5 * dy) / 2 + 1) + Int128{2} * kStubZ;
  }

  void raise(const VertexPart& part) {
    Int128 base = Int128{top_} + kStep;
    for (const Vertex v : part.vertices) {
      graph_.prefetch_neighbours(v + kAhead, made_.position.data());
      const Vector offset = offset_of(arrangement_.spot[v]);
      made_.position[v] = {checked(x_of(arrangement_.slot[v]), v) + offset.x, offset.y, 0};
      for (const HalfEdge& half : graph_.incident(v)) {
        if (half.to >= part.vertices[0]) continue;
        const Int128 least =
            made_.position[half.to].z + lift(half.to, made_.position[v],
                                             stubs_by_number(arrangement_.stubs[v]).down_slope,
                                             made_.scale.jitter);
        base = std::max(base, least);
      }
    }
    const std::int64_t step = part.vertices.size() > 3 ? kCycleStep : kStep;
    for (const Vertex v : part.vertices) {
      top_ = made_.position[v].z = checked(base, v);
      base += step;
    }
  }

  /// The leg's edge to an earlier part, if there is one.
  const HalfEdge* edge_of(const VertexPart& part, Vertex v) const {
    for (const HalfEdge& half : graph_.incident(v)) {
      if (half.to < part.vertices[0]) return &half;
    }
    return nullptr;
  }

  /// Above everything, in the middle of its earlier neighbours.
  void raise_body(const VertexPart& part) {
    const SmallBody& body = *part.body;
    Int128 low_x = kLargest, high_x = -kLargest;
    for (const auto& [v, end] : body.legs) {
      const HalfEdge* half = edge_of(part, part.vertices[v]);
      if (half == nullptr) continue;
      low_x = std::min<Int128>(low_x, made_.position[half->to].x - end.x);
      high_x = std::max<Int128>(high_x, made_.position[half->to].x - end.x);
    }
    const Int128 x = low_x > high_x ? Int128{0} : (low_x + high_x) / 2;
    const Vertex first = part.vertices[0];
    Point base{checked(x, first), 0, 0};
    Int128 z = Int128{top_} + kStep;
    std::int64_t height = 0;
    for (const Point& p : body.vertices) height = std::max(height, p.z);
    for (const SmallBody::BodyLink& link : body.links) {
      height = std::max({height, link.bend_at_u.z, link.bend_at_v.z});
    }
    for (const auto& [v, end] : body.legs) {
      const HalfEdge* half = edge_of(part, part.vertices[v]);
      if (half == nullptr) continue;
      const Point below{base.x + end.x, end.y, 0};
      z = std::max(z, made_.position[half->to].z +
                          lift(half->to, below, body.slope, made_.scale.body_jitter) - end.z);
    }
    base.z = checked(z, first);
    top_ = checked(z + height, first);
    for (std::size_t i = 0; i < part.vertices.size(); ++i) {
      const Point& p = body.vertices[i];
      made_.position[part.vertices[i]] = {base.x + p.x, base.y + p.y, base.z + p.z};
    }
  }

  const OrderedGraph& graph_;
  std::span<const VertexPart> parts_;
  const SlotArrangement& arrangement_;
  std::uint32_t first_slot_;
  Layout made_;
  std::vector<Int128> x_;  ///< of each slot from the first one on
  std::int64_t top_ = 0;
};

}  // namespace

Layout lay_out(const OrderedGraph& graph, std::span<const VertexPart> parts,
               const SlotArrangement& arrangement, LayoutScale scale, std::uint32_t first_slot,
               Layout before) {
  return LayoutMaker(graph, parts, arrangement, scale, first_slot, std::move(before)).run();
}

}  // namespace ar3d::two_bend_109
