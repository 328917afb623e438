#pragma once

// From a wanted number of vertices to the sizes that a family has, and from such a size to the
// arguments of the family's own function; the catalogue's rows name these.

#include <fmt/format.h>

#include <algorithm>

#include "ar3d/base/error.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/generators/families.h"
#include "ar3d/generators/random_graphs.h"

namespace ar3d {

/// The value of a completed parameter that is never negative. @throws InternalError if it is
/// missing.
inline Count count_of(const Settings& parameters, std::string_view name) {
  const std::int64_t value = value_of(parameters, name);
  expect(value >= 0, "a parameter read as a count is not negative");
  return static_cast<Count>(value);
}

/// The largest r with r^2 <= n.
inline Count root(Count n) {
  Count low = 0;
  Count high = Count{1} << 32;
  while (high - low > 1) {  // low^2 <= n < high^2 where high^2 fits 64 bits
    const Count middle = low + (high - low) / 2;
    (middle <= n / middle ? low : high) = middle;
  }
  return low;
}

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
  return std::max(first, wanted);
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
inline Count regular_sizes(Count wanted, const Settings& parameters) {
  const Count degree = count_of(parameters, "degree");
  return nearest_step(wanted, degree + 1, degree % 2 == 1 ? 2 : 1);
}

/// inner + leaf (inner + 2).
inline Count cubic_tree_sizes(Count wanted, const Settings& parameters) {
  const Count leaf = count_of(parameters, "leaf");
  return nearest_step(wanted, 2 * leaf, leaf + 1);
}

/// 1, 2, 4, 8, 16
inline Count hypercube_sizes(Count wanted, const Settings&) {
  Count n = 1;
  while (n < 16 && 2 * n <= wanted) n *= 2;
  return n;
}

/// 4 3^t
inline Count truncation_sizes(Count wanted, const Settings&) {
  Count n = 4;
  while (n <= wanted / 3) n *= 3;
  return n;
}

/// 20 (a^2 + ab + b^2), a >= b
inline Count fullerene_sizes(Count wanted, const Settings& parameters) {
  const Count b = count_of(parameters, "b");
  const auto size = [b](Count a) { return 20 * (a * a + a * b + b * b); };
  Count a = std::max<Count>(1, b);
  while (a < 8000 && size(a + 1) <= wanted) ++a;
  return size(a);
}

// What they use as Family::generate, where the number of vertices has to be turned into other
// arguments of the family's function: called with a valid n and complete parameters.

inline Graph cubic_tree_of_size(Count n, std::uint64_t, const Settings& parameters) {
  const Count leaf = count_of(parameters, "leaf");
  if (leaf == 6) throw InputError("leaf = 6: a leaf block has 5 or 7 vertices");
  const Count inner = (n - 2 * leaf) / (leaf + 1);
  const auto shape = count_of(parameters, "shape") == 0 ? TreeShape::kBalanced : TreeShape::kPath;
  return cubic_tree(inner, leaf == 7 ? inner + 2 : 0, shape);
}

inline Graph random_cubic_tree_of_size(Count n, std::uint64_t seed, const Settings&) {
  // n = 6 inner + 10 + 2 large with large near (inner + 2) / 2, and 0 <= large <= inner + 2.
  Count inner = (n - 10) / 7;
  while (n - 10 - 6 * inner > 2 * (inner + 2)) ++inner;
  return cubic_tree(inner, (n - 10 - 6 * inner) / 2, TreeShape::kRandom, seed);
}

/// m = floor(n edges-per-vertex / 10^6), at most that of the complete graph for n <= degree.
/// @throws InputError if edges-per-vertex is above degree / 2.
inline Graph random_max_degree_of_size(Count n, std::uint64_t seed, const Settings& parameters) {
  const Count degree = count_of(parameters, "degree");
  const Count per_million = count_of(parameters, "edges-per-vertex");
  if (2 * per_million > degree * 1000000) {
    throw InputError(fmt::format("edges-per-vertex = {} is above {}, the limit for degree {}",
                                 per_million, degree * 500000, degree));
  }
  const auto D = static_cast<std::uint32_t>(degree);
  return random_max_degree(n, D, std::min(n * per_million / 1000000, most_edges(n, D)), seed);
}

inline Graph fullerene_of_size(Count n, std::uint64_t, const Settings& parameters) {
  const Count b = count_of(parameters, "b");
  Count a = std::max<Count>(1, b);
  while (20 * (a * a + a * b + b * b) < n) ++a;
  return goldberg_coxeter(a, b);
}

}  // namespace ar3d
