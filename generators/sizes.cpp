// From a wanted number of vertices to the sizes that a family has, and from such a size to the
// arguments of the family's own function; the catalogue's rows name these.
#include "ar3d/generators/sizes.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "ar3d/base/error.h"
#include "ar3d/generators/blocks.h"
#include "ar3d/generators/lattices.h"
#include "ar3d/generators/named.h"
#include "ar3d/generators/polyhedra.h"
#include "ar3d/generators/random_graphs.h"
#include "ar3d/generators/trees.h"

namespace ar3d {

Count count_of(const Settings& parameters, std::string_view name) {
  const std::int64_t value = value_of(parameters, name);
  expect(value >= 0, "a parameter read as a count is not negative");
  return static_cast<Count>(value);
}

Count root(Count n) {
  Count low = 0;
  Count high = Count{1} << 32;
  while (high - low > 1) {  // low^2 <= n < high^2 where high^2 fits 64 bits
    const Count middle = low + (high - low) / 2;
    (middle <= n / middle ? low : high) = middle;
  }
  return low;
}

Count torus_sizes(Count wanted, const Settings& parameters) {
  const Count rows = count_of(parameters, "rows");
  return nearest_step(wanted, 3 * rows, rows);
}

Count petersen_sizes(Count wanted, const Settings& parameters) {
  return nearest_step(wanted, std::max<Count>(6, 2 * (2 * count_of(parameters, "k") + 1)), 2);
}

Count star_sizes(Count wanted, const Settings& parameters) {
  const Count size = count_of(parameters, "leaves") + 1;
  return nearest_step(wanted, size, size);
}

Count caterpillar_sizes(Count wanted, const Settings& parameters) {
  const Count size = count_of(parameters, "legs") + 1;
  return nearest_step(wanted, size, size);
}

Count regular_sizes(Count wanted, const Settings& parameters) {
  const Count degree = count_of(parameters, "degree");
  return nearest_step(wanted, degree + 1, degree % 2 == 1 ? 2 : 1);
}

Count cubic_tree_sizes(Count wanted, const Settings& parameters) {
  const Count leaf = count_of(parameters, "leaf");
  return nearest_step(wanted, 2 * leaf, leaf + 1);
}

Count circulant_sizes(Count wanted, const Settings& parameters) {
  return std::max(wanted, 2 * count_of(parameters, "b") + 1);
}

Count hypercube_sizes(Count wanted, const Settings&) {
  Count n = 1;
  while (n < 16 && 2 * n <= wanted) n *= 2;
  return n;
}

Count truncation_sizes(Count wanted, const Settings&) {
  Count n = 4;
  while (n <= wanted / 3) n *= 3;
  return n;
}

Count nanotube_sizes(Count wanted, const Settings& parameters) {
  const Count ring = 2 * count_of(parameters, "around");
  return nearest_step(wanted, 2 * ring, ring);
}

Count fullerene_sizes(Count wanted, const Settings& parameters) {
  const Count b = count_of(parameters, "b");
  const auto size = [b](Count a) { return 20 * (a * a + a * b + b * b); };
  Count a = std::max<Count>(1, b);
  while (a < 8000 && size(a + 1) <= wanted) ++a;
  return size(a);
}

Count i_graph_sizes(Count wanted, const Settings& parameters) {
  const Count step = std::max(count_of(parameters, "j"), count_of(parameters, "k"));
  return nearest_step(wanted, 2 * (2 * step + 1), 2);
}

Count odd_graph_sizes(Count wanted, const Settings&) {
  return wanted >= 35 ? 35 : (wanted >= 10 ? 10 : 3);
}

Count named_sizes(Count, const Settings& parameters) {
  return named_graphs()[count_of(parameters, "index")].num_vertices;
}

Count bridges_sizes(Count wanted, const Settings& parameters) {
  return nearest_step(wanted, 6 * count_of(parameters, "bridges") + 4, 2);
}

Count cactus_sizes(Count wanted, const Settings& parameters) {
  const Count length = count_of(parameters, "length");
  return nearest_step(wanted, length, length - 1);
}

Graph stars_of_size(Count n, std::uint64_t, const Settings& parameters) {
  const Count leaves = count_of(parameters, "leaves");
  return stars(n / (leaves + 1), leaves);
}

Graph caterpillar_of_size(Count n, std::uint64_t, const Settings& parameters) {
  const Count legs = count_of(parameters, "legs");
  return caterpillar(n / (legs + 1), legs);
}

Graph random_regular_of_size(Count n, std::uint64_t seed, const Settings& parameters) {
  return random_regular(n, static_cast<std::uint32_t>(count_of(parameters, "degree")), seed);
}

Graph cubic_tree_of_size(Count n, std::uint64_t, const Settings& parameters) {
  const Count leaf = count_of(parameters, "leaf");
  if (leaf == 6) throw InputError("leaf = 6: a leaf block has 5 or 7 vertices");
  const Count inner = (n - 2 * leaf) / (leaf + 1);
  const auto shape = count_of(parameters, "shape") == 0 ? TreeShape::kBalanced : TreeShape::kPath;
  return cubic_tree(inner, leaf == 7 ? inner + 2 : 0, shape);
}

Graph random_cubic_tree_of_size(Count n, std::uint64_t seed, const Settings&) {
  // n = 6 inner + 10 + 2 large with large near (inner + 2) / 2, and 0 <= large <= inner + 2.
  Count inner = (n - 10) / 7;
  while (n - 10 - 6 * inner > 2 * (inner + 2)) ++inner;
  return cubic_tree(inner, (n - 10 - 6 * inner) / 2, TreeShape::kRandom, seed);
}

Graph random_max_degree_of_size(Count n, std::uint64_t seed, const Settings& parameters) {
  const Count degree = count_of(parameters, "degree");
  const Count per_million = count_of(parameters, "edges-per-vertex");
  if (2 * per_million > degree * 1000000) {
    throw InputError(fmt::format("edges-per-vertex = {} is above {}, the limit for degree {}",
                                 per_million, degree * 500000, degree));
  }
  const auto D = static_cast<std::uint32_t>(degree);
  return random_max_degree(n, D, std::min(n * per_million / 1000000, most_edges(n, D)), seed);
}

Graph hypercube_of_size(Count n, std::uint64_t, const Settings&) {
  return hypercube(static_cast<Count>(std::countr_zero(n)));
}

Graph truncation_of_size(Count n, std::uint64_t, const Settings&) {
  Count times = 0;
  for (Count size = 4; size < n; size *= 3) ++times;
  return iterated_truncation(times);
}

Graph nanotube_of_size(Count n, std::uint64_t, const Settings& parameters) {
  const Count around = count_of(parameters, "around");
  return nanotube(around, n / (2 * around) - 1);
}

Graph fullerene_of_size(Count n, std::uint64_t, const Settings& parameters) {
  const Count b = count_of(parameters, "b");
  Count a = std::max<Count>(1, b);
  while (20 * (a * a + a * b + b * b) < n) ++a;
  return goldberg_coxeter(a, b);
}

Graph odd_graph_of_size(Count n, std::uint64_t, const Settings&) {
  return odd_graph(n == 35 ? 4 : (n == 10 ? 3 : 2));
}

Graph named_of_size(Count, std::uint64_t, const Settings& parameters) {
  return named_graphs()[count_of(parameters, "index")].make();
}

Graph random_cactus_of_size(Count n, std::uint64_t seed, const Settings& parameters) {
  const Count length = count_of(parameters, "length");
  return random_cactus((n - 1) / (length - 1), length, seed);
}

}  // namespace ar3d
