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

constexpr int kTrials = 120;

struct Columns {
  std::int32_t low = 0;
  std::int32_t high = 0;
};

/// Puts vertices at random cells of one strip.
class Placer {
 public:
  Placer(Strip& strip, RandomStream& random, Census& census)
      : strip_(strip), random_(random), census_(census) {}

  /// Cells are drawn in batches, so that what the memory holds of one is on its way while others
  /// are looked at; which one is taken, and where the random stream goes on, is as if they were
  /// drawn one by one.
  bool place(Vertex v) {
    if (v + kAhead < strip_.num_vertices()) strip_.ask_for_neighbours(v + kAhead);
    const Joined joined = strip_.joined(v);
    const Columns columns = columns_for(joined);
    int tried = 0;
    for (int size = kFirstBatch; tried < kTrials; size = std::min(2 * size, kBatch)) {
      size = std::min(size, kTrials - tried);
      draw_batch(v, joined, columns, size);
      for (int i = 0; i < size; ++i) {
        const auto& [site, after, may_hold] = batch_[static_cast<std::size_t>(i)];
        ++census_.trials;
        if (!may_hold || !strip_.try_place(v, site)) continue;
        random_ = after;
        return true;
      }
      random_ = batch_[static_cast<std::size_t>(size - 1)].after;
      tried += size;
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
  static constexpr Vertex kAhead = 8;
  static constexpr int kFirstBatch = 4;
  static constexpr int kBatch = 16;
  struct Drawn {
    Site site;           ///< unset: no column is left in the row drawn
    RandomStream after;  ///< the stream behind it
    bool may_hold = false;
  };

  void draw_batch(Vertex v, const Joined& joined, const Columns& columns, int size) {
    RandomStream random = random_;
    for (int i = 0; i < size; ++i) {
      Drawn& drawn = batch_[static_cast<std::size_t>(i)];
      drawn.site = draw_site(v, columns, random);
      drawn.after = random;
      if (drawn.site.is_set()) strip_.ask_for_cell(drawn.site);
    }
    for (int i = 0; i < size; ++i) {
      Drawn& drawn = batch_[static_cast<std::size_t>(i)];
      drawn.may_hold = drawn.site.is_set() && strip_.may_hold(drawn.site, joined);
      if (drawn.may_hold) strip_.ask_for_lines(v, drawn.site, joined);
    }
  }

  Site draw_site(Vertex v, const Columns& columns, RandomStream& random) const {
    const auto row =
        static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(strip_.size().rows)));
    const std::int32_t first = columns.low + ((columns.low ^ row) & 1);
    if (first > columns.high) return {};
    const auto choices = static_cast<std::uint32_t>((columns.high - first) / 2 + 1);
    const std::int32_t column = first + 2 * static_cast<std::int32_t>(random.below(choices));
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
  std::vector<Drawn> batch_ = std::vector<Drawn>(kBatch, Drawn{{}, RandomStream(0), false});
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

std::optional<Strip> fill_narrow_strip(const Decomposition& links, std::size_t num_edges,
                                       const Tightness& tightness, RandomStream random,
                                       Census& census) {
  const auto n = static_cast<Vertex>(links.at.size());
  std::optional<Strip> strip(std::in_place, links, num_edges, narrow_size(n, tightness),
                             StripRules{});
  const std::int64_t ejections = tightness.ejections * n / 100 + 20;
  std::vector<Vertex> waiting(n);
  std::iota(waiting.rbegin(), waiting.rend(), 0);
  Placer placer(*strip, random, census);
  if (!strips::place_with_ejections(placer, std::move(waiting), ejections, random, census)) {
    strip.reset();
  }
  return strip;
}

}  // namespace ar3d::compact
