#include "ar3d/generators/random_regular.h"

#include <fmt/format.h>

#include "ar3d/base/error.h"
#include "ar3d/generators/pairing.h"
#include "ar3d/generators/switching.h"

namespace ar3d {
namespace {

enum Stream : std::uint64_t { kRegular = 10, kMaxDegree = 11 };

void refuse_bad_degree(std::uint32_t d) {
  if (d < 1 || d > 4) throw InputError(fmt::format("degree {} is outside 1..4", d));
}

}  // namespace

std::vector<Edge> random_regular_edges(Count n, std::uint32_t d, RandomStream& random) {
  return n >= kLeastSwitchingSize && d >= 2 ? random_regular_by_switching(n, d, random)
                                            : random_simple_pairs(n, d, n * d / 2, random);
}

Graph random_regular(Count n, std::uint32_t d, std::uint64_t seed) {
  refuse_bad_degree(d);
  if (n <= d || n * d % 2 != 0) {
    throw InputError(fmt::format("there is no {}-regular graph on {} vertices", d, n));
  }
  RandomStream random(seed, kRegular);
  return Graph(n, random_regular_edges(n, d, random));
}

Count most_edges(Count n, std::uint32_t D) {
  return n > D ? n * D / 2 : (n == 0 ? 0 : n * (n - 1) / 2);
}

Graph random_max_degree(Count n, std::uint32_t D, Count m, std::uint64_t seed) {
  refuse_bad_degree(D);
  if (m > most_edges(n, D)) {
    throw InputError(
        fmt::format("{} edges on {} vertices of degree at most {}: at most {} are possible", m, n,
                    D, most_edges(n, D)));
  }
  RandomStream random(seed, kMaxDegree);
  return Graph(n, random_simple_pairs(n, D, m, random));
}

}  // namespace ar3d
