#pragma once

// The contested lines of a narrow strip. A line is fixed by two forms of its edges' ends (Lemma
// C.2), and there are O(sqrt n) values of each, so a strip has O(n) lines: 20 for each vertex, most
// of them empty at any time. They can be numbered without many gaps, and two bits tell of each what
// is on it: 5 bytes per vertex in all stay in the cache where the hash table of pieces does not.
// Pieces are looked up only on lines that have some. Cost: O(1) for each line that is asked for.

#include <array>
#include <cstdint>

#include "ar3d/algorithms/compact/letters.h"
#include "ar3d/algorithms/compact/words.h"
#include "ar3d/algorithms/strips/lines.h"
#include "ar3d/base/long_vector.h"

namespace ar3d::compact {

/// Middle pieces of edges, and lines on which edges arrive; the latter belong to one edge as a
/// whole.
class NarrowLines {
 public:
  /// Room for a middle piece of each edge.
  NarrowLines(const StripSize& size, std::size_t num_edges);

  /// The number of the line of a kind with these values of its forms (words.h, line_key), not 0.
  /// They are those of edges between cells of the strip that span at most its reach and run to the
  /// side of their type.
  std::uint64_t number(LineKind kind, std::int32_t first, std::int32_t second) const {
    const Numbering& by = numbering_[static_cast<std::size_t>(kind) - 1];
    return by.begin +
           static_cast<std::uint64_t>((first - by.least_first) >> by.first_shift) * by.width +
           static_cast<std::uint64_t>((second - by.least_second) >> 2);
  }

  /// number(kind, first + by_first, second + by_second) - number(kind, first, second) where both
  /// are lines of the kind.
  std::uint64_t step(LineKind kind, std::int32_t by_first, std::int32_t by_second) const {
    const Numbering& by = numbering_[static_cast<std::size_t>(kind) - 1];
    return static_cast<std::uint64_t>(by_first >> by.first_shift) * by.width +
           static_cast<std::uint64_t>(by_second >> 2);  // modulo 2^64
  }

  /// True if no stored piece overlaps this one and no edge arrives on its line. O(1) expected.
  bool is_free(const Piece& piece) const {
    const std::uint64_t on_line = bits_of(piece.line);
    if (on_line == 0) return true;
    return (on_line & kArrival) == 0 && !overlaps_late(piece) && pieces_.is_free(piece);
  }
  /// True if nothing is on the line.
  bool is_empty(std::uint64_t line) const { return bits_of(line) == 0; }

  /// The hash table gets the piece kLate insertions later, when the memory has sent its entry.
  void insert(const Piece& piece) {
    bits_[piece.line / 32] |= kPiece << shift_of(piece.line);
    pieces_.prefetch(piece.line);
    Piece& late = late_[next_late_++ % kLate];
    if (late.line != 0) pieces_.insert(late);
    late = piece;
  }
  void erase(const Piece& piece);
  /// Begins or ends an arrival on the line.
  void flip_arrival(std::uint64_t line) { bits_[line / 32] ^= kArrival << shift_of(line); }

  // Prefetch what is_free() will read: always, and of lines with pieces.
  void prefetch(std::uint64_t line) const { __builtin_prefetch(&bits_[line / 32]); }
  void prefetch_pieces(std::uint64_t line) const {
    pieces_.prefetch(bits_of(line) == kPiece ? line
                                             : 0);  // some entry: no branch on what is random
  }

 private:
  static constexpr std::uint64_t kPiece = 1;
  static constexpr std::uint64_t kArrival = 2;
  /// Holds how lines of a kind are numbered: by AD, which is 0 modulo 4 above and odd below (Lemma
  /// C.4), then by the other form, which is 2 modulo 4.
  struct Numbering {
    std::uint64_t begin = 1;
    std::uint64_t width = 0;
    std::int32_t least_first = 0;
    std::int32_t least_second = 0;
    int first_shift = 2;
  };
  static unsigned shift_of(std::uint64_t line) { return static_cast<unsigned>(line % 32 * 2); }
  std::uint64_t bits_of(std::uint64_t line) const { return bits_[line / 32] >> shift_of(line) & 3; }

  static constexpr std::size_t kLate = 8;
  bool overlaps_late(const Piece& piece) const {
    bool overlaps = false;
    for (const Piece& late : late_) overlaps = overlaps || late.overlaps(piece);
    return overlaps;
  }

  std::array<Numbering, 3> numbering_;
  LongVector<std::uint64_t> bits_;  ///< two for each line
  strips::Lines pieces_;
  std::array<Piece, kLate> late_{};  ///< not yet among `pieces_`; line 0: none
  std::size_t next_late_ = 0;
};

// Ranges, with I columns, J rows and reach R of the strip: a tail is at column i and row j, a head
// at most R columns away, to the left of a tail of type 1. U is in 0 ... 4I - 2. Constants of words
// are at most 8 (CompactMiddleLines.*). Upper lines: AD is U of the head; the other form is g or h
// of a tail of type 0, in -2J ... 2I + 2J; or U of the head less h or g of a tail of type 1, where
// 4 (column of the head) - 2i is in -2R ... 2I and the rest in -2J - 2 ... 2J + 2. Lower lines: AD
// is U of the tail; BD is g of the head, or U of a tail less h of a head to its left, in 0 ... 2I +
// 2R + 2J + 2.
inline NarrowLines::NarrowLines(const StripSize& size, std::size_t num_edges) : pieces_(num_edges) {
  constexpr std::int32_t kMargin = 16;
  const std::int32_t columns = size.columns;
  const std::int32_t rows = size.rows;
  const std::int32_t reach = size.reach;
  std::uint64_t end = 1;
  for (const LineKind kind : {LineKind::upper_b, LineKind::upper_c, LineKind::lower_c}) {
    const bool lower = kind == LineKind::lower_c;
    Numbering& by = numbering_[static_cast<std::size_t>(kind) - 1];
    by.begin = end;
    by.least_first = -kMargin;
    by.first_shift = lower ? 1 : 2;
    by.least_second = -kMargin - (lower ? 0 : 2 * (reach + rows));
    const std::int32_t most_second = kMargin + 2 * (columns + rows + (lower ? reach : 0));
    by.width = static_cast<std::uint64_t>(most_second - by.least_second) / 4 + 1;
    const std::int32_t firsts = ((4 * columns + 2 * kMargin) >> by.first_shift) + 1;
    end += by.width * static_cast<std::uint64_t>(firsts);
  }
  bits_.assign(static_cast<std::size_t>(end / 32 + 1), 0);
}

inline void NarrowLines::erase(const Piece& piece) {
  for (Piece& late : late_) {
    if (late.line != 0) pieces_.insert(late);
    late = {};
  }
  if (!pieces_.erase(piece)) bits_[piece.line / 32] &= ~(kPiece << shift_of(piece.line));
}

}  // namespace ar3d::compact
