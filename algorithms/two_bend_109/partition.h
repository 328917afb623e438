#pragma once

#include <boost/container/small_vector.hpp>
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

using PartVertices = boost::container::small_vector<Vertex, 2>;

struct VertexPart {
  PartKind kind = PartKind::single;
  /// Of a cycle in their order around it, of a body in the body's.
  PartVertices vertices;
  const SmallBody* body = nullptr;  ///< of a body
};

/// The ordered partition of Lemma E.2 of each component, all of them mixed; bodies come last.
/// @param graph  of maximum degree at most 4.
/// @param looked_at  gets the number of half-edges that the searches for cycles looked at, if not
/// null. Cost: O(n) and that number: a small multiple of n in practice, polynomial in n at worst.
std::vector<VertexPart> find_partition(const Graph& graph, std::uint64_t* looked_at = nullptr);

}  // namespace ar3d::two_bend_109
