#pragma once

// fill_narrow_strip as plainly as the rules are stated: every cell is held against all of them.

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "ar3d/algorithms/compact/fill.h"

namespace ar3d::compact {

/// Puts vertices at random cells of one strip while rules (a) to (e) of docs/compact.md hold: edges
/// take pieces of contested lines, each in the first of its variants that fits.
class PlainPlacer {
 public:
  PlainPlacer(const Decomposition& links, std::size_t num_edges, StripSize size,
              RandomStream& random, Census& census)
      : links_(links),
        size_(size),
        sites_(links.at.size()),
        variant_(num_edges),
        piece_of_(num_edges),
        taken_(size),
        lines_(num_edges + links.num_green),
        random_(random),
        census_(census) {}

  bool place(const std::vector<Vertex>& waiting) {
    const Vertex v = waiting.back();
    const auto [low, high] = columns_for(v);
    for (int trial = 0; trial < kNarrowTrials; ++trial) {
      ++census_.trials;
      const Site site = draw_site(v, low, high);
      if (site.is_set() && try_place(v, site)) return true;
    }
    return false;
  }

  strips::FewVertices placed_neighbours(Vertex v) const {
    strips::FewVertices placed;
    for (const HalfEdge& edge : links_.at[v]) {
      if (edge.to != kNobody && sites_[edge.to].is_set()) placed.push_back(edge.to);
    }
    return placed;
  }

  void remove(Vertex v) {
    const Site site = std::exchange(sites_[v], Site{});
    if (has_arrival(v)) lines_.erase(arrival_line(site));
    for_each_neighbour(v, [&](ColourRole, EdgeId edge, Site) { lines_.erase(piece_of_[edge]); });
    taken_.flip(forms_of(site));
  }

  Placement placement() const {
    Placement placement{size_, {}, variant_};
    for (const Site& site : sites_) placement.places.push_back(forms_of(site));
    return placement;
  }

 private:
  bool has_arrival(Vertex v) const { return links_.at[v][kGreenIn].to != kNobody; }

  /// Calls visit(role, edge, other) for v's edges to placed neighbours, which stand at `other`.
  template <class Visit>
  void for_each_neighbour(Vertex v, Visit visit) const {
    for (const ColourRole role : {kGreenOut, kGreenIn, kRedOut, kRedIn}) {
      const auto [to, edge] = links_.at[v][role];
      if (to != kNobody && sites_[to].is_set()) visit(role, edge, sites_[to]);
    }
  }

  /// The columns that reach and the types of placed tails leave to v.
  std::pair<std::int32_t, std::int32_t> columns_for(Vertex v) const {
    std::int32_t low = 0;
    std::int32_t high = size_.columns - 1;
    for_each_neighbour(v, [&](ColourRole role, EdgeId, Site other) {
      low = std::max(low, other.column - size_.reach);
      high = std::min(high, other.column + size_.reach);
      if (role != kGreenIn) return;
      if (other.type == 0) low = std::max(low, other.column + 1);
      if (other.type == 1) high = std::min(high, other.column - 1);
    });
    return {low, high};
  }

  /// Unset if no column is left in the row drawn.
  Site draw_site(Vertex v, std::int32_t low, std::int32_t high) {
    const auto row =
        static_cast<std::int32_t>(random_.below(static_cast<std::uint32_t>(size_.rows)));
    const std::int32_t first = low + ((low ^ row) & 1);
    if (first > high) return {};
    const auto choices = static_cast<std::uint32_t>((high - first) / 2 + 1);
    const std::int32_t column = first + 2 * static_cast<std::int32_t>(random_.below(choices));
    return {column, row, type_for(v, column)};
  }

  /// By the side of the green head; if that is to come, by the side that has more room.
  std::int32_t type_for(Vertex v, std::int32_t column) const {
    const Vertex head = links_.at[v][kGreenOut].to;
    if (head != kNobody && sites_[head].is_set()) return sites_[head].column < column ? 1 : 0;
    return 2 * column < size_.columns ? 0 : 1;
  }

  bool try_place(Vertex v, Site site) {
    bool fits = !taken_.is_taken(forms_of(site));
    std::vector<Piece> pieces;
    for_each_neighbour(v, [&](ColourRole role, EdgeId edge, Site other) {
      const bool out = is_out(role);
      fits = fits && route(edge, is_red(role), out ? site : other, out ? other : site, pieces);
    });
    if (has_arrival(v)) fits = fits && take(arrival_line(site), pieces);
    if (!fits) return false;
    for (const Piece& piece : pieces) lines_.insert(piece);
    taken_.flip(forms_of(site));
    sites_[v] = site;
    return true;
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
      if (take(piece_of_[edge], pieces)) return true;
    }
    return false;
  }

  bool take(const Piece& piece, std::vector<Piece>& pieces) const {
    const auto overlaps = [&](const Piece& other) { return other.overlaps(piece); };
    if (std::ranges::any_of(pieces, overlaps) || !lines_.is_free(piece)) return false;
    pieces.push_back(piece);
    return true;
  }

  const Decomposition& links_;
  StripSize size_;
  std::vector<Site> sites_;
  std::vector<std::uint8_t> variant_;  ///< by edge, as its piece
  std::vector<Piece> piece_of_;
  TakenSites taken_;
  strips::Lines lines_;
  RandomStream& random_;
  Census& census_;
};

/// What fill_narrow_strip fills, with the same numbers and the same census.
inline std::optional<Placement> fill_plainly(const Decomposition& links, std::size_t num_edges,
                                             const Tightness& tightness, RandomStream random,
                                             Census& census) {
  const auto n = static_cast<Vertex>(links.at.size());
  PlainPlacer placer(links, num_edges, narrow_size(n, tightness), random, census);
  if (!strips::place_with_ejections(placer, strips::stack_of_vertices(n),
                                    strips::most_ejections(n, tightness), random, census)) {
    return std::nullopt;
  }
  return placer.placement();
}

}  // namespace ar3d::compact
