#pragma once

#include <string>
#include <string_view>

#include "ar3d/formats/drawings/edge_roles.h"
#include "ar3d/model/drawing.h"

namespace ar3d {

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
