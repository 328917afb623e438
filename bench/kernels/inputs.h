#pragma once

#include <cstdint>
#include <string>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/formats/catalog.h"
#include "ar3d/generators/catalog.h"

namespace ar3d::kernels {

/// The seed of every random input of a kernel.
inline constexpr std::uint64_t kSeed = 1;

/// Random 4-regular graphs, or cubic ones for an algorithm that draws no degree 4.
inline const Family& random_family(const Algorithm& algorithm) {
  return find_family(algorithm.guarantee.max_degree == 4 ? "random-4-regular" : "random-cubic");
}

/// The family's graph with nearest_n(n) vertices in random order, made afresh.
inline Graph shuffled(const Family& family, std::uint64_t n) {
  return generate(family, n, kSeed, {{"shuffle", 1}});
}

/// The family's graph with nearest_n(n) vertices. The last one is kept, so that kernels that follow
/// each other share it; the reference is good until the next call.
const Graph& graph_of(const Family& family, std::uint64_t n);

/// The same graph as a file of the format, kept likewise.
const std::string& text_of(const GraphFormat& format, const Family& family, std::uint64_t n);

/// Bytes that the graph takes in memory (model/graph.h).
std::int64_t bytes_of_graph(const Graph& graph);

}  // namespace ar3d::kernels
