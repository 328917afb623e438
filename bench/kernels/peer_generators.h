#pragma once

#include <cstdint>
#include <functional>

namespace ar3d::kernels {

struct Cost {
  double cpu_s = 0;  ///< user and system
  double peak_bytes = 0;
};

/// What `work` costs in a child process that ends with it. @throws std::runtime_error if the child
/// fails.
Cost cost_of(const std::function<void()>& work);

// Random regular graphs of n vertices and degree d; to be called in a child process, which ends if
// one fails.

/// This project's, on one thread: edges and rows of the graph, as every user of the library pays
/// for them.
void generate_ours(std::uint64_t n, std::uint32_t d, std::uint32_t seed);
/// nauty-genrang -r (Debian package nauty); writes sparse6 to /dev/null.
void generate_genrang(std::uint64_t n, std::uint32_t d, std::uint32_t seed);
/// igraph's own random regular graphs; their documentation promises no distribution.
void generate_igraph(std::uint64_t n, std::uint32_t d, std::uint32_t seed);
/// igraph's uniform ones: the configuration model with full restart.
void generate_igraph_uniform(std::uint64_t n, std::uint32_t d, std::uint32_t seed);

}  // namespace ar3d::kernels
