// Steps G.4 and G.5, the paper's lemma "flat single cycle": plus and minus signs, three bends for
// an edge with equal signs, one for the edge of an odd cycle with both. What is tested before a
// vertex keeps its place is all that hangs on it, not only the edge that is drawn (Repair G.8).
// Places are looked for to the right only, and the test stops at vertices too far to the left to be
// reached. Cost: a few comparisons a vertex in practice, with all others at worst.
#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>

#include "ar3d/algorithms/grid_paper/builder.h"
#include "ar3d/base/error.h"

namespace ar3d::grid_paper {
namespace {

constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();

/// A piece of a polyline in the layer, the end with the smaller x first, of equal x that with the
/// smaller h.
using LayerPiece = std::pair<LayerPoint, LayerPoint>;

LayerPiece piece(LayerPoint a, LayerPoint b) {
  return a.x < b.x || (a.x == b.x && a.h < b.h) ? LayerPiece{a, b} : LayerPiece{b, a};
}

/// The least and the largest h that a piece has at x.
std::pair<std::int64_t, std::int64_t> range_at(const LayerPiece& p, std::int64_t x) {
  if (p.first.x == p.second.x) return {p.first.h, p.second.h};
  const std::int64_t h =
      p.first.h < p.second.h ? p.first.h + (x - p.first.x) : p.first.h - (x - p.first.x);
  return {h, h};
}

/// The least and the largest move of a piece along h with which it touches a fixed one, the least
/// above the largest if there is none: differences of linear functions of x, so the ends of the
/// common range of x decide.
std::pair<std::int64_t, std::int64_t> touching_shifts(const LayerPiece& moving,
                                                      const LayerPiece& fixed) {
  const std::int64_t from = std::max(moving.first.x, fixed.first.x);
  const std::int64_t to = std::min(moving.second.x, fixed.second.x);
  std::int64_t least = kMost, largest = -kMost;
  if (from > to) return {least, largest};
  for (const std::int64_t x : {from, to}) {
    const auto [fixed_low, fixed_high] = range_at(fixed, x);
    const auto [low, high] = range_at(moving, x);
    least = std::min(least, fixed_low - high);
    largest = std::max(largest, fixed_high - low);
  }
  return {least, largest};
}

class FlatCycleDrawer {
 public:
  FlatCycleDrawer(const std::vector<std::int64_t>& x, Spread spread, std::int64_t least_run,
                  bool all_spread)
      : x_(x), spread_(spread), least_run_(least_run), all_spread_(all_spread), size_(x.size()) {
    expect(size_ >= 3 && (!is_odd() || x[0] < x[1]), "a flat cycle begins upwards");
  }

  FlatCycle run() {
    choose_lines();
    cycle_.bends.resize(size_);
    const LayerPoint first{0, x_[0]};
    begin_vertex(first, {leg(first), piece(first, corner(first, closing_)),
                         piece(corner(first, closing_), {0, closing_})});
    if (is_odd()) {
      draw_mixed_edge();
    } else {
      add_leave(0);
    }
    while (cycle_.at.size() < size_) place_next();
    cycle_.bends.back() = {corner(first, closing_),
                           {0, closing_},
                           {cycle_.at.back().h - (x_.back() - closing_), closing_}};
    return std::move(cycle_);
  }

 private:
  bool is_odd() const { return size_ % 2 == 1; }
  /// The line along e_Y that edge i < size - 1 runs on: above its ends for two plus signs.
  std::int64_t line(std::size_t i) const {
    return (i + size_) % 2 == 0 ? std::max(x_[i], x_[i + 1]) + 2 : std::min(x_[i], x_[i + 1]) - 2;
  }
  void choose_lines() {
    closing_ = *std::min_element(x_.begin(), x_.end());
    std::int64_t highest = closing_;
    for (std::size_t i = is_odd() ? 1 : 0; i + 1 < size_; ++i) {
      closing_ = std::min(closing_, line(i));
      highest = std::max(highest, line(i));
    }
    closing_ -= 2;
    full_run_ = (highest - closing_) / 2 + 2;
  }

  /// Half way from v to a line, where an edge that leaves v to the left turns back.
  static LayerPoint corner(LayerPoint v, std::int64_t line) {
    return {v.h - std::abs(line - v.x) / 2, (v.x + line) / 2};
  }
  static LayerPiece leg(LayerPoint v) { return {v, {v.h + 2, v.x}}; }

  void begin_vertex(LayerPoint v, const std::vector<LayerPiece>& pieces) {
    cycle_.at.push_back(v);
    first_piece_.push_back(pieces_.size());
    pieces_.insert(pieces_.end(), pieces.begin(), pieces.end());
  }
  void add_leave(std::size_t i) {
    const LayerPoint v = cycle_.at[i], turn = corner(v, line(i)), on_line{v.h, line(i)};
    pieces_.insert(pieces_.end(), {piece(v, turn), piece(turn, on_line)});
  }

