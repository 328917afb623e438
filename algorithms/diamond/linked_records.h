#pragma once

// What a step of a walk reads (Step 1.1 for large graphs), how edges are linked to chains, and the
// stretches of chains.

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "ar3d/algorithms/diamond/two_bit_marks.h"
#include "ar3d/base/threads.h"
#include "ar3d/model/graph.h"

namespace ar3d::diamond {

/// The neighbours of a vertex in the order of incident(v), padded with kNoVertex: a step of a walk
/// reads one record of 16 bytes.
using Record = std::array<Vertex, 4>;
using Records = UnwrittenVector<Record>;
inline constexpr Vertex kNoVertex = std::numeric_limits<Vertex>::max();

/// The entry of neighbour v, which is in the record once; without a branch, since no processor
/// foresees which entry it is.
inline std::uint32_t entry_to(const Record& record, Vertex v) {
#ifdef __SSE2__
  const __m128i entries = _mm_loadu_si128(reinterpret_cast<const __m128i*>(record.data()));
  const __m128i equal = _mm_cmpeq_epi32(entries, _mm_set1_epi32(static_cast<int>(v)));
  const int mask = _mm_movemask_ps(_mm_castsi128_ps(equal));
  return static_cast<std::uint32_t>(std::countr_zero(static_cast<unsigned>(mask)));
#else
  const unsigned odd = (record[1] == v) | (record[3] == v);
  const unsigned upper = (record[2] == v) | (record[3] == v);
  return odd | upper << 1;
#endif
}

/// An end of an edge: 4 * vertex + entry. n <= 2^27, so it fits 29 bits.
using Port = std::uint32_t;
inline constexpr Port port(Vertex v, std::uint32_t entry) { return v << 2 | entry; }
inline constexpr Vertex vertex_of(Port p) { return p >> 2; }
inline constexpr std::uint32_t entry_of(Port p) { return p & 3; }

/// By which entry a chain goes on from an arrival, if the record has it; and whether the arrival is
/// kept in the stretch (1 or 0).
struct Onward {
  std::uint32_t entry = 0;
  std::uint32_t kept = 1;
};

/// Links the entries (0, 1) and (2, 3) of every vertex.
struct LinkPairs {
  Onward operator()(Vertex, std::uint32_t entry) const { return {entry ^ 1u, 1}; }
  /// Of a kept arrival: tells it from those of other chains at the vertex.
  static std::uint32_t key(Port arrival) { return arrival >> 1; }
  /// Of the end of a chain: tells it from the vertex's other one.
  std::uint32_t end_key(Port end) const { return end >> 1; }
};

/// The directions of all edges: the mark of pair i of vertex v, number 2v + i, says by which of its
/// entries an edge enters the vertex. A pair of two edges is one in and one out.
inline std::uint32_t enters(const TwoBitMarks& directions, Port p) {
  return directions.bit(p >> 1) ^ (p & 1);
}

/// Links the two edges out of a vertex, and the two into it: one of each pair. Keeps the arrivals
/// against an edge's direction, which are all vertices that an edge leaves.
struct LinkSameDirection {
  Onward operator()(Vertex v, std::uint32_t entry) const {
    const std::uint32_t bits = directions->two_bits(2 * v);
    const std::uint32_t differ = (bits ^ bits >> 1) & 1;  // of the two pairs
    const std::uint32_t enters = bits >> (entry >> 1) ^ entry;
    return {entry ^ (2 | differ), ~enters & 1};
  }
  static std::uint32_t key(Port arrival) { return arrival >> 2; }
  std::uint32_t end_key(Port end) const { return vertex_of(end) * 2 + enters(*directions, end); }
  const TwoBitMarks* directions = nullptr;
};

/// A part of a chain, from the edge that leaves `start` on.
struct Stretch {
  Port start = 0;
  Port end = 0;                ///< the last arrival
  const Port* kept = nullptr;  ///< the kept arrivals
  std::uint32_t num_kept = 0;
  std::uint32_t size = 0;  ///< in edges
  bool starts_at_cut = false;
  bool ends_at_cut = false;
  /// The smallest port that the chain has inside the stretch, its ends not counted; which edge of
  /// the stretch is there, from 0 on; whether the stretch leaves by it or arrives.
  bool low_leaves = false;
  Port low = ~Port{0};
  std::uint32_t low_edge = 0;
};

/// A stretch in its chain. The plain walk takes a chain from the smaller of its two ends or, if it
/// is closed, out of its smallest port; an edge's number is its place in that walk.
struct Piece {
  const Stretch* stretch = nullptr;
  bool backwards = false;  ///< as the plain walk takes it
  std::uint32_t odd = 0;   ///< the number of the stretch's edge i is odd iff odd + i is
};

/// An arrival and the port by which the chain goes on, the latter number `leaving_edge`.
inline void take_low(Stretch& stretch, Port arrival, Port leaving, std::uint32_t leaving_edge) {
  if (std::min(arrival, leaving) >= stretch.low) return;
  stretch.low = std::min(arrival, leaving);
  stretch.low_leaves = leaving < arrival;
  stretch.low_edge = stretch.low_leaves ? leaving_edge : stretch.size - 1;
}

}  // namespace ar3d::diamond
