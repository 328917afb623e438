// Step 3.13. Chains that swap two labels (Kempe 1879), started at the end of a defect: they move,
// turn, split or heal defects, and keep the labels at a vertex different. Cost: about 100 chain
// steps per vertex at most; the core takes over after that.
#include <utility>

#include "ar3d/algorithms/grid/flat.h"

namespace ar3d::grid {
namespace {

bool has_labels_0_1(const ColourDefect& defect) {
  return defect.label_x != defect.label_y && defect.label_x != 2 && defect.label_y != 2;
}

}  // namespace

Relabelling::Relabelling(std::span<const PlacedRow> neighbours, std::span<Ports> ports,
                         std::vector<ColourDefect>& defects, std::int64_t n)
    : neighbours_(neighbours),
      ports_(ports),
      defects_(defects),
      most_steps_(static_cast<std::int64_t>(kStepsPerVertex) * n + 1000) {
  for (std::size_t d = 0; d < defects_.size(); ++d) {
    const ColourDefect& defect = defects_[d];
    ports_[defect.x].to[defect.label_x] = kNoIndex;
    ports_[defect.y].to[defect.label_y] = kNoIndex;
    by_index_.emplace(defect.x, d);
    by_index_.emplace(defect.y, d);
  }
}

bool Relabelling::avoid_labels_0_1() {
  constexpr int kSlides = 16;
  for (std::size_t d = 0; d < defects_.size(); ++d) {
    if (exhausted()) return false;
    if (!has_labels_0_1(defects_[d]) || swap_or_split(d)) continue;
    bool at_x = ports_[defects_[d].x].to[defects_[d].label_y] != kNoIndex;
    for (int i = 0;; ++i, at_x = !at_x) {
      if (i == kSlides || !slide(d, at_x)) return false;
      if (swap_or_split(d)) break;
    }
  }
  return !exhausted();
}

bool Relabelling::swap_or_split(std::size_t d) {
  for (const bool is_x : {true, false}) {
    if (makes_labels_0_1({d, is_x}, 2)) continue;
    swap_chain({d, is_x}, 2);
    return true;
  }
  return split({d, true}) || split({d, false});
}

bool Relabelling::slide(std::size_t d, bool at_x) {
  ColourDefect& defect = defects_[d];
  const Index v = at_x ? defect.x : defect.y;
  const Colour label = at_x ? defect.label_y : defect.label_x;
  const Index other = ports_[v].to[label];
  if (other == kNoIndex) return false;
  ports_[v].to[label] = kNoIndex;
  ports_[other].to[label] = kNoIndex;
  ports_[defect.x].to[label] = defect.y;
  ports_[defect.y].to[label] = defect.x;
  (at_x ? defect.y : defect.x) = other;
  by_index_.emplace(other, d);
  defect.edge = edge_between(v, other);
  return true;
}

/// Swaps the end's label with its vertex's label 2, whose edge becomes a defect, too.
bool Relabelling::split(const DefectEnd& end) {
  const Index v = index_of(end);
  const Index other = ports_[v].to[2];
  if (other == kNoIndex) return false;
  const Colour label = std::exchange(label_of(end), 2);
  ports_[v].to[2] = kNoIndex;
  ports_[other].to[2] = kNoIndex;
  settle(end.defect);
  by_index_.emplace(v, defects_.size());
  by_index_.emplace(other, defects_.size());
  defects_.push_back({v, other, edge_between(v, other), label, 2});
  return true;
}

EdgeId Relabelling::edge_between(Index v, Index other) const {
  unsigned i = 0;
  while (neighbours_[v].half[i].to != other) ++i;
  return neighbours_[v].half[i].edge;
}

void Relabelling::turn(std::size_t d) {
  const Colour label = defects_[d].label_x;
  const bool from_x = !makes_labels_0_1({d, true}, 2) || makes_labels_0_1({d, false}, label);
  swap_chain({d, from_x}, from_x ? 2 : label);
}

void Relabelling::drop_healed() {
  std::erase_if(defects_, [](const ColourDefect& d) { return d.label_x == d.label_y; });
}

Index Relabelling::index_of(const DefectEnd& end) const {
  return end.is_x ? defects_[end.defect].x : defects_[end.defect].y;
}

Colour& Relabelling::label_of(const DefectEnd& end) {
  return end.is_x ? defects_[end.defect].label_x : defects_[end.defect].label_y;
}

Relabelling::DefectEnd Relabelling::find(Index v, Colour label) {
  const auto [begin, end] = by_index_.equal_range(v);
  for (auto at = begin; at != end; ++at) {
    ++steps_;
    const std::size_t d = at->second;
    const ColourDefect& defect = defects_[d];
    if (defect.label_x == defect.label_y) continue;
    if (defect.x == v && defect.label_x == label) return {d, true};
    if (defect.y == v && defect.label_y == label) return {d, false};
  }
  return {kNone, false};
}

Relabelling::DefectEnd Relabelling::other_end(const DefectEnd& end, Colour wanted) {
  const ColourDefect& defect = defects_[end.defect];
  const Colour given = end.is_x ? defect.label_x : defect.label_y;
  Colour follow = wanted;
  Index at = index_of(end);
  for (Index to = ports_[at].to[follow]; to != kNoIndex; to = ports_[at].to[follow]) {
    ++steps_;
    at = to;
    follow = follow == wanted ? given : wanted;
  }
  return find(at, follow);
}

bool Relabelling::makes_labels_0_1(const DefectEnd& end, Colour wanted) {
  const Colour given = label_of(end);
  const DefectEnd last = other_end(end, wanted);
  if (last.defect == kNone || last.defect == end.defect) return false;
  ColourDefect after = defects_[last.defect];
  Colour& label = last.is_x ? after.label_x : after.label_y;
  label = label == given ? wanted : given;
  return has_labels_0_1(after);
}

void Relabelling::swap_chain(const DefectEnd& end, Colour wanted) {
  const Colour given = label_of(end);
  const DefectEnd last = other_end(end, wanted);
  Colour follow = wanted;
  for (Index at = index_of(end); at != kNoIndex;) {
    Ports& ports = ports_[at];
    ++steps_;
    const Index to = ports.to[follow];
    std::swap(ports.to[given], ports.to[wanted]);
    follow = follow == wanted ? given : wanted;
    at = to;
  }
  label_of(end) = wanted;
  if (last.defect != kNone) {
    Colour& label = label_of(last);
    label = label == given ? wanted : given;
    if (last.defect != end.defect) settle(last.defect);
  }
  settle(end.defect);
}

/// Label 2 belongs to y; an edge with equal labels belongs to the ports.
void Relabelling::settle(std::size_t d) {
  ColourDefect& defect = defects_[d];
  if (defect.label_x == 2) {
    std::swap(defect.x, defect.y);
    std::swap(defect.label_x, defect.label_y);
  }
  if (defect.label_x != defect.label_y) return;
  ports_[defect.x].to[defect.label_x] = defect.y;
  ports_[defect.y].to[defect.label_y] = defect.x;
}

}  // namespace ar3d::grid
