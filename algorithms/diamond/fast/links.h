#pragma once

// What a step of a walk of Step 1.1 reads, and how the edges at a vertex are linked to chains.

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <bit>
#include <cstdint>
#include <utility>

#include "ar3d/algorithms/diamond/fast/marks_and_lanes.h"
#include "ar3d/base/long_vector.h"

namespace ar3d::diamond::fast {

/// The neighbours of all vertices, and of one of them.
using Records = PaddedNeighbours;
using Record = Records::value_type;

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

/// n <= 2^27, so it fits 29 bits.
using PortNumber = std::uint32_t;
inline constexpr PortNumber kNoPort = ~PortNumber{0};
inline constexpr PortNumber port(Vertex v, std::uint32_t entry) { return v << 2 | entry; }
inline constexpr Vertex vertex_of(PortNumber p) { return p >> 2; }
inline constexpr std::uint32_t entry_of(PortNumber p) { return p & 3; }

/// By which entry a chain goes on from an arrival, if the record has it; and whether the arrival is
/// kept in the stretch (1 or 0).
using Onward = std::pair<std::uint32_t, std::uint32_t>;

/// Links the entries (0, 1) and (2, 3) of every vertex.
struct LinkPairs {
  Onward operator()(Vertex, std::uint32_t entry) const { return {entry ^ 1u, 1}; }
  /// Identifies the chain of a kept arrival among the chains at the vertex.
  static std::uint32_t key(PortNumber arrival) { return arrival >> 1; }
  /// Identifies the chain that ends there among the chains at the vertex.
  std::uint32_t end_key(PortNumber end) const { return end >> 1; }
};

/// The directions of all edges: the mark of pair i of vertex v, number 2v + i, says by which of its
/// entries an edge enters the vertex. A pair of two edges is one in and one out.
inline std::uint32_t enters(const TwoBitMarks& directions, PortNumber p) {
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
  static std::uint32_t key(PortNumber arrival) { return arrival >> 2; }
  std::uint32_t end_key(PortNumber end) const {
    return vertex_of(end) * 2 + enters(*directions, end);
  }
  const TwoBitMarks* directions = nullptr;
};

}  // namespace ar3d::diamond::fast
