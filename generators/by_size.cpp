#include "ar3d/generators/by_size.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "ar3d/base/error.h"
#include "ar3d/generators/blocks.h"
#include "ar3d/generators/kneser.h"
#include "ar3d/generators/leaf_blocks.h"
#include "ar3d/generators/named.h"
#include "ar3d/generators/patches.h"
#include "ar3d/generators/polyhedra.h"
#include "ar3d/generators/random_regular.h"
#include "ar3d/generators/sizes.h"
#include "ar3d/generators/trees.h"

namespace ar3d {

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
