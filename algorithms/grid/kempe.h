#pragma once

#include <cstdint>
#include <vector>

#include "ar3d/algorithms/grid/labels.h"
#include "ar3d/model/graph.h"

namespace ar3d::grid {

enum class VertexState : std::uint8_t { waiting, labelled, clash };

/// Swaps two labels along a path of U-edges that they alternate on.
class KempeChains {
 public:
  /// All chains together take at most this many steps a vertex, so the time stays linear on every
  /// input.
  static constexpr std::size_t kStepsPerVertex = 100;

  /// @param labels  read and changed; must outlive this.
  KempeChains(const Graph& graph, EdgeLabels& labels, std::size_t longest)
      : graph_(graph),
        labels_(labels),
        longest_(longest),
        budget_(kStepsPerVertex * graph.num_vertices() + 1000),
        state_(graph.num_vertices(), VertexState::waiting) {}

  void set_longest(std::size_t longest) { longest_ = longest; }
  /// Whether a chain failed for its length alone since forget_too_long(), and steps are left.
  bool was_too_long() const { return too_long_ && budget_ > 0; }
  void forget_too_long() { too_long_ = false; }
  void set_state(Vertex v, VertexState state) { state_[v] = state; }

  /// Makes `wanted` unused at w by swapping it with `given` along the chain that begins with w's
  /// half-edge labelled `wanted`. The chain may end at a vertex without the next label or at a
  /// half-edge towards a waiting vertex other than v. Nothing changes, and false is returned, if it
  /// reaches v or a clash vertex or is too long.
  bool free_colour(Vertex w, Colour wanted, Colour given, Vertex v);

 private:
  struct Step {
    HalfEdge half;
    Vertex from = 0;
    bool both_ends = false;
  };
  const HalfEdge* half_labelled(Vertex v, Colour label) const;

  const Graph& graph_;
  EdgeLabels& labels_;
  std::size_t longest_;
  bool too_long_ = false;
  std::size_t budget_;  // steps left in all chains together
  std::vector<VertexState> state_;
  std::vector<Step> chain_;
};

}  // namespace ar3d::grid
