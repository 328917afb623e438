#pragma once

#include <cstdint>
#include <vector>

#include "ar3d/algorithms/two_bend_109/small_bodies.h"
#include "ar3d/model/graph.h"

namespace ar3d::two_bend_109 {

enum class PartKind : std::uint8_t {
  single,  ///< one vertex with at most 2 neighbours in later and at most 3 in earlier parts
  cycle,   ///< an induced cycle
  body,    ///< induces one of small_bodies(); no vertex has a neighbour in a later part
};

struct Part {
  PartKind kind = PartKind::single;
  std::vector<Vertex> vertices;  ///< of a cycle in their order around it, of a body in the body's
  const SmallBody* body = nullptr;  ///< of a body
};

/// The ordered partition of Lemma E.2; bodies come last.
/// @param graph  connected, of maximum degree at most 4.
/// Cost: O(n) and, for every cycle, what searches go through before they find one more cycle; near
/// O(n) in practice, polynomial in n at worst.
std::vector<Part> find_partition(const Graph& graph);

}  // namespace ar3d::two_bend_109
