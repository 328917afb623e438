#include "ar3d/generators/rings.h"

#include <fmt/format.h>

#include "ar3d/base/error.h"

namespace ar3d {

Graph path_graph(Count n) {
  GraphBuilder builder(n, n);
  builder.path(0, n);
  return builder.finish();
}

Graph cycle_graph(Count n) {
  GraphBuilder builder(n, n);
  builder.cycle(0, n);
  return builder.finish();
}

Graph ladder(Count k) {
  GraphBuilder builder(2 * k, 3 * k);
  builder.path(0, k);
  builder.path(k, k);
  for (Count i = 0; i < k; ++i) builder.edge(i, k + i);
  return builder.finish();
}

Graph prism(Count k) {
  GraphBuilder builder(2 * k, 3 * k);
  builder.cycle(0, k);
  builder.cycle(k, k);
  for (Count i = 0; i < k; ++i) builder.edge(i, k + i);
  return builder.finish();
}

Graph moebius_ladder(Count k) {
  GraphBuilder builder(2 * k, 3 * k);
  builder.cycle(0, 2 * k);
  for (Count i = 0; i < k; ++i) builder.edge(i, k + i);
  return builder.finish();
}

Graph circulant(Count n, Count a, Count b) {
  if (a < 1 || a >= b || b > n / 2) {
    throw InputError(
        fmt::format("circulant steps {} and {} on {} vertices: need 1 <= a < b <= n/2", a, b, n));
  }
  GraphBuilder builder(n, 2 * n);
  for (const Count step : {a, b}) {
    const Count ends = 2 * step == n ? step : n;  // a step of n/2 gives each edge twice
    for (Count i = 0; i < ends; ++i) builder.edge(i, (i + step) % n);
  }
  return builder.finish();
}

Graph squared_cycle(Count n) { return circulant(n, 1, 2); }

}  // namespace ar3d
