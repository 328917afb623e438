// Steps 3.3 to 3.5: the core's numbers, vertex by vertex in processing order. Ordinary vertices are
// here, clashes in placement_clash.cpp, the edge set aside in placement_aside.cpp. Random numbers in
// the window come first, since near numbers make small drawings; Lemma 3.4 says why a number is
// always found. Cost: O(log n) expected per number.
#include "ar3d/algorithms/grid/placement.h"

namespace ar3d::grid {
namespace {

constexpr std::uint64_t kSeed =
    0x677269642d330001;  // the stream belongs to the algorithm: same graph, same drawing

}  // namespace

Placement::Placement(const PlacedGraph& graph, const OrderPart& part, Planes& planes,
                     std::int64_t window, std::int64_t zone)
    : graph_(graph),
      part_(part),
      proof_{part.size()},
      window_(window),
      zone_(zone),
      planes_(planes),
      counts_before_(planes.counts),
      slots_before_(planes.slots.size()),
      taken_{NumberSet(2 * window_), NumberSet(2 * window_), NumberSet(2 * window_)},
      near_taken_{NumberSet(2 * window_), NumberSet(2 * window_), NumberSet(2 * window_)},
      sums_(3 * window_),
      random_(kSeed),
      search_(sums_, random_, proof_.sure_length()),
      triple_search_(sums_, random_, proof_.sure_triple_length()) {}

bool Placement::place_all() {
  const bool placed = place_vertices();
  ++planes_.steps.attempts;
  planes_.steps.blocks += search_.blocks() + triple_search_.blocks();
  if (!placed) undo();
  return placed;
}

void Placement::undo() {
  planes_.counts = counts_before_;
  planes_.slots.resize(slots_before_);
  for (Index v = part_.begin; v < part_.end; ++v) {
    planes_.of[v] = kUnsetNumbers;
  }
  for (const auto& [v, half] : clash_edges_) planes_.labels.set(half.edge, v, half.to, kNoColour);
}

bool Placement::place_vertices() {
  if (part_.cubic) {
    set_aside();
    place_f();
  }
  const Index ends = part_.cubic ? 1 : 0;
  for (Index v = part_.begin + ends; v < part_.end - ends; ++v) {
    prefetch_ahead(v);
    const Site site = look(v);
    const bool is_x_m = site.next_to_f && aside_.is_defect() && site.label_to_f == aside_.m;
    const bool placed = site.opens != 0 ? place_clash(site)
                        : is_x_m        ? place_x_m(site)
                                        : place_ordinary(site);
    if (!placed) return false;
  }
  return !part_.cubic || place_last();
}

/// The far ends of the edges that close cycles are nowhere near in memory.
void Placement::prefetch_ahead(Index v) const {
  if (v + kAhead >= part_.end) return;
  for (const HalfEdge& half : graph_.incident(v + kAhead)) {
    planes_.labels.prefetch(half.edge);
    __builtin_prefetch(&planes_.of[half.to], 1);
  }
}

bool Placement::is_placed(Vertex v) const { return missing_colours(v) == 0; }

ColourSet Placement::missing_colours(Vertex v) const {
  ColourSet missing = 0;
  for (Colour c = 0; c < kColours; ++c) {
    if (planes_.of[v][c] == kUnsetNumber) missing |= only(c);
  }
  return missing;
}

Placement::Site Placement::look(Vertex v) const {
  Site site;
  site.v = v;
  for (const HalfEdge& half : graph_.incident(v)) {
    if (part_.cubic && half.edge == aside_.edge) continue;
    const Colour label = planes_.labels.at(half.edge, v, half.to);
    if (part_.cubic && half.to == aside_.f) {
      site.next_to_f = true;
      site.label_to_f = label;
    } else if (!is_placed(half.to)) {
      site.forward[label] = half;
      site.forward_colours |= only(label);
    } else if (label == kNoColour) {
      site.open[site.opens++] = half;
    } else {
      site.rule.join(sum_of(planes_.of[half.to]));
    }
  }
  return site;
}

/// Step 3.3: the planes of back U-edges are given, everything else is new, and the
/// last number makes the sum new and far from those of the neighbours along U-edges.
bool Placement::place_ordinary(const Site& site) {
  if (!choose_colours(site, missing_colours(site.v))) return false;
  finish(site);
  return true;
}

bool Placement::choose_colours(const Site& site, ColourSet colours) {
  expect(colours != 0, "an ordinary vertex has a number to choose");
  while (colours != 0) {
    const Colour c = first_of(colours);
    colours &= ~only(c);
    std::array<SumRule, 2> rules;
    std::size_t num_rules = 0;
    if (colours == 0) {
      rules[num_rules] = site.rule;
      const PlaneNumbers& x = planes_.of[site.v];
      rules[num_rules++].known = std::int64_t{x[next(c)]} + x[previous(c)];
    }
    if (const auto apart = apart_rule(site, c)) rules[num_rules++] = *apart;
    const auto number = choose(c, {rules.data(), num_rules});
    if (!number) return false;
    take(c, *number);
    assign(site, c, *number);
  }
  return true;
}

std::optional<std::int64_t> Placement::choose(Colour c, std::span<const SumRule> rules) {
  if (const auto x = random_in_window(c, rules)) return x;
  const std::int64_t far = zoned() ? std::min(zone_ - 1, proof_.far_window()) : proof_.far_window();
  const auto above = search_.find_up(taken_[c], rules, {0, far});
  const auto below = search_.find_down(taken_[c], rules, {-far, 0});
  if (above && below) return *above < -*below ? above : below;
  if (above || below) return above ? above : below;
  return search_.find_up(taken_[c], rules, {-far, far});  // counting: far enough suffices
}

std::optional<std::int64_t> Placement::random_in_window(Colour c, std::span<const SumRule> rules) {
  constexpr int kTries = 8;
  constexpr int kWords = 4;
  for (int i = 0; i < kTries; ++i) {
    const auto offset = random_.below64(static_cast<std::uint64_t>(2 * window_ + 1));
    const NumberRange tail{static_cast<std::int64_t>(offset) - window_, window_};
    if (const auto x = search_.near_low(taken_[c], rules, tail, kWords)) return x;
  }
  return std::nullopt;
}

/// Gives v the number, and the forward neighbour too if the edge is a U-edge.
void Placement::assign(const Site& site, Colour c, std::int64_t number) {
  planes_.of[site.v][c] = narrow(number);
  if (!contains(site.forward_colours, c)) return;
  const HalfEdge& half = site.forward[c];
  if (planes_.labels.at(half.edge, half.to, site.v) == c) planes_.of[half.to][c] = narrow(number);
}

void Placement::take(Colour c, std::int64_t number) {
  expect(taken_[c].insert(number), "every new number is fresh (I3)");
  for (std::int64_t j = 0; j < 3; ++j) near_taken_[c].insert(number + j);
}

void Placement::finish(const Site& site) {
  expect(sums_.insert(sum_of(planes_.of[site.v])), "sums are distinct (I1)");
}

}  // namespace ar3d::grid
