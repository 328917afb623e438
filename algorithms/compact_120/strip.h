#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <vector>

#include "ar3d/algorithms/compact_120/letters.h"
#include "ar3d/algorithms/compact_120/order.h"
#include "ar3d/algorithms/strips/lines.h"
#include "ar3d/base/long_vector.h"

// The words of the edges: p (long), s1, q (long), s2, r (long), s3, from tail to head; s1, s2 and
// s3 have length 1. Edges to the left are mirror images of edges to the right.

namespace ar3d::compact_120 {

using strips::Piece;

/// The direction e_gain - e_lose.
struct UnitStep {
  std::uint8_t gain = 0;
  std::uint8_t lose = 1;
  friend bool operator==(const UnitStep&, const UnitStep&) = default;
};
inline void step(Quad& x, UnitStep d, std::int32_t length) {
  x[d.gain] += length;
  x[d.lose] -= length;
}
inline UnitStep mirrored(UnitStep d) {
  constexpr std::array<std::uint8_t, 4> kIndex = {0, 2, 1, 3};
  return {kIndex[d.lose], kIndex[d.gain]};
}

/// p, s1, q, s2, r, s3.
using Word = std::array<UnitStep, 6>;

/// Holds what determines the word of an edge.
struct Shape {
  bool right = true;  ///< from tail to head
  Arrival at = Arrival::on_12;
  unsigned variant = 0;  ///< below variants(at); 0 is the one of the size bound's proof
};

inline unsigned variants(Arrival at) { return at == Arrival::on_12 ? 2 : 1; }

/// The word of an edge to the right; it arrives at N on 12 or 20, at T on 12 or 01.
const Word& right_word(Arrival at, unsigned variant);

/// The word of any edge.
Word word_of(const Shape& shape);

/// An edge between two vertices, seen such that it runs to the right: the edge itself, or its
/// mirror image. Long lengths are forced by the two ends; the word fits if all are at least 1.
class Route {
 public:
  /// @param tail, head  the vertices' own points. O(1).
  Route(const Shape& shape, const Quad& tail, const Quad& head);

  const std::array<std::int32_t, 3>& lengths() const { return lengths_; }
  bool fits() const { return lengths_[0] >= 1 && lengths_[1] >= 1 && lengths_[2] >= 1; }
  /// At least the largest x0 + x2 of a bend: that of the first long segment's end, and 1.
  std::int32_t top() const { return tail_[0] + tail_[2] + lengths_[0] + 1; }
  /// The contested segment of the edge, its middle one (q).
  Piece middle() const;
  /// Appends the five bends from tail to head.
  void append_bends(std::vector<Point>& out) const;

 private:
  const Word* word_;  ///< never null
  bool right_;
  Quad tail_;  ///< of the edge to the right
  std::array<std::int32_t, 3> lengths_{};
};

/// Holds which places of a strip are free: one bit per cell and class, rows of one column and class
/// in line.
class FreePlaces {
 public:
  FreePlaces(std::int32_t columns, std::int32_t rows);

  bool is_free(Site site) const {
    const std::size_t bit = bit_of(site);
    return (words_[bit / 64] >> (bit % 64) & 1) != 0;
  }
  void flip(Site site) {
    const std::size_t bit = bit_of(site);
    words_[bit / 64] ^= std::uint64_t{1} << (bit % 64);
  }

  /// The first free row of the site's column and class from its own row on, not beyond `last`;
  /// larger than that if there is none. O(1 + rows / 64).
  std::int32_t next_row(Site site, std::int32_t last) const;

 private:
  std::size_t bit_of(Site site) const {
    return (static_cast<std::size_t>(site.of) * columns_ + static_cast<std::size_t>(site.column)) *
               rows_ +
           static_cast<std::size_t>(site.row);
  }

  std::size_t columns_;
  std::size_t rows_;
  LongVector<std::uint64_t> words_;  ///< 1: free
};

/// The cells (i, j), 0 <= i < columns, 0 <= j < rows.
struct StripSize {
  std::int32_t columns = 1;
  std::int32_t rows = 1;
  std::int32_t beyond = 16;  ///< how far edges may pass the box of the vertices (Lemma D.10)
  friend bool operator==(const StripSize&, const StripSize&) = default;
};

/// The vertices placed so far and the pieces of contested lines that their edges use. Invariants:
/// (a) every edge runs to the side that the order says; (b) all lengths are at least 1; (c) one
/// edge at an arm; (d) one vertex per cell and class; (e) no two pieces overlap: by Lemma D.6 these
/// are enough for a right drawing; (f) no edge leaves the box of Lemma D.10.
class Strip {
 public:
  /// @param whole_lines  an edge takes all of its contested line, and only variant 0 is used.
  Strip(const Links& links, std::size_t num_edges, StripSize size, bool whole_lines);

  /// True if v can be placed there. O(1) expected.
  bool fits(Vertex v, Site site);
  /// Places v if that keeps the invariants; routes its edges to placed neighbours in the first
  /// variants that fit. O(1) expected.
  bool try_place(Vertex v, Site site);
  /// Takes a placed vertex and its edges away; not with whole lines.
  void remove(Vertex v);

  // Prefetch the places of the neighbours of v; the edges of its neighbours; what remove() of a
  // neighbour reads of these.
  void prefetch_edges(Vertex v) const { __builtin_prefetch(&links_->at[v]); }
  void prefetch_neighbours(Vertex v) const;
  void prefetch_edges_of_neighbours(Vertex v) const;
  void prefetch_removal_of_neighbours(Vertex v) const;

  bool is_placed(Vertex v) const { return sites_[v].is_set(); }
  const Site& site(Vertex v) const { return sites_[v]; }
  const StripSize& size() const { return size_; }
  const Links& links() const { return *links_; }
  const FreePlaces& free() const { return free_; }
  /// The least slant of the tail (of a steep edge: of the head) at which an edge stays in the box,
  /// in its best variant. @param tail_t  t of the tail; across: |Dt|.
  std::int32_t least_slant(const ArmLink& link, std::int32_t tail_t, std::int32_t across) const {
    const std::int32_t start =
        link.runs_right() ? -top_right_ - 3 * tail_t / 2 : -top_left_ + 3 * tail_t / 2;
    return start + 1 + (link.is_steep() ? 5 * across / 2 : across);
  }
  /// By edge: the variant in which it is routed.
  const std::vector<std::uint8_t>& variant() const { return variant_; }

 private:
  /// Holds what placing one vertex would add: three edges at most.
  struct Plan {
    std::array<Piece, 3> pieces;
    std::array<EdgeId, 3> edges{};
    std::array<std::uint8_t, 3> variants{};
    std::size_t count = 0;
  };

  void erase_leaving();
  bool make_plan(Vertex v, Site site, Plan& plan) const;
  bool plan_edge(const ArmLink& link, const Quad& own, Plan& plan) const;
  void prefetch_line(const ArmLink& link, const Quad& own) const;

  const Links* links_;  ///< never null
  StripSize size_;
  bool whole_lines_;
  LongVector<Site> sites_;
  std::vector<std::uint8_t> variant_;
  FreePlaces free_;
  strips::Lines lines_;
  boost::container::static_vector<Piece, 3> leaving_;  ///< to be erased, when they have come
  std::int32_t top_right_;                             ///< of Route::top, edges to the right
  std::int32_t top_left_;                              ///< the same for edges to the left
};

}  // namespace ar3d::compact_120
