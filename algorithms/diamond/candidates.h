#pragma once

// The modes of Theorem 1's drawing as candidates, of which each effort keeps one.

#include <array>
#include <optional>

#include "ar3d/algorithms/diamond/routes.h"

namespace ar3d::diamond {

/// Value of the counter `mode`.
enum class Mode { guaranteed = 0, alternating = 1, pairs = 2, joint = 3, annealed = 4 };

struct Candidate {
  Placement placement;
  Tracks tracks;
  std::vector<Counter> counters;
  std::optional<std::array<std::int64_t, 3>> instance_bound;
};

/// 3 * x-extent and 3 * y-extent <= 16n, z-extent <= 8n.
bool fits_theorem_box(const std::array<std::int64_t, 3>& extents, std::uint64_t n);

/// Always fits the theorem's box (n >= 1).
Candidate guaranteed_candidate(const Graph& graph, Items green, Items red);

/// Alternating parity; nothing if it passes the theorem's box.
std::optional<Candidate> alternating_candidate(const Graph& graph, Items green, Items red);

/// The candidate of least volume among the guaranteed mode, alternating parity, pairs, joint
/// rotation, and annealed parity with and without it.
Candidate smallest(const Graph& graph, const Items& green, const Items& red);

}  // namespace ar3d::diamond
