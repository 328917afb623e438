#pragma once

#include <string_view>

#include "ar3d/generators/catalog.h"
#include "ar3d/generators/graph_builder.h"

// What the catalogue's rows call where a family's number of vertices has to be turned into the
// arguments of its own function: Family::generate, called with a valid n and complete parameters.

namespace ar3d {

/// The value of a completed parameter that is never negative. @throws InternalError if it is
/// missing.
Count count_of(const Settings& parameters, std::string_view name);

/// The largest r with r^2 <= n.
Count root(Count n);

/// The largest first + k step not above wanted, else `first`.
constexpr Count nearest_step(Count wanted, Count first, Count step) {
  return wanted <= first ? first : wanted - (wanted - first) % step;
}

// What the catalogue's rows use as Family::nearest_n.

template <Count first>
Count from(Count wanted, const Settings&) {
  return wanted < first ? first : wanted;
}
template <Count first, Count step>
Count steps(Count wanted, const Settings&) {
  return nearest_step(wanted, first, step);
}
/// factor k^2, k >= 1
template <Count factor>
Count squares(Count wanted, const Settings&) {
  const Count k = root(wanted / factor);
  return factor * (k == 0 ? 1 : k * k);
}

/// Multiples of a parameter: rows * columns with columns >= 3.
Count torus_sizes(Count wanted, const Settings& parameters);
/// 2N with N > 2k.
Count petersen_sizes(Count wanted, const Settings& parameters);
/// Multiples of leaves + 1, of legs + 1.
Count star_sizes(Count wanted, const Settings& parameters);
Count caterpillar_sizes(Count wanted, const Settings& parameters);
/// n > degree, even where the degree is odd.
Count regular_sizes(Count wanted, const Settings& parameters);
/// inner + leaf (inner + 2).
Count cubic_tree_sizes(Count wanted, const Settings& parameters);
/// n >= 2b, and > 2b for 4-regular graphs: n >= 2b + 1.
Count circulant_sizes(Count wanted, const Settings& parameters);
/// 1, 2, 4, 8, 16
Count hypercube_sizes(Count wanted, const Settings&);
/// 4 3^t
Count truncation_sizes(Count wanted, const Settings&);
/// 2 around (rings + 1), rings >= 1
Count nanotube_sizes(Count wanted, const Settings& parameters);
/// 20 (a^2 + ab + b^2), a >= b
Count fullerene_sizes(Count wanted, const Settings& parameters);
/// 2N with N > 2j, 2k
Count i_graph_sizes(Count wanted, const Settings& parameters);
/// 3, 10, 35
Count odd_graph_sizes(Count wanted, const Settings&);
/// The named graph's own n.
Count named_sizes(Count wanted, const Settings& parameters);
/// Even, at least 6 bridges + 4.
Count bridges_sizes(Count wanted, const Settings& parameters);
/// length + (cycles - 1)(length - 1)
Count cactus_sizes(Count wanted, const Settings& parameters);

Graph stars_of_size(std::uint64_t n, std::uint64_t seed, const Settings& parameters);
Graph caterpillar_of_size(std::uint64_t n, std::uint64_t seed, const Settings& parameters);
Graph random_regular_of_size(std::uint64_t n, std::uint64_t seed, const Settings& parameters);
Graph cubic_tree_of_size(std::uint64_t n, std::uint64_t seed, const Settings& parameters);
Graph random_cubic_tree_of_size(std::uint64_t n, std::uint64_t seed, const Settings&);
/// m = floor(n edges-per-vertex / 10^6), at most that of the complete graph for n <= degree.
/// @throws InputError if edges-per-vertex is above degree / 2.
Graph random_max_degree_of_size(std::uint64_t n, std::uint64_t seed, const Settings& parameters);
Graph hypercube_of_size(std::uint64_t n, std::uint64_t, const Settings&);
Graph truncation_of_size(std::uint64_t n, std::uint64_t, const Settings&);
Graph nanotube_of_size(std::uint64_t n, std::uint64_t, const Settings& parameters);
Graph fullerene_of_size(std::uint64_t n, std::uint64_t, const Settings& parameters);
Graph odd_graph_of_size(std::uint64_t n, std::uint64_t, const Settings&);
Graph named_of_size(std::uint64_t, std::uint64_t, const Settings& parameters);
Graph random_cactus_of_size(std::uint64_t n, std::uint64_t seed, const Settings& parameters);

}  // namespace ar3d
