#include "ar3d/algorithms/grid/placement.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "ar3d/model/error.h"

namespace ar3d::grid {
namespace {

constexpr std::int32_t kUnset = std::numeric_limits<std::int32_t>::min();
constexpr std::uint64_t kSeed =
    0x677269642d330001;  // the stream belongs to the algorithm: same graph, same drawing

std::int32_t narrow(std::int64_t x) {
  expect(x > kUnset && x <= std::numeric_limits<std::int32_t>::max(), "plane numbers fit 32 bits");
  return static_cast<std::int32_t>(x);
}

}  // namespace

Placement::Placement(const Graph& graph, const ProcessingOrder& order, const Labels& labels,
                     const PlaneOptions& options, std::int64_t zone)
    : graph_(graph),
      order_(order),
      proof_{graph.num_vertices()},
      options_(options),
      window_(proof_.window(options)),
      zone_(zone),
      planes_{std::vector<PlaneNumbers>(graph.num_vertices(), {kUnset, kUnset, kUnset}),
              labels.of,
              {},
              {}},
      taken_{NumberSet(2 * window_), NumberSet(2 * window_), NumberSet(2 * window_)},
      near_taken_{NumberSet(2 * window_), NumberSet(2 * window_), NumberSet(2 * window_)},
      sums_(3 * window_),
      random_(kSeed),
      search_(sums_, random_, proof_.sure_length()),
      triple_search_(sums_, random_, proof_.sure_triple_length()) {}

bool Placement::place_all() {
  for (const OrderPart& part : order_.parts) {
    if (!place_part(part)) return false;
  }
  return true;
}

Planes Placement::result() && {
  std::ranges::sort(planes_.slots, {}, &Slot::edge);
  return std::move(planes_);
}

bool Placement::place_part(const OrderPart& part) {
  in_cubic_ = part.cubic;
  if (part.cubic) {
    set_aside(part);
    place_f();
  }
  const std::size_t begin = part.cubic ? part.begin + 1 : part.begin;
  const std::size_t end = part.cubic ? part.end - 1 : part.end;
  for (std::size_t i = begin; i < end; ++i) {
    const Site site = look(order_.sequence[i]);
    const bool is_x_m = site.next_to_f && aside_.is_defect() && site.label_to_f == aside_.m;
    const bool placed = site.opens != 0 ? place_clash(site)
                        : is_x_m        ? place_x_m(site)
                                        : place_ordinary(site);
    if (!placed) return false;
  }
  return !part.cubic || place_last();
}

bool Placement::is_placed(Vertex v) const { return missing_colours(v) == 0; }

ColourSet Placement::missing_colours(Vertex v) const {
  ColourSet missing = 0;
  for (Colour c = 0; c < kColours; ++c) {
    if (planes_.of[v][c] == kUnset) missing |= only(c);
  }
  return missing;
}

Placement::Site Placement::look(Vertex v) const {
  Site site;
  site.v = v;
  for (const HalfEdge& half : graph_.incident(v)) {
    if (in_cubic_ && half.edge == aside_.edge) continue;
    const Colour label = planes_.labels.at(half.edge, v, half.to);
    if (in_cubic_ && half.to == aside_.f) {
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

/// Ordinary vertices (P1): the planes of back U-edges are given, everything else is new, and the
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
    const auto number = choose(site, c, {rules.data(), num_rules});
    if (!number) return false;
    take(c, *number);
    assign(site, c, *number);
  }
  return true;
}

std::optional<std::int64_t> Placement::choose(const Site& site, Colour c,
                                              std::span<const SumRule> rules) {
  for (const std::int64_t percent : {100, 112, 125, 150, 200}) {
    const Range range = preferred_range(site, c, window_ * percent / 100);
    if (range.empty()) continue;
    if (const auto x = best_of_two(range, c, rules)) return x;
    if (!options_.compact_windows) break;
  }
  const std::int64_t far = zoned() ? std::min(zone_ - 1, proof_.far_window()) : proof_.far_window();
  const auto above = search_.find(Direction::up, taken_[c], rules, {0, far});
  const auto below = search_.find(Direction::down, taken_[c], rules, {-far, 0});
  if (above && below) return *above < -*below ? above : below;
  if (above || below) return above ? above : below;
  return search_.find(Direction::up, taken_[c], rules,
                      {-far, far});  // counting: far enough suffices
}

/// Two random numbers of the range; the one with the larger sum |S| wins, since sums near 0 are in
/// demand later.
std::optional<std::int64_t> Placement::best_of_two(Range range, Colour c,
                                                   std::span<const SumRule> rules) {
  constexpr int kTries = 8;
  constexpr int kWords = 4;
  const bool sum_is_known = !rules.empty() && rules[0].is_new;
  std::optional<std::int64_t> best;
  for (int i = 0; i < kTries; ++i) {
    const auto offset = random_.below64(static_cast<std::uint64_t>(range.length()));
    const Range tail{range.low + static_cast<std::int64_t>(offset), range.high};
    const auto x = search_.near_low(taken_[c], rules, tail, kWords);
    if (!x) continue;
    if (!sum_is_known || !options_.compact_windows) return x;
    const std::int64_t known = rules[0].known;
    if (best) return std::abs(known + *x) > std::abs(known + *best) ? x : best;
    best = x;
  }
  return best;
}

/// Numbers that keep every sum of two plane numbers, here and at the forward neighbour, within
/// `box`: these sums are the Cartesian coordinates.
Range Placement::preferred_range(const Site& site, Colour c, std::int64_t box) const {
  Range range{-window_, window_};
  if (!options_.compact_windows) return range;
  range = narrowed(range, site.v, c, box);
  if (!contains(site.forward_colours, c)) return range;
  range = narrowed(range, site.forward[c].to, c, box);
  if (const auto rival = rival_plane(site, c)) {
    range.low = std::max(range.low, *rival - box / 32);
    range.high = std::min(range.high, *rival + box / 32);
  }
  return range;
}

/// The plane of the other earlier neighbour if v opens the second plane towards a clash vertex: the
/// closer the two planes, the smaller A and the closer H and L can stay to w.
std::optional<std::int64_t> Placement::rival_plane(const Site& site, Colour c) const {
  const HalfEdge& half = site.forward[c];
  if (planes_.labels.at(half.edge, half.to, site.v) != kNoColour) return std::nullopt;
  for (const HalfEdge& other : graph_.incident(half.to)) {
    if (other.to == site.v || planes_.labels.at(other.edge, half.to, other.to) != kNoColour)
      continue;
    if (planes_.of[other.to][c] != kUnset) return planes_.of[other.to][c];
  }
  return std::nullopt;
}

Range Placement::narrowed(Range range, Vertex v, Colour c, std::int64_t box) const {
  for (const Colour other : {next(c), previous(c)}) {
    const std::int32_t x = planes_.of[v][other];
    if (x == kUnset) continue;
    range.low = std::max(range.low, -box - x);
    range.high = std::min(range.high, box - x);
  }
  return range;
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
