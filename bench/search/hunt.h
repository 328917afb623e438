#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "ar3d/base/random.h"
#include "ar3d/bench/search/trial.h"
#include "ar3d/model/graph.h"

namespace ar3d {
struct HuntOptions {
  /// Holds where searches start, in turn; not empty. A corpus gives its graphs one after the other,
  /// except those beyond the algorithm's maximum degree, and then again with permuted labels.
  std::vector<FamilyChoice> families;
  std::uint64_t n = 40;  ///< requested number of vertices
  std::uint64_t seed = 1;
  std::uint64_t evaluations = 1000;  ///< graphs drawn
  double seconds = 0;                ///< stop after that time even so; 0: no limit
  std::uint64_t patience = 60;       ///< evaluations without progress before a new start
};

struct HuntResult {
  Trial best;  ///< the first failure, else the largest ratio
  FamilyChoice start;
  std::uint64_t start_seed = 0;   ///< of a family's graph
  std::uint32_t start_index = 0;  ///< of a corpus's graph in its file
  std::uint64_t evaluations = 0;
  std::uint64_t starts = 0;
};

/// Searches for the largest ratio of measured to bound: random starts in the families (seeds),
/// then steps that are kept unless the ratio falls: labels exchanged, or two edges switched so that
/// all degrees stay. A failure ends the search at once. A pure function of its arguments unless
/// `seconds` ends it.
/// @param progress  called at every improvement of the best; may be empty.
/// @throws InputError if no graph of a family, or of a corpus, can be drawn.
HuntResult hunt(const Subject& subject, const HuntOptions& options,
                const std::function<void(const HuntResult&)>& progress = {});

/// Returns all families of the catalogue whose graphs (of about n vertices) the algorithm draws.
std::vector<FamilyChoice> fitting_families(const Algorithm& algorithm, std::uint64_t n);

/// Switches two edges: ab and cd become ac and bd, or ad and bc: the degrees stay. The same graph
/// if no switch was found in a few tries. O(n + m).
Graph with_switched_edges(const Graph& graph, RandomStream& random);

struct ShrinkResult {
  Graph graph;
  std::uint64_t evaluations = 0;
  bool minimal = false;  ///< no vertex and no edge can go; false if the evaluations ran out
};

/// Removes components, vertices and edges as long as `keeps` holds (delta debugging: Zeller and
/// Hildebrandt 2002, first large chunks, then small ones). What stays keeps its order. Degrees only
/// fall, so the graph stays inside every guarantee.
/// @param keeps  the property; true of `graph`.
/// Cost: O(k log k) evaluations for k vertices and edges where few stay, O(k^2) at worst.
ShrinkResult shrink(const Graph& graph, const std::function<bool(const Graph&)>& keeps,
                    std::uint64_t max_evaluations);

}  // namespace ar3d
