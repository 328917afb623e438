#include "ar3d/algorithms/grid/kempe.h"

#include <utility>

namespace ar3d::grid {

const HalfEdge* KempeChains::half_labelled(Vertex v, Colour label) const {
  for (const HalfEdge& half : graph_.incident(v)) {
    if (labels_.at(half.edge, v, half.to) == label) return &half;
  }
  return nullptr;
}

bool KempeChains::free_colour(Vertex w, Colour wanted, Colour given, Vertex v) {
  chain_.clear();
  Colour follow = wanted;
  Colour other = given;
  if (longest_ == 0 || state_[w] == VertexState::clash) return false;
  for (Vertex at = w;;) {
    const HalfEdge* half = half_labelled(at, follow);
    if (half == nullptr) break;
    if (half->to == v || budget_ == 0) return false;
    if (chain_.size() >= longest_) {
      too_long_ = true;
      return false;
    }
    --budget_;
    if (state_[half->to] == VertexState::clash) return false;
    const bool both_ends = state_[half->to] == VertexState::labelled;
    chain_.push_back({*half, at, both_ends});
    if (!both_ends) break;
    at = half->to;
    std::swap(follow, other);
  }
  Colour label = given;
  for (const Step& step : chain_) {
    labels_.set(step.half.edge, step.from, step.half.to, label);
    if (step.both_ends) labels_.set(step.half.edge, step.half.to, step.from, label);
    label = label == given ? wanted : given;
  }
  return true;
}

}  // namespace ar3d::grid
