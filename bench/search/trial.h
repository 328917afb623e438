#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

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

/// Says which share of the bound counts; side: the largest of the three axes.
enum class BoundShare { side, x, y, z, volume };

/// Holds what is tried on one graph after the other: an algorithm with complete options, or a
/// program of a study, a fault if one is seeded, and which share of which bound counts.
struct Subject {
  AlgorithmChoice choice;
  const SeededFault* fault = nullptr;
  BoundShare measure = BoundShare::side;
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

}  // namespace ar3d
