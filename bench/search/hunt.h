#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ar3d/base/random.h"
#include "ar3d/bench/external/external_drawer.h"
#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"
#include "ar3d/model/guarantee.h"

namespace ar3d {

/// Returns true if there is that edge. O(degree of u).
bool has_edge(const Graph& graph, Vertex u, Vertex v);

/// Describes a fault put into finished drawings on purpose, to show that hunter, shrinker and
/// verdict catch it. It shows on some graphs only, so that finding and shrinking it takes work. No
/// algorithm knows of it.
struct SeededFault {
  std::string name;
  std::string summary;
  /// Returns the drawing with the fault; unchanged where the graph does not provoke it.
  Drawing (*plant)(const Graph&, const Drawing&, const Guarantee&) = nullptr;
};

/// Returns all of them.
const std::vector<SeededFault>& seeded_faults();

/// @throws InputError naming the unknown fault and the known ones.
const SeededFault& find_seeded_fault(std::string_view name);

/// Names the shares of a bound that may count; side: the largest of the three axes.
inline constexpr const char* kShares[] = {"side", "x", "y", "z", "volume"};

/// Holds what is tried on one graph after the other: an algorithm with complete options, or a
/// program of a study, a fault if one is seeded, and which share of which bound counts.
struct Subject {
  AlgorithmChoice choice;
  const SeededFault* fault = nullptr;
  std::string measure = "side";   ///< one of kShares
  bool against_instance = false;  ///< the bound is the proof's for the graph, else the theorem's
};

/// Describes one graph drawn and judged.
struct Trial {
  Graph graph;
  std::shared_ptr<const Drawing> drawing;  ///< null: there is none, and `failure` says why
  std::array<std::int64_t, 3> extents{};
  std::array<double, 3> bound{};
  /// Holds extent / bound; for volume the product of (extent + 1) / (bound + 1). 0 without a
  /// positive bound.
  double ratio = 0;
  /// Holds the kind of the first violation; of a graph that is not drawn, how its program failed
  /// (timeout, crashed) or "internal_error"; else nothing.
  std::string failure;
  std::string message;  ///< of the failure
};

/// Draws and certifies, once. @throws InputError if the graph lies outside the guarantee, and if an
/// instance's bound counts and there is none.
Trial try_graph(const Subject& subject, Graph graph);

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

/// Removes components, vertices and edges as long as `keeps` holds (delta debugging: Zeller and
/// Hildebrandt 2002, first large chunks, then small ones). What stays keeps its order. Degrees only
/// fall, so the graph stays inside every guarantee.
/// @param graph  becomes the part of it that is left. @param keeps  the property; true of `graph`.
/// @param evaluations  that are left; each takes one.
/// @return true if no vertex and no edge can go; false if the evaluations ran out.
/// Cost: O(k log k) evaluations for k vertices and edges where few stay, O(k^2) at worst.
bool shrink(Graph& graph, const std::function<bool(const Graph&)>& keeps,
            std::uint64_t& evaluations);

}  // namespace ar3d
