#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ar3d/generators/graph_builder.h"

namespace ar3d {

/// The cubic graph of LCF notation (Lederberg, Coxeter, Frucht): the cycle 0..n-1 and, for every i,
/// the chord from i to i + shifts[i mod shifts.size()], n = shifts.size() repeats. Every chord is
/// met from both of its ends.
/// @throws InputError if a chord is not met again from its other end, or is a loop or an edge of
/// the cycle.
Graph lcf_graph(const std::vector<int>& shifts, Count repeats);

/// One graph with a name of its own.
struct NamedGraph {
  std::string name;
  std::string summary;  ///< one sentence: what it is, with its source
  Vertex num_vertices = 0;
  std::function<Graph()> make;
};

/// All of them, in order of size.
const std::vector<NamedGraph>& named_graphs();

}  // namespace ar3d