  /// Edge 0 of an odd cycle: plus at vertex 0, minus at vertex 1, one bend.
  void draw_mixed_edge() {
    const LayerPoint v = cycle_.at[0], w{0, x_[1]}, turn = corner(v, w.x);
    pieces_.insert(pieces_.end(), {piece(v, turn), piece(turn, w)});
    cycle_.bends[0] = {turn};
    begin_vertex(w, {leg(w)});
    add_leave(1);
  }

  /// Vertex i and the edge to it from vertex i - 1: "leave" is drawn, "run" and "enter" are not.
  void place_next() {
    const std::size_t i = cycle_.at.size();
    const LayerPoint before = cycle_.at[i - 1];
    const std::int64_t on = line(i - 1), drop = std::abs(on - x_[i]);
    LayerPoint v{before.h + 2 * least_run_ + drop, x_[i]};
    std::vector<LayerPiece> fresh{leg(v), piece({v.h - drop, on}, v)};
    if (i + 1 < size_) {
      const LayerPoint turn = corner(v, line(i)), end{v.h, line(i)};
      fresh.insert(fresh.end(), {piece(v, turn), piece(turn, end)});
    } else {
      fresh.push_back(piece({v.h - (v.x - closing_), closing_}, v));
    }
    const std::int64_t shift = shift_of(fresh, i);
    if (shift > 0) ++cycle_.spread;
    v.h += shift;
    for (LayerPiece& p : fresh) {
      p.first.h += shift;
      p.second.h += shift;
    }
    cycle_.bends[i - 1] = {corner(before, on), {before.h, on}, {v.h - drop, on}};
    fresh.push_back(piece({before.h, on}, {v.h - drop, on}));  // the run, for those that follow
    begin_vertex(v, fresh);
  }

  /// Returns how much further right than the nearest place the fresh pieces of vertex i lie; even.
  std::int64_t shift_of(const std::vector<LayerPiece>& fresh, std::size_t i) const {
    const std::int64_t full = 2 * (full_run_ - least_run_);
    if (spread_ == Spread::columns) return full;
    std::vector<std::pair<std::int64_t, std::int64_t>> touching;
    if (all_spread_) touching = touching_placed(fresh);
    if (i + 1 == size_) {  // the closing run has a length
      const std::int64_t run =
          std::min(fresh.back().first.h, fresh.back().second.h) - cycle_.at[0].h;
      touching.emplace_back(-kMost, 1 - run);
    }
    std::ranges::sort(touching);
    std::int64_t shift = 0;
    for (const auto& [low, high] : touching) {
      if (low <= shift && shift <= high) shift = high + 1 + (high + 1) % 2;
    }
    return spread_ == Spread::least || shift == 0 ? shift : full;
  }

  /// The shifts >= 0 for which a fresh piece touches a piece that is placed. No piece of a vertex
  /// lies further right than its leg.
  std::vector<std::pair<std::int64_t, std::int64_t>> touching_placed(
      const std::vector<LayerPiece>& fresh) const {
    std::int64_t left = fresh[0].first.h;
    for (const LayerPiece& p : fresh) left = std::min({left, p.first.h, p.second.h});
    std::vector<std::pair<std::int64_t, std::int64_t>> touching;
    std::size_t j = cycle_.at.size();
    for (; j > 0 && cycle_.at[j - 1].h + 2 >= left; --j) {
      const std::size_t end = j == cycle_.at.size() ? pieces_.size() : first_piece_[j];
      for (std::size_t k = first_piece_[j - 1]; k < end; ++k) {
        for (const LayerPiece& p : fresh) {
          const auto [low, high] = touching_shifts(p, pieces_[k]);
          if (low <= high && high >= 0) touching.emplace_back(low, high);
        }
      }
    }
    return touching;
  }

  const std::vector<std::int64_t>& x_;
  Spread spread_;
  std::int64_t least_run_;
  bool all_spread_;
  std::size_t size_;
  std::int64_t closing_ = 0;   // the line of the edge that closes the cycle
  std::int64_t full_run_ = 0;  // half of a run that is always long enough
  std::vector<LayerPiece> pieces_;
  std::vector<std::size_t> first_piece_;  // of every vertex
  FlatCycle cycle_;
};

}  // namespace

FlatCycle draw_flat_cycle(const std::vector<std::int64_t>& x, Spread spread, std::int64_t least_run,
                          bool all_spread) {
  return FlatCycleDrawer(x, spread, least_run, all_spread).run();
}

}  // namespace ar3d::grid_paper
