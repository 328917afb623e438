#include "ar3d/generators/kneser.h"

#include <fmt/format.h>

#include <bit>

#include "ar3d/base/error.h"

namespace ar3d {

Graph kneser_graph(unsigned n, unsigned k) {
  if (k < 1 || 2 * k > n || n > 20) {
    throw InputError(fmt::format("Kneser graph K({}, {}): need 1 <= k and 2k <= n <= 20", n, k));
  }
  std::vector<std::uint32_t> sets;
  for (std::uint32_t set = 0; set < (1u << n); ++set) {
    if (static_cast<unsigned>(std::popcount(set)) == k) sets.push_back(set);
  }
  GraphBuilder builder(sets.size());
  for (Count v = 1; v < sets.size(); ++v) {
    for (Count u = 0; u < v; ++u) {
      if ((sets[u] & sets[v]) == 0) builder.edge(u, v);
    }
  }
  return builder.finish();
}

Graph odd_graph(unsigned k) { return kneser_graph(2 * k - 1, k - 1); }

}  // namespace ar3d
