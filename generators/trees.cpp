#include "ar3d/generators/trees.h"

namespace ar3d {
namespace {

/// Adds a heap-shaped tree on new vertices; returns its root.
Count add_heap(GraphBuilder& builder, Count size) {
  const Count root = builder.add_vertices(size);
  for (Count v = 1; v < size; ++v) builder.edge(root + (v - 1) / 2, root + v);
  return root;
}

}  // namespace

Graph stars(Count copies, Count leaves) {
  GraphBuilder builder(copies * (leaves + 1), copies * leaves);
  for (Count centre = 0; centre < builder.num_vertices(); centre += leaves + 1) {
    for (Count leaf = 1; leaf <= leaves; ++leaf) builder.edge(centre, centre + leaf);
  }
  return builder.finish();
}

Graph caterpillar(Count k, Count legs) {
  GraphBuilder builder(k * (legs + 1), k * (legs + 1));
  builder.path(0, k);
  for (Count i = 0; i < k; ++i) {
    for (Count leg = 0; leg < legs; ++leg) builder.edge(i, k + i * legs + leg);
  }
  return builder.finish();
}

Graph binary_tree(Count n) {
  GraphBuilder builder(0, n);
  add_heap(builder, n);
  return builder.finish();
}

Graph spine_with_pendant_trees(Count k) {
  constexpr Count kTreeSizes[] = {3, 5, 9};
  GraphBuilder builder(3 * k, 20 * k);
  builder.path(0, 3 * k);
  for (Count i = 0; i < 3 * k; ++i) builder.edge(i, add_heap(builder, kTreeSizes[i % 3]));
  return builder.finish();
}

}  // namespace ar3d
