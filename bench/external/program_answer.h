#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"

namespace ar3d {

/// Holds what a program answers to one graph.
struct ProgramAnswer {
  std::optional<Drawing> drawing;                           ///< its edges are the graph's
  std::string refusal;                                      ///< why it draws none: {"error": "…"}
  double own_s = std::numeric_limits<double>::quiet_NaN();  ///< its own time, if it says so
};

/// Reads one line: a drawing in JSON lines as this program writes them (integers and a Gram
/// matrix), or
///   {"vertices":[[x,y,z],…],"edges":[[u,v,[[x,y,z],…]],…],"seconds":s}
/// with any decimal numbers: vertices in order, bends of an edge from u to v, all straight where
/// `edges` is left out, z = 0 where it is; `seconds` may be left out, too. A finite decimal is an
/// exact rational: all are multiplied by the least power of ten that makes them integers, the
/// drawing's unit, whose exponent the counter `decimals` tells.
/// @throws InputError if it is none of this, or no drawing of that graph; if a number has more than
/// 18 significant digits or an integer passes kMaxCoordinate.
ProgramAnswer parse_answer(const std::string& algorithm, const Graph& graph, std::string_view line);

}  // namespace ar3d
