#pragma once

#include <string_view>

#include "ar3d/generators/catalog.h"
#include "ar3d/generators/graph_builder.h"

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

/// The largest multiple of `of` not above wanted, at least `least` times it.
constexpr Count multiple(Count wanted, Count of, Count least = 1) {
  return nearest_step(wanted, least * of, of);
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

/// n > degree, even where the degree is odd.
Count regular_sizes(Count wanted, const Settings& parameters);
/// inner + leaf (inner + 2).
Count cubic_tree_sizes(Count wanted, const Settings& parameters);
/// 1, 2, 4, 8, 16
Count hypercube_sizes(Count wanted, const Settings&);
/// 4 3^t
Count truncation_sizes(Count wanted, const Settings&);
/// 20 (a^2 + ab + b^2), a >= b
Count fullerene_sizes(Count wanted, const Settings& parameters);

// What they use as Family::generate, where the number of vertices has to be turned into other
// arguments of the family's function: called with a valid n and complete parameters.

Graph cubic_tree_of_size(std::uint64_t n, std::uint64_t seed, const Settings& parameters);
Graph random_cubic_tree_of_size(std::uint64_t n, std::uint64_t seed, const Settings&);
/// m = floor(n edges-per-vertex / 10^6), at most that of the complete graph for n <= degree.
/// @throws InputError if edges-per-vertex is above degree / 2.
Graph random_max_degree_of_size(std::uint64_t n, std::uint64_t seed, const Settings& parameters);
Graph truncation_of_size(std::uint64_t n, std::uint64_t, const Settings&);
Graph fullerene_of_size(std::uint64_t n, std::uint64_t, const Settings& parameters);

}  // namespace ar3d
