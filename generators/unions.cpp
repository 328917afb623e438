#include "ar3d/generators/unions.h"

namespace ar3d {

Graph copies_of(const Graph& part, Count copies) {
  GraphBuilder builder(0, copies * part.num_edges());
  for (Count i = 0; i < copies; ++i) builder.append(part);
  return builder.finish();
}

Graph complete_graph(Count n) {
  GraphBuilder builder(n);
  for (Count v = 1; v < n; ++v) {
    for (Count u = 0; u < v; ++u) builder.edge(u, v);
  }
  return builder.finish();
}

Graph complete_bipartite(Count a, Count b) {
  GraphBuilder builder(a + b);
  for (Count u = 0; u < a; ++u) {
    for (Count v = 0; v < b; ++v) builder.edge(u, a + v);
  }
  return builder.finish();
}

Graph octahedron_graph() {
  GraphBuilder builder(6);
  for (Count v = 1; v < 6; ++v) {
    for (Count u = 0; u < v; ++u) {
      if (u + v != 5) builder.edge(u, v);
    }
  }
  return builder.finish();
}

}  // namespace ar3d
