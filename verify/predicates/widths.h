#pragma once

#include <bit>
#include <compare>
#include <cstdint>

#include "ar3d/model/cosine_comparison.h"
#include "ar3d/model/lattice.h"

namespace ar3d::verify {

/// Holds what no component of the differences that a predicate looks at passes, by axis; below
/// 2^63.
struct Reach {
  std::uint64_t x = 0;
  std::uint64_t y = 0;
  std::uint64_t z = 0;

  /// Takes in a difference.
  void add(Vector d) {
    const auto size = [](std::int64_t c) {
      return c < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(c)
                   : static_cast<std::uint64_t>(c);
    };
    x = x < size(d.x) ? size(d.x) : x;
    y = y < size(d.y) ? size(d.y) : y;
    z = z < size(d.z) ? size(d.z) : z;
  }
};

/// Bits that hold every value a predicate computes in integers: all are below 2^bits in absolute
/// value, so that a type whose integers up to 2^bits are exact decides it exactly: 53 bits for
/// double, 63 for int64, 127 for __int128 (Lemma V.5 of docs/verify.md).
struct PredicateBits {
  int angle = 0;    ///< compare_cosine() of two directions
  int meeting = 0;  ///< meeting_kind() of two segments
  int height = 0;   ///< the height of a segment over a place that it passes over
};

/// The range check: pure, a few products. @param segments  of every segment's direction.
/// @param between  of the differences of the ends of two segments that are compared: twice
///   `segments` where their boxes meet, else the drawing's extents.
PredicateBits predicate_bits(const Reach& segments, const Reach& between, const Lattice& lattice,
                             Cosine cosine);
/// Returns the bits for segments whose boxes meet.
PredicateBits predicate_bits(const Reach& segments, const Lattice& lattice, Cosine cosine);

inline constexpr int kDoubleBits = 53;
inline constexpr int kInt64Bits = 63;
inline constexpr int kInt128Bits = 127;

/// compare_cosine() for many pairs of directions: in int64 where the pair's range proves it.
class AngleComparison {
 public:
  AngleComparison(const Lattice& lattice, Cosine cosine);

  /// As compare_cosine(lattice, u, v, cosine).
  std::strong_ordering operator()(Vector u, Vector v) const {
    if (bits(u) + bits(v) > room_) return compare_cosine(lattice_, u, v, cosine_);
    using cosine_comparison::converted;
    return cosine_comparison::compare(lattice_, converted<std::int64_t>(u),
                                      converted<std::int64_t>(v), cosine_);
  }

  /// int64 serves two directions whose bits() add up to at most so many.
  int room() const { return room_; }
  /// Every component is below 2^bits in absolute value.
  static int bits(Vector d) {
    const auto size = [](std::int64_t c) { return static_cast<std::uint64_t>(c < 0 ? -c : c); };
    return static_cast<int>(std::bit_width(size(d.x) | size(d.y) | size(d.z)));
  }

 private:
  Lattice lattice_;
  Cosine cosine_;
  int room_ = 0;
};

}  // namespace ar3d::verify
