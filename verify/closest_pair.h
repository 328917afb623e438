#pragma once

#include <optional>

#include "ar3d/model/drawing.h"

namespace ar3d::verify {

struct VertexPair {
  Vertex u;
  Vertex v;
};

/// Two vertices at the smallest distance in the drawing's metric; nothing if there are fewer than
/// two. Distances are compared exactly. Source: Golin, Raman, Schwarz, Smid, Simple randomized
/// algorithms for closest pair problems (1995), with a fixed random order. O(n) expected time and
/// memory.
std::optional<VertexPair> closest_pair(const Drawing& drawing);

}  // namespace ar3d::verify
