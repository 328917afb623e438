#pragma once

// Efforts 1 and 2 of Theorem 1: any parity class for each vertex instead of even coordinates, and
// gaps only where an apex would fall on a turn. Always right; small in practice, but without a
// proved box of their own.

#include <optional>
#include <utility>

#include "ar3d/algorithms/diamond/placement.h"

namespace ar3d::diamond {

// All return a placement and its hits, lines skipped because an apex would have fallen on a turn;
// nothing if the Y range passes 16n/3, which would put the drawing's x- or y-extent
// beyond it. Cost: O(n). The parity class of v is p(v) = X(v) mod 2 = Y(v) mod 2.

/// Places with the classes 0 1 0 1 along the green order: X takes neighbouring lines, so its range
/// is n - 1.
std::optional<std::pair<Placement, std::int64_t>> place_alternating(const Graph& graph, Items green,
                                                                    Items red);

/// Places with 0 0 1 1: no two vertices two apart have |dX| = 2; good with many triangles.
std::optional<std::pair<Placement, std::int64_t>> place_in_pairs(const Graph& graph, Items green,
                                                                 Items red);

/// @param parity  p(v) by vertex, 0 or 1.
std::optional<std::pair<Placement, std::int64_t>> place_by_parity(
    const Graph& graph, Items green, Items red, const std::vector<std::uint8_t>& parity);

/// Parities by vertex with few equal neighbours in the green and in the red order: every equal pair
/// costs a line, so this is a maximum cut of a graph of degree 4. Starts from alternating parity
/// and never returns a worse cut. Deterministic: integers and a fixed random stream. Cost: O(n) for
/// each of a fixed number of passes.
std::vector<std::uint8_t> annealed_parity(const Items& green, const Items& red);

/// Number of neighbours of equal parity in the two orders.
std::int64_t equal_neighbours(const Items& green, const Items& red,
                              const std::vector<std::uint8_t>& parity);

/// Rotates the largest green and the largest red cycle so that their closing edges, the longest
/// edges of most drawings, run short: a closing edge costs as height half the sum of its ends'
/// distances, in the other colour's order, from the cycle's nearer border. As the rotation of one
/// colour moves the ranks of the other, pairs are judged: a fixed number of random green edges,
/// each with every red edge. @return false if there are no two such cycles. Deterministic. Cost:
/// O(n).
bool rotate_jointly(Items& green, Items& red);

}  // namespace ar3d::diamond
