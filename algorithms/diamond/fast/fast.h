#pragma once

// Steps 1.1 and 1.2 for large graphs, at the speed of the memory.
//
// Read the plain version first: two_colouring() of colouring.h and extract_items() of items.h. They
// are the oracle. What stands here finds the same colouring and the same items, bit for bit, on any
// number of threads; tests compare the two on every family.
//
// Both steps walk along chains: Step 1.1 twice along chains of linked edges, to orient and to
// colour them, and Step 1.2 along the paths and cycles of one colour. Each step of a walk reads an
// address that only the step before it knows, so one walk waits for the memory at every step. Of
// many walks at a time each prefetches its next address, and the others step meanwhile.
//
//   cut      A vertex whose number is a multiple of the stride. A long chain is cut there, since
//            one chain may have all edges, and one walk along it would gain nothing.
//   stretch  A part of a chain between two cuts, between a cut and an end, or a whole chain with
//            two ends. Stretches are walked in any order and without writing any result.
//   lane     One of the walks that go on at a time, with a buffer for what its stretch keeps.
//   port     One end of an edge: 4 * vertex + entry, where the entry is the edge's number at the
//            vertex. A step leaves a vertex by a port and arrives at the next one by another.
//   piece    A stretch in its chain: whether the plain walk takes it backwards, and whether its
//            edges have odd numbers there. For that the stretches are linked in order; the plain
//            walk takes a chain from the smaller of its two ends or, if it is closed, out of its
//            smallest port.
//   marks    Two bits for each pair of entries, or vertex: nothing is known of it, or one bit is.
//            They are written along the pieces, and stay in the cache where the graph does not.
//            Records of 16 bytes, read at random, were dropped for them.
//
// A closed chain that passes no cut is walked from each of its vertices, in lanes, too; a walk that
// comes to a smaller vertex than its first stops there, as another walk begins or has begun at it.
// What a lane keeps stays where it was written: copying it took 4 to 6 % of the drawing (n = 10^5).

#include "ar3d/algorithms/diamond/colouring.h"
#include "ar3d/algorithms/diamond/items.h"

namespace ar3d::diamond::fast {

/// Sizes that decide how chains are walked, never what comes out; tests set them small.
struct WalkSizes {
  /// Every so many-th vertex is a cut; a power of two.
  std::uint32_t stride = 512;
  /// Walks of a thread at a time.
  std::uint32_t lanes = 48;
  std::uint32_t threads = 1;
};

/// two_colouring() of the graph. Cost: O(n + m), and 25 bytes per vertex while it runs.
/// @param graph  of maximum degree at most 4, n <= 2^27.
TwoColouring colouring(const Graph& graph, const WalkSizes& sizes);
/// With the fastest sizes, or by the plain walks where they are faster.
TwoColouring colouring(const Graph& graph);

/// extract_items(next). Cost: O(n).
Items items(const std::vector<HalfEdge>& next, const WalkSizes& sizes);
/// Likewise.
Items items(const std::vector<HalfEdge>& next);

}  // namespace ar3d::diamond::fast
