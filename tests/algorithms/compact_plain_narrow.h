#pragma once

// fill_narrow_strip as plainly as the rules are stated: every cell is held against all of them.

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "ar3d/algorithms/compact/fill.h"

namespace ar3d::compact {

/// Rules (a) to (e) of docs/compact.md: edges take pieces of contested lines, each in the first of
/// its variants that fits.
class PlainStrip {
 public:
  PlainStrip(const Decomposition& links, std::size_t num_edges, StripSize size)
      : links_(links),
        size_(size),
        sites_(links.at.size()),
        variant_(num_edges),
        piece_of_(num_edges),
        taken_(size),
        lines_(num_edges + links.num_green) {}

  const StripSize& size() const { return size_; }
  const Site& site(Vertex v) const { return sites_[v]; }
  bool is_placed(Vertex v) const { return sites_[v].is_set(); }
  const Roles& roles(Vertex v) const { return links_.at[v]; }
  const std::vector<std::uint8_t>& variant() const { return variant_; }

  /// Calls visit(role, edge, other) for v's edges to placed neighbours, which stand at `other`.
  template <class Visit>
  void for_each_neighbour(Vertex v, Visit visit) const {
    for (const ColourRole role : {kGreenOut, kGreenIn, kRedOut, kRedIn}) {
      const HalfEdge edge = roles(v)[role];
      if (edge.to != kNobody && is_placed(edge.to)) visit(role, edge.edge, sites_[edge.to]);
    }
  }

  bool try_place(Vertex v, Site site) {
    bool fits = !taken_.is_taken(place_of(site));
    std::vector<Piece> pieces;
    for_each_neighbour(v, [&](ColourRole role, EdgeId edge, Site other) {
      const bool out = is_out(role);
      fits = fits && route(edge, is_red(role), out ? site : other, out ? other : site, pieces);
    });
    if (roles(v)[kGreenIn].to != kNobody) fits = fits && take(arrival_line(site), pieces);
    if (!fits) return false;
    for (const Piece& piece : pieces) lines_.insert(piece);
    taken_.flip(place_of(site));
    sites_[v] = site;
    return true;
  }

  void remove(Vertex v) {
    const Site site = std::exchange(sites_[v], Site{});
    if (roles(v)[kGreenIn].to != kNobody) lines_.erase(arrival_line(site));
    for_each_neighbour(v, [&](ColourRole, EdgeId edge, Site) { lines_.erase(piece_of_[edge]); });
    taken_.flip(place_of(site));
  }

 private:
  bool take(const Piece& piece, std::vector<Piece>& pieces) const {
    for (const Piece& other : pieces) {
      if (other.overlaps(piece)) return false;
    }
    pieces.push_back(piece);
    return lines_.is_free(piece);
  }

  bool route(EdgeId edge, bool red, Site tail, Site head, std::vector<Piece>& pieces) {
    const std::int32_t across = head.column - tail.column;
    if (across == 0 || std::abs(across) > size_.reach) return false;
    if (!red && (across > 0) != (tail.type == 0)) return false;
    Shape shape{red, tail.type, head.type, across > 0, 0};
    for (; shape.variant < variants(red); ++shape.variant) {
      const Word word = word_of(shape);
      const Letters from = letters_of(tail);
      const auto lengths = long_lengths(word, from, letters_of(head));
      if (*std::min_element(lengths.begin(), lengths.end()) < 1) continue;
      piece_of_[edge] = middle_piece(word, red, middle_start(word, from, lengths), lengths[1]);
      variant_[edge] = static_cast<std::uint8_t>(shape.variant);
      const std::size_t before = pieces.size();
      if (take(piece_of_[edge], pieces)) return true;
      pieces.resize(before);
    }
    return false;
  }

  const Decomposition& links_;
  StripSize size_;
  std::vector<Site> sites_;
  std::vector<std::uint8_t> variant_;  ///< by edge, as its piece
  std::vector<Piece> piece_of_;
  TakenPlaces taken_;
  strips::Lines lines_;
};

struct Columns {
  std::int32_t low = 0;
  std::int32_t high = 0;
};

/// Puts vertices at random cells of one strip.
class PlainPlacer {
 public:
  PlainPlacer(PlainStrip& strip, RandomStream& random, Census& census)
      : strip_(strip), random_(random), census_(census) {}

  bool place(Vertex v) {
    const Columns columns = columns_for(v);
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
  Columns columns_for(Vertex v) const {
    const StripSize& size = strip_.size();
    Columns columns{0, size.columns - 1};
    strip_.for_each_neighbour(v, [&](ColourRole role, EdgeId, Site other) {
      columns.low = std::max(columns.low, other.column - size.reach);
      columns.high = std::min(columns.high, other.column + size.reach);
      if (role == kGreenIn && other.type == 0) {
        columns.low = std::max(columns.low, other.column + 1);
      } else if (role == kGreenIn) {
        columns.high = std::min(columns.high, other.column - 1);
      }
    });
    return columns;
  }

  /// By the side of the green head; if that is to come, by the side that has more room.
  std::int32_t type_for(Vertex v, std::int32_t column) const {
    const Vertex head = strip_.roles(v)[kGreenOut].to;
    if (head != kNobody && strip_.is_placed(head)) return strip_.site(head).column < column ? 1 : 0;
    return 2 * column < strip_.size().columns ? 0 : 1;
  }

  PlainStrip& strip_;
  RandomStream& random_;
  Census& census_;
};

/// What fill_narrow_strip fills, with the same numbers and the same census.
inline std::optional<PlainStrip> fill_plainly(const Decomposition& links, std::size_t num_edges,
                                              const Tightness& tightness, RandomStream random,
                                              Census& census) {
  const auto n = static_cast<Vertex>(links.at.size());
  std::optional<PlainStrip> strip(std::in_place, links, num_edges, narrow_size(n, tightness));
  PlainPlacer placer(*strip, random, census);
  if (!strips::place_with_ejections(placer, strips::stack_of_vertices(n),
                                    strips::most_ejections(n, tightness), random, census)) {
    strip.reset();
  }
  return strip;
}

}  // namespace ar3d::compact
