#pragma once

#include <cstdint>
#include <string>

#include "ar3d/algorithms/algorithm.h"
#include "ar3d/model/graph.h"
#include "ar3d/model/real_points.h"

namespace ar3d::two_bend_paper {

/// The real types that a drawing can be made in.
enum class RealType : std::uint8_t {
  single_precision,    ///< float: 24 bits
  double_precision,    ///< double: 53 bits
  extended_precision,  ///< binary80: 64 bits
  binary128,           ///< 113 bits
  reference,           ///< 237 bits
};
inline constexpr int kRealTypes = 5;

/// "float", "double", "binary80", "binary128", "reference".
const char* to_string(RealType type);

/// Draws a simple graph of maximum degree 3 as Section 3 of the paper constructs it, in real
/// arithmetic: at most two bends per edge and, apart from rounding, no crossing, 120 degrees between
/// the three edges at a vertex, and at least 120 degrees at bends and other vertices. Every free
/// choice is made in double and does not depend on the type.
/// @return n vertices and the bends of all m edges, each from its end u to its end v; exactly what
/// the type made of them. Nothing is promised of their box.
/// @throws InputError if graph.max_degree() > 3, or if rounding makes a piece so short that a
/// coordinate is not finite. InternalError if a general position is not found.
/// Cost: O(n m) at worst for each cycle, O(N^2 log N) in all for N rays, O(k m) for k contracted
/// vertices that are left. Differs from the paper: docs/theorem2-paper.md lists every repair.
RealPoints draw_real(const Graph& graph, RealType type);

struct Options {
  RealType type = RealType::double_precision;
};

/// draw_real() as a drawing: exact points in Drawing::real, a picture of them in integers.
Drawing draw(const Graph& graph, const Options& options = {});

/// The catalogue row `two-bend-paper`, with the option `type`.
Algorithm row();

/// Returns how the arithmetic in which this library's drawings are made departs from IEEE 754, as
/// ar3d::arithmetic_departures() (base/ieee_arithmetic.h) finds.
std::string arithmetic_departures();

}  // namespace ar3d::two_bend_paper
