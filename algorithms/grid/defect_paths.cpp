// Step 3.11. Paths of colours 0 and 1 that end at the x of a defect, which must come to lie above
// its y. Each is numbered from its middle outwards, in the order in which they wait for one
// another; those that wait in a circle grow side by side. Cost: O(log n) per height tried; a
// failing visit follows at most 1000 ends, once per path.
#include <algorithm>
#include <numeric>
#include <utility>

#include "ar3d/algorithms/grid/flat.h"
#include "ar3d/base/error.h"

namespace ar3d::grid {
namespace {

constexpr std::size_t kInTurns = 16;  // paths
constexpr int kDeepest = 1000;        // of ends that wait for one another
constexpr std::int64_t kLowest = std::numeric_limits<std::int32_t>::min();

}  // namespace

DefectPaths::DefectPaths(HeightPool& pool, std::span<const ColourDefect> defects,
                         std::vector<std::uint32_t>& path_of)
    : pool_(pool),
      height_limit_(height_limit(pool.part().size())),
      defects_(defects),
      by_x_(defects.size()),
      path_of_(path_of),
      slots_(defects.size()) {
  std::iota(by_x_.begin(), by_x_.end(), 0);
  std::ranges::sort(by_x_, {}, [&](std::size_t d) { return defects_[d].x; });
  for (std::size_t d = 0; d < defects_.size(); d += kInTurns) {
    collect(defects_.subspan(d, std::min(kInTurns, defects_.size() - d)));
  }
}

DefectPaths::~DefectPaths() {
  for (const Path& path : paths_) {
    for (const Index v : path.vertices) path_of_[v] = kNoPath;
  }
}

std::span<const std::size_t> DefectPaths::defects_at(Index x) const {
  const auto x_of = [&](std::size_t d) { return defects_[d].x; };
  const auto first = std::ranges::lower_bound(by_x_, x, {}, x_of) - by_x_.begin();
  const auto last = std::ranges::upper_bound(by_x_, x, {}, x_of) - by_x_.begin();
  return std::span(by_x_).subspan(static_cast<std::size_t>(first),
                                  static_cast<std::size_t>(last - first));
}

/// Every step of a path waits for the memory, so some paths are followed in turns; what one of them
/// has already is left out when they are added, in order.
void DefectPaths::collect(std::span<const ColourDefect> defects) {
  std::array<Path, kInTurns> paths;
  std::array<Index, kInTurns> at{};
  std::size_t count = 0;
  for (const ColourDefect& defect : defects) {
    if (contains(defect.x)) continue;
    paths[count].first_colour = pool_.neighbour(defect.x, 0) != kNoIndex ? 1 : 0;
    at[count++] = defect.x;
  }
  for (bool going = count > 0; going;) {
    going = false;
    for (std::size_t i = 0; i < count; ++i) {
      if (at[i] == kNoIndex) continue;
      auto& vertices = paths[i].vertices;
      vertices.push_back(at[i]);
      at[i] = pool_.neighbour(at[i], paths[i].colour_of(vertices.size()));
      if (at[i] != kNoIndex) pool_.prefetch_neighbours(at[i]);
      going = true;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!contains(paths[i].vertices.front())) add(std::move(paths[i]));
  }
}

void DefectPaths::add(Path path) {
  for (const Index v : path.vertices) path_of_[v] = static_cast<std::uint32_t>(paths_.size());
  const std::size_t size = path.vertices.size();
  path.both_ends = size > 1 && is_x(path.vertices.back());
  path.first = 2;
  path.last = path.both_ends ? size - 1 : size + 1;
  if (!path.both_ends) path.end[1] = EndState::done;
  paths_.push_back(std::move(path));
}

std::vector<std::size_t> DefectPaths::number_all() {
  const auto waiting = find_waiting();
  std::vector<std::uint32_t> ready;
  for (std::uint32_t p = 0; p < paths_.size(); ++p) {
    if (paths_[p].waits_for == 0) ready.push_back(p);
  }
  while (!ready.empty()) {
    const std::uint32_t p = ready.back();
    ready.pop_back();
    grow_alone(paths_[p]);
    finish_ends(p, 0);
    auto at = std::ranges::lower_bound(waiting, p, {}, [](const auto& w) { return w.first; });
    for (; at != waiting.end() && at->first == p; ++at) {
      if (--paths_[at->second].waits_for == 0) ready.push_back(at->second);
    }
  }
  grow_together();
  return blocked();
}

/// Finishes all ends; of those that cannot be finished, one defect for every two paths.
std::vector<std::size_t> DefectPaths::blocked() {
  std::vector<std::size_t> blocked;
  std::vector<std::uint8_t> touched(paths_.size(), 0);
  for (std::uint32_t p = 0; p < paths_.size(); ++p) {
    if (finish_ends(p, 0) || touched[p] != 0) continue;
    for (const Index x : {paths_[p].vertices.front(), paths_[p].vertices.back()}) {
      for (const std::size_t d : defects_at(x)) {
        const Index y = defects_[d].y;
        if (pool_.is_numbered(y) || touched[p] != 0 || touched[path_of_[y]] != 0) continue;
        touched[p] = touched[path_of_[y]] = 1;
        blocked.push_back(d);
      }
    }
  }
  return blocked;
}

/// Pairs (path with a y, path of its x), sorted; counts them in waits_for.
std::vector<std::pair<std::uint32_t, std::uint32_t>> DefectPaths::find_waiting() {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> waiting;
  for (const ColourDefect& defect : defects_) {
    const std::uint32_t lower = path_of_[defect.y];
    const std::uint32_t upper = path_of_[defect.x];
    if (lower == kNoPath || lower == upper) continue;
    waiting.emplace_back(lower, upper);
    ++paths_[upper].waits_for;
  }
  std::ranges::sort(waiting);
  return waiting;
}

/// Numbers the lowest joint: the middle one, or the one at the end without an x.
void DefectPaths::begin(Path& path) {
  path.grown = true;
  path.left = path.first;
  path.right = path.last;
  if (path.first >= path.last) return;
  const std::size_t lowest =
      path.both_ends ? path.first + (path.last - path.first) / 2 : path.last - 1;
  path.left = lowest;
  path.right = lowest + 1;
  path.floor = pool_.chain_start(path.colour_of(lowest));
  path.side = {path.floor, path.floor};
  set_joint(path, lowest, path.floor);
}

/// Numbers the next joint of a side (0: towards the first vertex), if it is not an end's.
void DefectPaths::grow(Path& path, unsigned side) {
  if (side == 0 ? path.left <= path.first : path.right >= path.last) return;
  const std::size_t joint = side == 0 ? --path.left : path.right++;
  const std::size_t at = side == 0 ? joint : joint - 1;
  const Index between = path.vertices[at];
  const auto ahead = [&](std::size_t steps) { return side == 0 ? at - steps : at + steps; };
  if (ahead(std::size_t{2} * kAhead) < path.vertices.size())
    pool_.prefetch(path.vertices[ahead(std::size_t{2} * kAhead)]);
  if (ahead(kAhead) < path.vertices.size()) pool_.prefetch_partner(path.vertices[ahead(kAhead)]);
  const Colour c = path.colour_of(joint);
  std::int64_t h = pool_.next_free(c, std::max(path.side[side] - 1, path.floor));
  while (!pool_.suits(between, c, h)) h = pool_.next_free(c, h + 1);
  path.side[side] = h;
  set_joint(path, joint, h);
}

void DefectPaths::set_joint(Path& path, std::size_t joint, std::int64_t h) {
  const Colour c = path.colour_of(joint);
  pool_.take_and_advance(c, h);
  if (joint > 0) pool_.set_height(path.vertices[joint - 1], c, h);
  if (joint < path.vertices.size()) pool_.set_height(path.vertices[joint], c, h);
}

void DefectPaths::grow_alone(Path& path) {
  begin(path);
  if (path.first >= path.last) return;
  while (path.left > path.first || path.right < path.last) {
    const bool leftwards =
        path.right >= path.last || (path.left > path.first && path.side[0] <= path.side[1]);
    grow(path, leftwards ? 0 : 1);
  }
}

/// The paths not grown yet, one joint a side in every round; shorter ones begin later, so that all
/// end together.
void DefectPaths::grow_together() {
  std::vector<std::uint32_t> rest;
  for (std::uint32_t p = 0; p < paths_.size(); ++p) {
    if (!paths_[p].grown) rest.push_back(p);
  }
  std::ranges::stable_sort(rest, std::ranges::greater{},
                           [&](std::uint32_t p) { return paths_[p].steps(); });
  std::size_t begun = 0;
  for (std::size_t left = rest.empty() ? 0 : paths_[rest[0]].steps() + 1; left > 0; --left) {
    for (std::size_t i = 0; i < begun; ++i) {
      grow(paths_[rest[i]], 0);
      grow(paths_[rest[i]], 1);
    }
    for (; begun < rest.size() && paths_[rest[begun]].steps() + 1 >= left; ++begun) {
      begin(paths_[rest[begun]]);
    }
  }
  for (const std::uint32_t p : rest) {  // sides of unequal length
    while (paths_[p].left > paths_[p].first) grow(paths_[p], 0);
    while (paths_[p].right < paths_[p].last) grow(paths_[p], 1);
  }
}

bool DefectPaths::finish_ends(std::uint32_t path, int depth) {
  const bool left = finish_end(path, 0, depth);
  const bool right = finish_end(path, 1, depth);
  return left && right;
}

/// False, with the end still open, if a y has no numbers and cannot get them now.
bool DefectPaths::finish_end(std::uint32_t p, unsigned side, int depth) {
  ++end_visits_;
  Path& path = paths_[p];
  if (path.end[side] == EndState::done) return true;
  if (path.end[side] == EndState::in_progress || !path.grown || depth > kDeepest) return false;
  const bool shared = path.both_ends && path.vertices.size() == 2;  // the two ends share a joint
  const std::array<Index, 2> both = {path.vertices.front(), path.vertices.back()};
  const std::span<const Index> xs(both.data() + (shared ? 0 : side), shared ? 2 : 1);
  const auto set_state = [&](EndState state) {
    path.end[side] = state;
    if (shared) path.end[1 - side] = state;
  };
  set_state(EndState::in_progress);
  const bool possible = number_lower_ends(xs, depth);
  if (possible) place(xs);
  set_state(possible ? EndState::done : EndState::open);
  return possible;
}

/// A y without numbers is an end of a path, or next to one.
bool DefectPaths::number_lower_ends(std::span<const Index> xs, int depth) {
  for (const Index x : xs) {
    for (const std::size_t d : defects_at(x)) {
      const Index y = defects_[d].y;
      if (pool_.is_numbered(y)) continue;
      const std::uint32_t q = path_of_[y];
      expect(q != kNoPath, "all other chains have numbers");
      const std::vector<Index>& on = paths_[q].vertices;
      const bool near_first = on[0] == y || (on.size() > 1 && on[1] == y);
      const bool near_last = on.back() == y || (on.size() > 1 && on[on.size() - 2] == y);
      if (near_first && !finish_end(q, 0, depth + 1)) return false;
      if (near_last && !finish_end(q, 1, depth + 1)) return false;
      if (!pool_.is_numbered(y)) return false;
    }
  }
  return true;
}

/// Slots first, then the heights of the x's above them.
void DefectPaths::place(std::span<const Index> xs) {
  for (const Index x : xs) {
    for (const std::size_t d : defects_at(x)) keep_slot(d);
  }
  for (const bool shared_first : {true, false}) {
    for (const Index x : xs) {
      for (const Colour c : {0u, 1u}) {
        if ((pool_.neighbour(x, c) != kNoIndex) == shared_first && !pool_.has_height(x, c)) {
          place_colour(xs, x, c);
        }
      }
    }
  }
  for (const Index x : xs) {
    for (const std::size_t d : defects_at(x)) {
      slots_[d].below_x = pool_.height(x, 1 - defects_[d].label_x) - slots_[d].low;
    }
  }
}

void DefectPaths::keep_slot(std::size_t d) {
  const ColourDefect& defect = defects_[d];
  const Colour c = 1 - defect.label_x;
  const Index next = pool_.neighbour(defect.x, c);
  const std::int64_t near =  // the path's last number, or where new chains begin
      next != kNoIndex && pool_.has_height(next, 1 - c) ? pool_.height(next, 1 - c) - 1
                                                        : pool_.chain_start(c);
  const std::int64_t from = std::max(pool_.height(defect.y, c) + 1, near);
  slots_[d].low = pool_.next_free_pair(c, std::min(from, height_limit_));
  pool_.take(c, slots_[d].low);
  pool_.take(c, slots_[d].low + 1);
}

std::int64_t DefectPaths::least_height(Index x, Colour c) const {
  std::int64_t least = kLowest;
  for (const std::size_t d : defects_at(x)) {
    const ColourDefect& defect = defects_[d];
    const std::int64_t above_slot = slots_[d].low + 2;
    const Colour slot_colour = 1 - defect.label_x;
    least = std::max(least, c == slot_colour ? above_slot
                                             : pool_.height(defect.y, c) + above_slot -
                                                   pool_.height(defect.y, slot_colour));
  }
  return least;
}

/// x's height of colour c, shared with its neighbour along c if there is one.
void DefectPaths::place_colour(std::span<const Index> xs, Index x, Colour c) {
  const Index other = pool_.neighbour(x, c);
  std::int64_t from = least_height(x, c);
  for (const Index v : xs) {
    if (v == other) from = std::max(from, least_height(v, c));
  }
  for (const Index v : {x, other}) {
    if (v != kNoIndex && pool_.has_height(v, 1 - c)) {
      from = std::max(from, pool_.height(v, 1 - c) - 1);
    }
  }
  std::int64_t h = pool_.next_free(c, std::min(from, height_limit_));
  while (!pool_.suits(x, c, h) || (other != kNoIndex && !pool_.suits(other, c, h))) {
    h = pool_.next_free(c, h + 1);
  }
  pool_.take(c, h);  // one outlier must not lift the chains that follow
  pool_.set_height(x, c, h);
  if (other != kNoIndex) pool_.set_height(other, c, h);
}

}  // namespace ar3d::grid
