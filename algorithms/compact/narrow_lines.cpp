// Which lines of a narrow strip are empty (Lemma C.2: a line is fixed by two forms of its edges'
// ends). There are O(sqrt n) values of each, so a strip has O(n) lines: 20 for each vertex, most of
// them empty at any time. Two bits for each, 5 bytes per vertex in all, stay in the cache where the
// hash table of pieces does not. Cost: O(1) for each line that is asked for.
#include "ar3d/algorithms/compact/narrow_lines.h"

namespace ar3d::compact {
namespace {

// Ranges, with I columns, J rows and reach R of the strip: a tail is at column i and row j, a head
// at most R columns away, to the left of a tail of type 1. U is in 0 ... 4I - 2. Constants of words
// are at most 8 (CompactMiddleLines.*). Upper lines: AD is U of the head; the other form is g or h
// of a tail of type 0, in -2J ... 2I + 2J; or U of the head less h or g of a tail of type 1, where
// 4 (column of the head) - 2i is in -2R ... 2I and the rest in -2J - 2 ... 2J + 2. Lower lines: AD
// is U of the tail; BD is g of the head, or U of a tail less h of a head to its left, in 0 ... 2I +
// 2R + 2J + 2.
constexpr std::int32_t kMargin = 16;

}  // namespace

NarrowLines::NarrowLines(const StripSize& size, std::size_t num_edges) : pieces_(num_edges) {
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

void NarrowLines::erase(const Piece& piece) {
  for (Piece& late : late_) {
    if (late.line != 0) pieces_.insert(late);
    late = {};
  }
  if (!pieces_.erase(piece)) bits_[piece.line / 32] &= ~(kPiece << shift_of(piece.line));
}

}  // namespace ar3d::compact
