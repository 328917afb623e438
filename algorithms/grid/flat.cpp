// Steps 3.10 to 3.13 for one component: heights, paths that end at defects, the third colour;
// labels are changed and the numbering is repeated where the defects' rules contradict one another,
// ten times at most. A heuristic in size, not in truth: its rules are tested at the end. Cost: O(n
// log n) expected.

#include "ar3d/algorithms/grid/flat.h"

namespace ar3d::grid {
namespace {

/// (I4) and (I5) except the emptiness of slots, which DefectPaths keeps.
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

/// Numbers one component after the other such that X_0 + X_1 stays small at every vertex as long as
/// the defects are few or local: then one side of the box is short and the volume grows like n^2. A
/// heuristic: (I1)-(I3) hold by construction, (I4) and (I5) are tested at the end.
class FlatNumbers {
 public:
  FlatNumbers(const Graph& graph, const ProcessingOrder& order, std::uint64_t longest_chain)
      : order_(order),
        neighbours_(neighbours_in_order(graph, order)),
        colouring_(colour_half_edges(order, neighbours_, longest_chain)),
        x_(neighbours_.size(), kUnsetNumbers),
        path_of_(colouring_.defects.empty() ? 0 : neighbours_.size(), DefectPaths::kNoPath) {
    steps_.chain_steps = static_cast<std::int64_t>(colouring_.chain_steps);
  }

  /// Numbers what can be flat, and hands it on; returns the components that cannot.
  /// @param allowance  numbers beyond 2 n + this are not flat.
  std::vector<OrderPart> run(std::int64_t allowance, Planes& planes) {
    std::vector<OrderPart> left;
    std::span<const ColourDefect> defects(colouring_.defects);
    for (const OrderPart& part : order_.parts) {
      const auto of_part = std::ranges::find_if(
          defects, [&](const ColourDefect& defect) { return defect.x >= part.end; });
      const auto mine = defects.first(static_cast<std::size_t>(of_part - defects.begin()));
      defects = defects.subspan(mine.size());
      const std::span<const PlaneNumbers> numbers(&x_[part.begin], part.end - part.begin);
      const std::int64_t most = 2 * part.size() + allowance;
      if (number(part, mine) && std::ranges::all_of(numbers, [&](const PlaneNumbers& x) {
            return all_within(most, x);
          })) {
        adopt(part, planes);
      } else {
        left.push_back(part);
      }
    }
    planes.steps += steps_;
    return left;
  }

 private:
  bool number(const OrderPart& part, std::span<const ColourDefect> defects);
  bool number_once(const OrderPart& part);
  void adopt(const OrderPart& part, Planes& planes) const;

  const ProcessingOrder& order_;
  UnwrittenVector<PlacedRow> neighbours_;
  Colouring colouring_;
  UnwrittenVector<PlaneNumbers> x_;    ///< by index
  std::vector<ColourDefect> defects_;  ///< of the last component numbered
  std::vector<Slot> slots_;            ///< likewise
  std::vector<std::size_t> to_turn_;   ///< defects whose rules the last attempt could not keep
  std::vector<std::uint32_t> path_of_;
  std::vector<Index> buffer_;
  StepCounts steps_;
};

/// Numbers one component. May change its labels, which leave the colouring's ports if they belong
/// to a defect. False if a rule for a defect could not be kept; then its numbers and labels mean
/// nothing.
bool FlatNumbers::number(const OrderPart& part, std::span<const ColourDefect> defects) {
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
    for (Index v = part.begin; v < part.end; ++v) {
      x_[v] = kUnsetNumbers;
    }
  }
  return false;
}

bool FlatNumbers::number_once(const OrderPart& part) {
  ++steps_.attempts;
  to_turn_.clear();
  slots_.clear();
  HeightPool pool(colouring_.ports, part, x_);
  std::optional<DefectPaths> paths;
  if (!defects_.empty()) paths.emplace(pool, defects_, path_of_);
  const auto is_later = [&](Index v) { return paths && paths->contains(v); };
  for (Index v = part.begin; v < part.end; ++v) {
    if (pool.ends_chain(v) && !pool.has_height(v, 0) && !pool.has_height(v, 1) && !is_later(v)) {
      number_path(pool, v);
    }
  }
  for (Index v = part.begin; v < part.end; ++v) {
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
  to_turn_ = number_third_colour(colouring_.ports, part, defects_, slots, x_, steps_.blocks);
  if (!to_turn_.empty()) return false;
  for (std::size_t d = 0; d < defects_.size(); ++d) {
    if (!obeys(defects_[d], slots[d], x_)) return false;
    slots_.push_back({defects_[d].edge, slot_number(defects_[d], slots[d])});
  }
  return true;
}

/// Copies one component's labels and numbers from indices to vertices.
void FlatNumbers::adopt(const OrderPart& part, Planes& planes) const {
  const auto set_label = [&](EdgeId e, Index at, Index to, Colour label) {
    planes.labels.set(e, order_.sequence[at], order_.sequence[to], label);
  };
  for (Index i = part.begin; i < part.end; ++i) {
    if (i + kAhead < part.end) __builtin_prefetch(&planes.of[order_.sequence[i + kAhead]], 1);
    planes.of[order_.sequence[i]] = x_[i];
    const auto& to = colouring_.ports[i].to;
    for (const auto [other, edge] : neighbours_[i].halves()) {
      set_label(edge, i, other, to[0] == other ? 0 : to[1] == other ? 1 : 2);
    }
  }
  for (const ColourDefect& defect : defects_) {
    set_label(defect.edge, defect.x, defect.y, defect.label_x);
    set_label(defect.edge, defect.y, defect.x, defect.label_y);
  }
  planes.slots.insert(planes.slots.end(), slots_.begin(), slots_.end());
  planes.counts.flat_defects += static_cast<std::int64_t>(defects_.size());
}

}  // namespace

std::vector<OrderPart> number_flat(const Graph& graph, const ProcessingOrder& order,
                                   const PlaneOptions& options, Planes& planes) {
  return FlatNumbers(graph, order, options.longest_chain).run(options.flat_allowance, planes);
}

}  // namespace ar3d::grid
