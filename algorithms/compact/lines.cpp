// The hash table of contested lines, the only thing that vertices share (Lemma C.5 and its
// consequence). Open addressing with linear probing, Knuth's multiplicative hash and deletion by
// shifting back, so that no marks of deleted entries pile up. 16 bytes per piece, O(1) expected.
#include "ar3d/algorithms/compact/lines.h"

#include <bit>

#include "ar3d/model/error.h"

namespace ar3d::compact {

std::uint64_t line_key(LineKind kind, const Letters& through) {
  constexpr std::int64_t kOffset = std::int64_t{1} << 30;  // forms are below 2^24
  const std::int64_t first = std::int64_t{through[kA]} - through[kD];
  const std::int64_t second = kind == LineKind::upper_b ? std::int64_t{through[kC]} - through[kD]
                                                        : std::int64_t{through[kB]} - through[kD];
  return (static_cast<std::uint64_t>(kind) << 62) |
         (static_cast<std::uint64_t>(first + kOffset) << 31) |
         static_cast<std::uint64_t>(second + kOffset);
}

Lines::Lines(std::size_t most) {
  const std::size_t slots = std::bit_ceil(most + most / 3 + 2);
  shift_ = static_cast<unsigned>(64 - std::bit_width(slots - 1));
  slots_.resize(slots);
}

bool Lines::is_free(const Piece& piece) const {
  for (std::size_t slot = home(piece.line); slots_[slot].line != 0; slot = next(slot)) {
    if (slots_[slot].overlaps(piece)) return false;
  }
  return true;
}

void Lines::insert(const Piece& piece) {
  std::size_t slot = home(piece.line);
  while (slots_[slot].line != 0) slot = next(slot);
  slots_[slot] = piece;
}

void Lines::erase(const Piece& piece) {
  std::size_t gap = home(piece.line);
  while (!(slots_[gap] == piece)) {
    expect(slots_[gap].line != 0, "an erased piece was stored");
    gap = next(gap);
  }
  // Moves back what probing would no longer reach over the gap.
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t slot = next(gap); slots_[slot].line != 0; slot = next(slot)) {
    const std::size_t from_home = (slot - home(slots_[slot].line)) & mask;
    const std::size_t from_gap = (slot - gap) & mask;
    if (from_home < from_gap) continue;
    slots_[gap] = slots_[slot];
    gap = slot;
  }
  slots_[gap] = {};
}

}  // namespace ar3d::compact
