// Trees, and cubic graphs whose bridges form a tree that ends in leaf blocks: by Sylvester (1883)
// these have no perfect matching once three odd blocks meet.
#include <fmt/format.h>

#include <numeric>

#include "ar3d/base/error.h"
#include "ar3d/base/random.h"
#include "ar3d/generators/families.h"

namespace ar3d {
namespace {

/// Adds a heap-shaped tree on new vertices; returns its root.
Count add_heap(GraphBuilder& builder, Count size) {
  const Count root = builder.add_vertices(size);
  for (Count v = 1; v < size; ++v) builder.edge(root + (v - 1) / 2, root + v);
  return root;
}

/// Returns which of the leaves get the large block.
std::vector<bool> large_leaves(Count leaves, Count large, TreeShape shape, std::uint64_t seed) {
  std::vector<bool> is_large(leaves, false);
  std::vector<Count> order(leaves);
  std::iota(order.begin(), order.end(), Count{0});
  if (shape == TreeShape::kRandom)
    RandomStream(seed, /*stream=*/2).shuffle(std::span<Count>(order));
  for (Count i = 0; i < large; ++i) is_large[order[i]] = true;
  return is_large;
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

Graph leaf_block(Count size) {
  if (size == 5) {  // K4 on 1..4, edge 12 subdivided by 0
    return Graph(5, {{0, 1}, {0, 2}, {1, 3}, {1, 4}, {2, 3}, {2, 4}, {3, 4}});
  }
  if (size == 7) {  // K3,3 with sides 1, 3, 5 and 2, 4, 6, edge 12 subdivided by 0
    return Graph(7,
                 {{0, 1}, {0, 2}, {1, 4}, {1, 6}, {3, 2}, {3, 4}, {3, 6}, {5, 2}, {5, 4}, {5, 6}});
  }
  throw InputError(fmt::format("there is no leaf block of {} vertices (only 5 and 7)", size));
}

Graph cubic_tree(Count inner, Count large_blocks, TreeShape shape, std::uint64_t seed) {
  const Count leaves = inner + 2;
  if (large_blocks > leaves) {
    throw InputError(
        fmt::format("{} large blocks on a cubic tree of {} leaves", large_blocks, leaves));
  }
  GraphBuilder builder(inner, 9 * inner + 15 + 3 * large_blocks);
  std::vector<Count> ends;  // the vertices at which a bridge still has to leave
  std::size_t first = 0;    // of them, if they are taken breadth first
  RandomStream random(seed, /*stream=*/1);
  const auto take = [&] {
    if (shape == TreeShape::kBalanced) return ends[first++];
    if (shape == TreeShape::kRandom) {
      std::swap(ends[random.below(static_cast<std::uint32_t>(ends.size()))], ends.back());
    }
    const Count last = ends.back();
    ends.pop_back();
    return last;
  };
  const std::vector<bool> is_large = large_leaves(leaves, large_blocks, shape, seed);
  const Graph small = leaf_block(5);
  const Graph large = leaf_block(7);
  Count first_leaf = 0;
  if (inner == 0) {  // the first block takes the place of the root
    ends.push_back(builder.append(is_large[first_leaf++] ? large : small));
  } else {
    ends.assign(3, 0);
  }
  for (Count v = 1; v < inner; ++v) {
    builder.edge(take(), v);
    ends.insert(ends.end(), 2, v);
  }
  for (Count leaf = first_leaf; leaf < leaves; ++leaf) {
    builder.edge(take(), builder.append(is_large[leaf] ? large : small));
  }
  return builder.finish();
}

}  // namespace ar3d
