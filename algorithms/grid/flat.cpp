// Steps 3.10 to 3.13 for one component: heights, paths that end at defects, the third colour;
// labels are changed and the numbering is repeated where the defects' rules contradict one another,
// ten times at most. A heuristic in size, not in truth: its rules are tested at the end. Cost: O(n
// log n) expected.
#include "ar3d/algorithms/grid/flat.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "ar3d/algorithms/grid/defect_paths.h"
#include "ar3d/algorithms/grid/relabel.h"
#include "ar3d/algorithms/grid/third_colour.h"

namespace ar3d::grid {
namespace {

/// (I4) and (I5) but for the emptiness of slots, which DefectPaths keeps.
bool obeys(const ColourDefect& defect, const HeightSlot& slot, std::span<const PlaneNumbers> x) {
  const bool x_is_u = defect.label_x == next(defect.label_y);
  const PlaneNumbers& u = x[x_is_u ? defect.x : defect.y];
  const PlaneNumbers& v = x[x_is_u ? defect.y : defect.x];
  const Colour alpha = x_is_u ? defect.label_x : defect.label_y;
  const Colour beta = previous(alpha);
  const Colour gamma = next(alpha);
  const std::int64_t a = std::int64_t{u[alpha]} - v[alpha];
  const std::int64_t b = std::int64_t{u[beta]} - v[beta];
  const std::int64_t c = std::int64_t{v[gamma]} - u[gamma];
  const std::int64_t k = slot_number(defect, slot) - u[gamma];
  return a > 0 && b > 0 && c > 0 && a + b > c && k >= std::max<std::int64_t>(0, c - a) &&
         k < std::min(b, c);
}

}  // namespace

Flat::Flat(std::span<const NeighbourPlaces> neighbours, Colouring& colouring)
    : neighbours_(neighbours),
      colouring_(colouring),
      x_(neighbours.size(), {kUnsetNumber, kUnsetNumber, kUnsetNumber}),
      path_of_(colouring.defects.empty() ? 0 : neighbours.size(), DefectPaths::kNoPath) {}

bool Flat::number(PlaceRange part, std::span<const ColourDefect> defects) {
  constexpr int kAttempts = 10;
  defects_.assign(defects.begin(), defects.end());
  to_turn_.clear();
  if (defects_.empty()) return number_once(part);
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    Relabelling relabelling(neighbours_, colouring_.ports, defects_, part.size());
    for (const std::size_t d : to_turn_) {
      if (relabelling.exhausted()) break;
      if (defects_[d].label_x == defects_[d].label_y) continue;  // healed by the one before
      if (attempt % 3 == 1 || !relabelling.slide(d, attempt % 3 == 2)) relabelling.turn(d);
    }
    const bool possible = relabelling.avoid_labels_0_1();
    steps_.chain_steps += relabelling.steps();
    if (!possible) return false;
    relabelling.drop_healed();
    if (number_once(part)) return true;
    if (to_turn_.empty()) return false;
    for (Place v = part.begin; v < part.end; ++v) {
      x_[v] = {kUnsetNumber, kUnsetNumber, kUnsetNumber};
    }
  }
  return false;
}

bool Flat::number_once(PlaceRange part) {
  ++steps_.attempts;
  to_turn_.clear();
  slots_.clear();
  HeightPool pool(colouring_.ports, part, x_);
  std::optional<DefectPaths> paths;
  if (!defects_.empty()) paths.emplace(pool, defects_, path_of_);
  const auto is_later = [&](Place v) { return paths && paths->contains(v); };
  for (Place v = part.begin; v < part.end; ++v) {
    if (pool.ends_chain(v) && !pool.has_height(v, 0) && !pool.has_height(v, 1) && !is_later(v)) {
      number_path(pool, v);
    }
  }
  for (Place v = part.begin; v < part.end; ++v) {
    if (!pool.has_height(v, 0) && !is_later(v)) number_cycle(pool, v, buffer_);
  }
  std::span<const HeightSlot> slots;
  if (paths) {
    to_turn_ = paths->number_all();
    steps_.end_visits += paths->end_visits();
    slots = paths->slots();
  }
  steps_.heights_tried += pool.heights_tried();
  if (!to_turn_.empty()) return false;
  ThirdColourResult third = number_third_colour(colouring_.ports, part, defects_, slots, x_);
  steps_.blocks += third.blocks;
  to_turn_ = std::move(third.circle);
  if (!to_turn_.empty()) return false;
  for (std::size_t d = 0; d < defects_.size(); ++d) {
    if (!obeys(defects_[d], slots[d], x_)) return false;
    slots_.push_back({defects_[d].edge, slot_number(defects_[d], slots[d])});
  }
  return true;
}

}  // namespace ar3d::grid
