// What efforts 1 and 2 draw: a strip with about one cell per vertex, filled greedily at random. The
// rules (a) to (e) are all that a right drawing needs (Lemmas C.3 to C.5), so neither zones nor
// caps are kept. A vertex that finds no cell among 120 ejects a placed neighbour, as in cuckoo
// hashing. Nothing proves that this ends well, hence the bounded number of ejections and the zones
// behind it. Cost: O(n + ejections) cells tried, each in O(1) expected.
#include "ar3d/algorithms/compact/narrow.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "ar3d/algorithms/strips/square_root.h"

namespace ar3d::compact {
namespace {

struct Columns {
  std::int32_t low = 0;
  std::int32_t high = 0;
};

/// Puts vertices at random cells of one strip.
class Placer {
 public:
  Placer(Strip& strip, RandomStream& random, Census& census)
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
      if (edge.to != kNobody && strip_.is_placed(edge.to)) placed.at[placed.count++] = edge.to;
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

}  // namespace

StripSize narrow_size(std::int64_t n, const Tightness& tightness) {
  const std::int64_t rows = strips::square_root(tightness.rows * tightness.rows * n) / 100 + 2;
  const std::int64_t cells = tightness.cells * n / 100 + 1;
  const std::int64_t columns = 2 * cells / rows + tightness.extra_columns;
  const std::int64_t reach = tightness.reach * columns / 100 + tightness.extra_reach;
  return {static_cast<std::int32_t>(columns), static_cast<std::int32_t>(rows),
          static_cast<std::int32_t>(std::min(reach, columns))};
}

std::int64_t most_ejections(std::int64_t n, const Tightness& tightness) {
  return tightness.ejections * n / 100 + 20;
}

std::vector<Vertex> stack_of_vertices(Vertex n) {
  std::vector<Vertex> waiting(n);
  std::iota(waiting.rbegin(), waiting.rend(), 0);
  return waiting;
}

std::optional<Strip> fill_narrow_strip(const Decomposition& links, std::size_t num_edges,
                                       const Tightness& tightness, RandomStream random,
                                       Census& census) {
  const auto n = static_cast<Vertex>(links.at.size());
  std::optional<Strip> strip(std::in_place, links, num_edges, narrow_size(n, tightness),
                             StripRules{});
  Placer placer(*strip, random, census);
  if (!strips::place_with_ejections(placer, stack_of_vertices(n), most_ejections(n, tightness),
                                    random, census)) {
    strip.reset();
  }
  return strip;
}

}  // namespace ar3d::compact
