#pragma once

// (I1) to (I5) of docs/theorem3.md, checked by hash tables as plainly as they are stated. Lemma 3.3
// concludes from them that the drawing has no crossing.

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <unordered_set>
#include <vector>

#include "ar3d/algorithms/grid/planes.h"

namespace ar3d::grid {

class InvariantChecker {
 public:
  InvariantChecker(const Graph& graph, const Planes& planes)
      : graph_(graph), planes_(planes), component_(connected_components_of(graph).of) {}

  std::string run() {
    check_sums();
    check_labels();
    collect_numbers();
    for (EdgeId e = 0; e < graph_.num_edges() && broken_.empty(); ++e) check_edge(e);
    if (broken_.empty() && slots_used_ != planes_.slots.size()) broken_ = "(I5): a slot too many";
    return broken_;
  }

 private:
  /// Numbers of different components never meet: packing keeps their drawings apart.
  std::int64_t key(Vertex v, std::int64_t number) const {
    return (std::int64_t{component_[v]} << 35) + number;
  }

  void check_sums() {
    std::vector<std::int64_t> sums;
    for (Vertex v = 0; v < graph_.num_vertices(); ++v)
      sums.push_back(key(v, sum_of(planes_.of[v])));
    std::ranges::sort(sums);
    if (std::ranges::adjacent_find(sums) != sums.end()) {
      broken_ = "(I1): two vertices of a component have the same sum";
    }
  }

  void check_labels() {
    for (Vertex v = 0; v < graph_.num_vertices(); ++v) {
      ColourSet seen = 0;
      for (const HalfEdge& half : graph_.incident(v)) {
        const Colour label = planes_.labels.at(half.edge, v, half.to);
        if (label == kNoColour || contains(seen, label)) {
          broken_ = fmt::format("labels: vertex {} has label {} twice or open", v, label);
          return;
        }
        seen |= only(label);
      }
    }
  }

  void collect_numbers() {
    for (Vertex v = 0; v < graph_.num_vertices(); ++v) {
      for (Colour c = 0; c < kColours; ++c) numbers_[c].insert(key(v, x(v, c)));
    }
  }

  std::int64_t x(Vertex v, Colour c) const { return planes_.of[v][c]; }

  void check_edge(EdgeId e) {
    const Edge ends = graph_.edge(e);
    const Colour at_u = planes_.labels.at(e, ends.u, ends.v);
    const Colour at_v = planes_.labels.at(e, ends.v, ends.u);
    own(at_u, x(ends.u, at_u), e);
    if (at_u == at_v) {
      check_u_edge(e, at_u);
    } else {
      own(at_v, x(ends.v, at_v), e);
      if (at_u == next(at_v)) {
        check_defect(e, ends.u, ends.v, at_u);
      } else {
        check_defect(e, ends.v, ends.u, at_v);
      }
    }
  }

  /// (I3): a number of a colour belongs to one U-edge or to one end of a defect.
  void own(Colour c, std::int64_t number, EdgeId e) {
    const bool fresh = owners_[c].insert(key(graph_.edge(e).u, number)).second;
    if (!fresh) broken_ = fmt::format("(I3): edge {} shares plane {} of colour {}", e, number, c);
  }

  void check_u_edge(EdgeId e, Colour c) {
    const Edge ends = graph_.edge(e);
    const std::int64_t apart = sum_of(planes_.of[ends.u]) - sum_of(planes_.of[ends.v]);
    if (x(ends.u, c) != x(ends.v, c) || std::abs(apart) < 2) {
      broken_ = fmt::format("(I2): U-edge {} of colour {}", e, c);
    }
  }

  void check_defect(EdgeId e, Vertex u, Vertex v, Colour alpha) {
    const Colour beta = previous(alpha);
    const Colour gamma = next(alpha);
    const std::int64_t a = x(u, alpha) - x(v, alpha);
    const std::int64_t b = x(u, beta) - x(v, beta);
    const std::int64_t c = x(v, gamma) - x(u, gamma);
    if (a <= 0 || b <= 0 || c <= 0) broken_ = fmt::format("(I4): defect {}", e);
    if (a + b - c > 0)
      check_slot(e, gamma, x(u, gamma) + std::max<std::int64_t>(0, c - a),
                 x(u, gamma) + std::min(b, c) - 1);
  }

  void check_slot(EdgeId e, Colour gamma, std::int64_t least, std::int64_t most) {
    const auto slot = std::ranges::lower_bound(planes_.slots, e, {}, &Slot::edge);
    if (slot == planes_.slots.end() || slot->edge != e) {
      broken_ = fmt::format("(I5): defect {} has no slot", e);
      return;
    }
    ++slots_used_;
    if (slot->k < least || slot->k > most) broken_ = fmt::format("(I5): range of slot of {}", e);
    for (const std::int64_t number : {slot->k - 1, slot->k}) {
      const std::int64_t own_key = key(graph_.edge(e).u, number);
      if (numbers_[gamma].contains(own_key) || !reserved_[gamma].insert(own_key).second) {
        broken_ = fmt::format("(I5): slot number {} of defect {} is not its own", number, e);
      }
    }
  }

  using Numbers = std::unordered_set<std::int64_t>;

  const Graph& graph_;
  const Planes& planes_;
  const std::vector<std::uint32_t> component_;  // of every vertex
  std::array<Numbers, kColours> numbers_;       // of all vertices
  std::array<Numbers, kColours> owners_;        // planes with an owner
  std::array<Numbers, kColours> reserved_;      // by slots
  std::size_t slots_used_ = 0;
  std::string broken_;
};

/// @return "" or the first broken rule with the edge or vertex that breaks it.
inline std::string broken_invariant(const Graph& graph, const Planes& planes) {
  return InvariantChecker(graph, planes).run();
}

}  // namespace ar3d::grid
