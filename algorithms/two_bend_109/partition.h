#pragma once

#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "ar3d/model/graph.h"
#include "ar3d/model/lattice.h"

namespace ar3d::two_bend_109 {

/// A finished drawing of a small graph, on points of kAxisLattice whose smallest coordinates are 0.
/// It is crossing-free with two bends per edge, together with an endless ray straight down from
/// every leg; all angles, also of legs and rays, are at least arccos(-1/3).
struct SmallBody {
  struct BodyLink {
    Vertex u;
    Vertex v;
    Point bend_at_u;
    Point bend_at_v;
  };
  std::string name;
  std::int64_t
      slope;  ///< a ray may lean by one part in `slope` and still meets nothing of the body
  std::vector<Point> vertices;
  std::vector<BodyLink> links;
  /// Where edges to an earlier part leave, one for every vertex v of degree 3: the segment from v to
  /// that point is the edge's last one.
  std::vector<std::pair<Vertex, Point>> legs;
};

/// K4, W4, K5 - e, K3,3, K3,3 + e, K3,4 and K5: all graphs with degrees 3 and 4 without two
/// disjoint cycles (Lemma E.1).
const std::vector<SmallBody>& small_bodies();

/// Returns which body the graph is, null if none, and which vertex plays which of the body's. O(1):
/// larger graphs are none.
std::pair<const SmallBody*, std::vector<Vertex>> find_body(const Graph& graph);

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
