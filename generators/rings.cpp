// Paths, cycles, and cycles joined by rungs, chords, spokes or claws.
#include <fmt/format.h>

#include "ar3d/base/error.h"
#include "ar3d/generators/families.h"

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

Graph generalised_petersen(Count N, Count k) {
  if (N < 3 || k < 1 || 2 * k >= N) {
    throw InputError(
        fmt::format("generalised Petersen graph GP({}, {}): need N >= 3 and 1 <= k < N/2", N, k));
  }
  return i_graph(N, 1, k);
}

Graph i_graph(Count N, Count j, Count k) {
  if (N < 3 || j < 1 || 2 * j >= N || k < 1 || 2 * k >= N) {
    throw InputError(
        fmt::format("I-graph I({}, {}, {}): need N >= 3 and 1 <= j, k < N/2", N, j, k));
  }
  GraphBuilder builder(2 * N, 3 * N);
  for (Count i = 0; i < N; ++i) {
    builder.edge(i, (i + j) % N);
    builder.edge(i, N + i);
    builder.edge(N + i, N + (i + k) % N);
  }
  return builder.finish();
}

Graph flower_snark(Count k) {
  if (k < 3 || k % 2 == 0) {
    throw InputError(fmt::format("flower snark J_{}: the index must be odd and at least 3", k));
  }
  const Count a = 0, b = k, c = 2 * k, d = 3 * k;
  GraphBuilder builder(4 * k, 6 * k);
  for (Count i = 0; i < k; ++i) {
    for (const Count leaf : {b, c, d}) builder.edge(a + i, leaf + i);
  }
  builder.cycle(b, k);
  builder.cycle(c, 2 * k);  // the d_i follow the c_i
  return builder.finish();
}

}  // namespace ar3d
