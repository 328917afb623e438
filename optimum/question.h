#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "ar3d/model/graph.h"
#include "ar3d/model/guarantee.h"

namespace ar3d::optimum {

/// Says along which diagonals edges run: those of unit cubes, at 109.47 degrees, or of their faces,
/// at 120 degrees.
enum class Diagonals : std::uint8_t { body, face };

/// Holds which drawings of a graph are asked for: along these diagonals, at exactly their angle.
struct Question {
  Diagonals diagonals = Diagonals::body;
  std::uint32_t max_bends = 3;  ///< per edge
  bool in_plane = false;        ///< all vertices in one plane across an axis
};

/// Counts lattice points along x, y and z: extents + 1.
using BoxSize = std::array<int, 3>;
inline std::int64_t volume_of(const BoxSize& box) { return std::int64_t{box[0]} * box[1] * box[2]; }
/// "8 x 8 x 7"
std::string to_string(const BoxSize& box);

inline constexpr std::uint32_t kMostBends = 16;
inline constexpr Vertex kMostVertices = 32;

/// Returns the unit steps, 8 or 12, each with its opposite.
std::vector<Vector> steps_of(Diagonals diagonals);

/// Returns what such a drawing promises; of the box nothing. Vertices in a plane have z = 0.
Guarantee guarantee_of(const Question& question);

/// @throws InputError if the graph is not connected, has no vertex or more than kMostVertices, or a
/// degree that the angle excludes; if the question has more than kMostBends.
void refuse_unanswerable(const Graph& graph, const Question& question);

}  // namespace ar3d::optimum
