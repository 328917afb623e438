#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ar3d/model/drawing.h"

namespace ar3d {

/// Red, green and blue, 0 to 255 each.
using Rgb = std::array<std::uint8_t, 3>;

/// Holds what the edges of a drawing are in its construction, read from the drawing itself; so a
/// drawing that comes from a file has them, too.
struct EdgeRoles {
  std::string title;  ///< what the roles are; empty if the construction is not known
  /// Their names, and their colours in the palette of Okabe and Ito, which colour-blind readers can
  /// tell apart; at least one; the last one: none of the others.
  std::vector<std::pair<std::string, Rgb>> roles;
  std::vector<std::uint8_t> edges;  ///< for each edge its role
};

/// The roles of
/// - `diamond` and `compact`: green edges run above the plane of the vertices, red ones, shown
///   orange, below (docs/theorem1.md, Lemma 1.2; docs/compact.md, Lemma C.3); so do those to the
///   right and to the left of `compact-120`, whose plane is 5x + 5y = 3z (docs/compact-120.md);
/// - `grid`: the label of a U-edge, or a defect (docs/theorem3.md, Coordinates, labels and planes);
/// - `two-bend`: whether the ends are arms or vertical (docs/theorem2.md, Types of vertices).
/// Of other drawings all edges have one role. O(n + m) time.
EdgeRoles edge_roles(const Drawing& drawing);

/// An order of the vertices in which a drawing grows, by weights . position, then by number: what
/// it is an order of, and the weights; zeros: the vertices' numbers alone.
using GrowthOrder = std::pair<std::string, std::array<std::int64_t, 3>>;

/// The construction's own order: `diamond` the green order (X of Theorem 1), `compact` the columns
/// of the strip, `two-bend` the time order (z), `two-bend-109` the order of the parts (z), `grid`
/// the number S that differs for all vertices of a component (I1), `grid-paper` the skewed height
/// of layers; of other drawings the order of the vertices' numbers.
GrowthOrder growth_order(const Drawing& drawing);

/// Largest extent of a drawing that a page shows: differences stay exact in JavaScript's numbers.
inline constexpr std::int64_t kMaxPageExtent = std::int64_t{1} << 52;

/// The geometry of a drawing for the viewer: a stream of whole numbers, each in groups of 7 bits, least first, the highest bit of a byte saying
/// that another follows; signed ones s as 2s, or -2s - 1 if s < 0:
/// - for each vertex its position less the one before it (the first: less `low`), signed x, y, z;
/// - for each edge: u less the u before it, signed; v - u, signed; the number of bends; the role;
///   for each bend its position less the point before it on the way from u, signed x, y, z.
/// @pre every extent of the drawing is at most kMaxPageExtent. O(n + bends) time.
std::string geometry_numbers(const Drawing& drawing, const EdgeRoles& roles, Point low);
/// Returns the same in base64 of zlib's deflate format.
std::string packed_geometry(const Drawing& drawing, const EdgeRoles& roles, Point low);

/// A text in base64 of zlib's deflate format.
std::string packed_text(std::string_view text);

}  // namespace ar3d
