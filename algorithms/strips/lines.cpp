// The hash table of contested lines, the only thing that vertices share (Lemmas C.5 and D.6). Open
// addressing with linear probing, Knuth's multiplicative hash and deletion by shifting back, so
// that no marks of deleted entries pile up. 16 bytes per piece, O(1) expected.
#include "ar3d/algorithms/strips/lines.h"

#include <bit>

#include "ar3d/base/error.h"

namespace ar3d::strips {

std::uint64_t line_key(unsigned kind, std::int64_t first, std::int64_t second) {
  constexpr std::int64_t kOffset = std::int64_t{1} << 30;
  return (static_cast<std::uint64_t>(kind) << 62) |
         (static_cast<std::uint64_t>(first + kOffset) << 31) |
         static_cast<std::uint64_t>(second + kOffset);
}

Lines::Lines(std::size_t most) {
  const std::size_t entries = std::bit_ceil(most + most / 3 + 2);
  shift_ = static_cast<unsigned>(64 - std::bit_width(entries - 1));
  entries_.assign(entries, Piece{});
}

bool Lines::is_free(const Piece& piece) const {
  for (std::size_t entry = home(piece.line); entries_[entry].line != 0; entry = next(entry)) {
    if (entries_[entry].overlaps(piece)) return false;
  }
  return true;
}

void Lines::insert(const Piece& piece) {
  std::size_t entry = home(piece.line);
  while (entries_[entry].line != 0) entry = next(entry);
  entries_[entry] = piece;
}

bool Lines::erase(const Piece& piece) {
  std::size_t gap = home(piece.line);
  bool others = false;
  while (!(entries_[gap] == piece)) {
    expect(entries_[gap].line != 0, "an erased piece was stored");
    others = others || entries_[gap].line == piece.line;
    gap = next(gap);
  }
  // Moves back what probing would no longer reach over the gap.
  const std::size_t mask = entries_.size() - 1;
  for (std::size_t entry = next(gap); entries_[entry].line != 0; entry = next(entry)) {
    others = others || entries_[entry].line == piece.line;
    const std::size_t from_home = (entry - home(entries_[entry].line)) & mask;
    const std::size_t from_gap = (entry - gap) & mask;
    if (from_home < from_gap) continue;
    entries_[gap] = entries_[entry];
    gap = entry;
  }
  entries_[gap] = {};
  return others;
}

}  // namespace ar3d::strips
