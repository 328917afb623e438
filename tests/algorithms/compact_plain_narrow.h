#pragma once

// fill_narrow_strip as plainly as the rules are stated: every cell is held against the Strip.

#include <algorithm>
#include <optional>

#include "ar3d/algorithms/compact/fill.h"

namespace ar3d::compact {

struct Columns {
  std::int32_t low = 0;
  std::int32_t high = 0;
};

/// Puts vertices at random cells of one strip.
class PlainPlacer {
 public:
  PlainPlacer(Strip& strip, RandomStream& random, Census& census)
      : strip_(strip), random_(random), census_(census) {}

  bool place(Vertex v) {
    const Columns columns = columns_for(strip_.joined(v));
    for (int trial = 0; trial < kNarrowTrials; ++trial) {
      ++census_.trials;
      const Site site = draw_site(v, columns);
      if (site.is_set() && strip_.try_place(v, site)) return true;
    }
    return false;
  }

  strips::FewVertices placed_neighbours(Vertex v) const {
    strips::FewVertices placed;
    for (const HalfEdge& edge : strip_.roles(v)) {
      if (edge.to != kNobody && strip_.is_placed(edge.to)) placed.push_back(edge.to);
    }
    return placed;
  }

  void remove(Vertex v) { strip_.remove(v); }

 private:
  /// Unset if no column is left in the row drawn.
  Site draw_site(Vertex v, const Columns& columns) {
    const auto row =
        static_cast<std::int32_t>(random_.below(static_cast<std::uint32_t>(strip_.size().rows)));
    const std::int32_t first = columns.low + ((columns.low ^ row) & 1);
    if (first > columns.high) return {};
    const auto choices = static_cast<std::uint32_t>((columns.high - first) / 2 + 1);
    const std::int32_t column = first + 2 * static_cast<std::int32_t>(random_.below(choices));
    return {column, row, type_for(v, column)};
  }

  /// The columns that reach and the types of placed tails leave to v.
  Columns columns_for(const Joined& joined) const {
    const StripSize& size = strip_.size();
    Columns columns{0, size.columns - 1};
    for (const auto& [role, edge, other] : joined) {
      columns.low = std::max(columns.low, other.column - size.reach);
      columns.high = std::min(columns.high, other.column + size.reach);
      if (role != kGreenIn) continue;
      if (other.type == 0) {
        columns.low = std::max(columns.low, other.column + 1);
      } else {
        columns.high = std::min(columns.high, other.column - 1);
      }
    }
    return columns;
  }

  /// By the side of the green head; if that is to come, by the side that has more room.
  std::int32_t type_for(Vertex v, std::int32_t column) const {
    const Vertex head = strip_.roles(v)[kGreenOut].to;
    if (head != kNobody && strip_.is_placed(head)) return strip_.site(head).column < column ? 1 : 0;
    return 2 * column < strip_.size().columns ? 0 : 1;
  }

  Strip& strip_;
  RandomStream& random_;
  Census& census_;
};

/// What fill_narrow_strip fills, with the same numbers and the same census.
inline std::optional<Strip> fill_plainly(const Decomposition& links, std::size_t num_edges,
                                         const Tightness& tightness, RandomStream random,
                                         Census& census) {
  const auto n = static_cast<Vertex>(links.at.size());
  std::optional<Strip> strip(std::in_place, links, num_edges, narrow_size(n, tightness), 0);
  PlainPlacer placer(*strip, random, census);
  if (!strips::place_with_ejections(placer, strips::stack_of_vertices(n),
                                    strips::most_ejections(n, tightness), random, census)) {
    strip.reset();
  }
  return strip;
}

}  // namespace ar3d::compact
