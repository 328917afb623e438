#pragma once

#include "ar3d/generators/catalog.h"

// What the catalogue's rows call where a family's number of vertices has to be turned into the
// arguments of its own function: Family::generate, called with a valid n and complete parameters.
namespace ar3d {

Graph stars_of_size(std::uint64_t n, std::uint64_t seed, const Settings& parameters);
Graph caterpillar_of_size(std::uint64_t n, std::uint64_t seed, const Settings& parameters);
Graph random_regular_of_size(std::uint64_t n, std::uint64_t seed, const Settings& parameters);
Graph cubic_tree_of_size(std::uint64_t n, std::uint64_t seed, const Settings& parameters);
Graph random_cubic_tree_of_size(std::uint64_t n, std::uint64_t seed, const Settings&);
/// m = floor(n edges-per-vertex / 10^6), at most that of the complete graph for n <= degree.
/// @throws InputError if edges-per-vertex is above degree / 2.
Graph random_max_degree_of_size(std::uint64_t n, std::uint64_t seed, const Settings& parameters);
Graph hypercube_of_size(std::uint64_t n, std::uint64_t, const Settings&);
Graph truncation_of_size(std::uint64_t n, std::uint64_t, const Settings&);
Graph nanotube_of_size(std::uint64_t n, std::uint64_t, const Settings& parameters);
Graph fullerene_of_size(std::uint64_t n, std::uint64_t, const Settings& parameters);
Graph odd_graph_of_size(std::uint64_t n, std::uint64_t, const Settings&);
Graph named_of_size(std::uint64_t, std::uint64_t, const Settings& parameters);
Graph random_cactus_of_size(std::uint64_t n, std::uint64_t seed, const Settings& parameters);

}  // namespace ar3d
