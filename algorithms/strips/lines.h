#pragma once

// The contested lines: those on which more than one edge may run. In both constructions (`compact`,
// `compact_120`) lines of different letters never meet, and all other lines are private to a
// vertex, so that a drawing is right if no two pieces here overlap.

#include <cstdint>
#include <limits>

#include "ar3d/base/long_vector.h"

namespace ar3d::strips {

/// A number for the line of a kind on which two forms have these values, |value| < 2^30; different
/// for different lines, not 0. @param kind  0 to 3.
std::uint64_t line_key(unsigned kind, std::int64_t first, std::int64_t second);

/// A closed interval on a line, along a coordinate that grows by one from lattice point to lattice
/// point.
struct Piece {
  std::uint64_t line = 0;
  std::int32_t low = 0;
  std::int32_t high = 0;
  bool overlaps(const Piece& other) const {
    return (line == other.line) & (low <= other.high) & (other.low <= high);  // as good as random
  }
  friend bool operator==(const Piece&, const Piece&) = default;
};

inline Piece whole_line(std::uint64_t line) {
  return {line, std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max()};
}

/// The pieces in use: open addressing with linear probing; 16 bytes per entry, at most 3/4 of them
/// in use.
class Lines {
 public:
  /// Room for `most` pieces.
  explicit Lines(std::size_t most);

  /// True if no stored piece overlaps this one (touching is overlapping). O(1) expected.
  bool is_free(const Piece& piece) const;
  /// Prefetches what is_free() of a piece on that line will read.
  void prefetch(std::uint64_t line) const { __builtin_prefetch(&entries_[home(line)]); }
  void insert(const Piece& piece);
  /// Removes a stored piece; true if its line has others. @throws InternalError if it is not
  /// stored.
  bool erase(const Piece& piece);

 private:
  std::size_t home(std::uint64_t line) const {
    return static_cast<std::size_t>((line * 0x9e3779b97f4a7c15u) >> shift_);
  }
  std::size_t next(std::size_t entry) const { return entry + 1 == entries_.size() ? 0 : entry + 1; }

  unsigned shift_ = 0;
  UnwrittenVector<Piece> entries_;  ///< line 0: empty
};

}  // namespace ar3d::strips
