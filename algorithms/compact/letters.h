#pragma once

// The diamond lattice in the four letters a = (1,1,1), b = (1,-1,-1), c = (-1,1,-1), d = (-1,-1,1),
// which sum to zero: a lattice point is Aa + Bb + Cc + Dd, and only the six differences of (A, B,
// C, D), its forms, matter. A line parallel to a letter keeps the three forms without that letter.

#include <array>
#include <cstdint>
#include <vector>

#include "ar3d/base/long_vector.h"
#include "ar3d/model/lattice.h"

namespace ar3d::compact {

enum Letter : std::uint8_t { kA = 0, kB = 1, kC = 2, kD = 3 };

/// Most vertices of a drawing. Widths: the widest strip has at most 91 sqrt(n) + 222 columns and
/// 0.52 sqrt(n) + 1 rows (docs/compact.md), so for n <= 2^27 all letter coordinates, their
/// differences and heights of an edge's points are at most 8 (columns + rows) + 32 < 2^24 in
/// absolute value.
inline constexpr std::uint32_t kMaxVertices = std::uint32_t{1} << 27;

/// (A, B, C, D).
using Letters = std::array<std::int32_t, 4>;

/// A place in the strip: cell (column i, row j) with i = j mod 2, and type t = 0 or 1.
struct Site {
  std::int32_t column = -1;
  std::int32_t row = 0;
  std::int32_t type = 0;
  bool is_set() const { return column >= 0; }
  friend bool operator==(const Site&, const Site&) = default;
};

/// The same place by the two forms of a vertex, U = AD and V = BC: U = 4i + 2t, V = 4j - 2t.
struct SiteForms {
  std::int32_t U = -1;
  std::int32_t V = 0;
  bool is_set() const { return U >= 0; }
};
inline SiteForms forms_of(Site s) {
  return s.is_set() ? SiteForms{4 * s.column + 2 * s.type, 4 * s.row - 2 * s.type} : SiteForms{};
}
inline Site site_of(SiteForms p) {
  const std::int32_t type = p.U % 4 / 2;
  return {p.U / 4, (p.V + 2 * type) / 4, type};
}

/// The vertex at a site: g = 2(i + j), h = 2(i - j) + 2t, so that g = 0 and h = 2t modulo 4.
inline Letters letters_of(Site s) {
  const std::int32_t g = 2 * (s.column + s.row);
  const std::int32_t h = 2 * (s.column - s.row) + 2 * s.type;
  return {g + h, g, h, 0};
}

/// Height z = A + D - B - C: letters a and d go up by one, b and c down.
inline std::int32_t height(const Letters& p) { return p[kA] + p[kD] - p[kB] - p[kC]; }

inline Point to_point(const Letters& p) {
  const std::int64_t U = std::int64_t{p[kA]} - p[kD];
  const std::int64_t V = std::int64_t{p[kB]} - p[kC];
  return {U + V, U - V, height(p)};
}

/// The point of z = 0 of a vertex at a place: to_point(letters_of(site_of(place))).
inline Point to_point(SiteForms p) { return {std::int64_t{p.U} + p.V, std::int64_t{p.U} - p.V, 0}; }

/// The site of a vertex at a point of z = 0 that to_point gave.
inline Site site_of(Point p) {
  return site_of(SiteForms{static_cast<std::int32_t>((p.x + p.y) / 2),    // 4i + 2t >= 0
                           static_cast<std::int32_t>((p.x - p.y) / 2)});  // 4j - 2t >= -2
}

/// The cells (i, j), 0 <= i < columns, 0 <= j < rows, i = j mod 2.
struct StripSize {
  std::int32_t columns = 1;
  std::int32_t rows = 1;
  std::int32_t reach = 1;  ///< an edge spans at most this many columns
  friend bool operator==(const StripSize&, const StripSize&) = default;
};

/// A filled strip: what a drawing is made of.
struct Placement {
  StripSize size;
  UnwrittenVector<SiteForms> places;  ///< by vertex
  std::vector<std::uint8_t> variant;  ///< by edge: in which of its words it is routed
};

}  // namespace ar3d::compact
