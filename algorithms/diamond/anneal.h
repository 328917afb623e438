#pragma once

// Compact modes of Theorem 1: parity classes by simulated annealing.

#include "ar3d/algorithms/diamond/items.h"

namespace ar3d::diamond {

/// Parities by vertex with few equal neighbours in the green and in the red order: every equal pair
/// costs a line, so this is a maximum cut of a graph of degree 4. Starts from alternating parity
/// and never returns a worse cut. Deterministic: integers and a fixed random stream. Cost: O(n) for
/// each of a fixed number of passes.
std::vector<std::uint8_t> annealed_parity(const Items& green, const Items& red);

/// Number of neighbours of equal parity in the two orders.
std::int64_t equal_neighbours(const Items& green, const Items& red,
                              const std::vector<std::uint8_t>& parity);

}  // namespace ar3d::diamond
