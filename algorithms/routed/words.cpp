// Step R.3, the words: every sequence of directions with allowed turns, and every choice of three
// independent ones among them. Given the other lengths, the three follow from the ends by the
// inverse of a 3 x 3 matrix of determinant 2 or 4. Words that differ in the order of their segments
// alone form a group and share that arithmetic, which is most of a search's time without groups.
// Cost: once a process, 0.1 s in the worst case (face diagonals, five bends).
#include "ar3d/algorithms/routed/words.h"

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <numeric>

namespace ar3d::routed {
namespace {

constexpr unsigned kBitsOfDirection = 4;

}  // namespace

std::uint16_t Words::basis_of(int a, int b, int c) {
  const auto key = static_cast<std::uint32_t>(a << 8 | b << 4 | c);
  const auto known = std::find(basis_keys_.begin(), basis_keys_.end(), key);
  if (known != basis_keys_.end()) {
    return static_cast<std::uint16_t>(known - basis_keys_.begin());
  }
  const Spot p = points_.step(a);
  const Spot q = points_.step(b);
  const Spot r = points_.step(c);
  Basis basis{{cross(q, r), cross(r, p), cross(p, q)}, 0};
  int determinant = dot(p, basis.rows[0]);
  if (determinant < 0) {
    determinant = -determinant;
    for (Spot& row : basis.rows) row = -1 * row;
  }
  while (1 << basis.log_determinant < determinant) ++basis.log_determinant;
  basis_keys_.push_back(key);
  bases_.push_back(basis);
  return static_cast<std::uint16_t>(bases_.size() - 1);
}

/// Adds every choice of three independent segments.
void Words::split(const std::vector<int>& directions) {
  const std::size_t segments = directions.size();
  for (std::size_t i = 0; i < segments; ++i) {
    for (std::size_t j = i + 1; j < segments; ++j) {
      for (std::size_t k = j + 1; k < segments; ++k) {
        if (dot(points_.step(directions[i]),
                cross(points_.step(directions[j]), points_.step(directions[k]))) == 0) {
          continue;
        }
        std::vector<std::size_t> order(segments);
        std::iota(order.begin(), order.end(), std::size_t{0});
        const auto rank = [&](std::size_t t) {
          const bool is_chosen = t != i && t != j && t != k;
          return std::pair(is_chosen, directions[t]);
        };
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
        Keyed found;
        found.key = segments;
        for (std::size_t t = 0; t < kMostSegments; ++t) {
          found.key <<= kBitsOfDirection;
          if (t >= segments) continue;
          found.word.direction[t] = static_cast<std::uint8_t>(directions[t]);
          found.key |= static_cast<std::uint64_t>(directions[order[t]]);
          (t < 3 ? found.word.solved[t] : found.word.chosen[t - 3]) =
              static_cast<std::uint8_t>(order[t]);
        }
        found_.push_back(found);
      }
    }
  }
}

void Words::extend(std::vector<int>& directions, Directions first, Directions last) {
  if (directions.size() >= 3 && has(last, directions.back())) split(directions);
  if (directions.size() == static_cast<std::size_t>(bends_) + 1) return;
  const Directions next = directions.empty() ? first : points_.turns(directions.back());
  for (int d = 0; d < points_.num_directions(); ++d) {
    if (!has(next, d)) continue;
    directions.push_back(d);
    extend(directions, first, last);
    directions.pop_back();
  }
}

void Words::group(std::size_t from, std::size_t to) {
  found_.clear();
  Directions last = 0;
  for (int d = 0; d < points_.num_directions(); ++d) {
    if (has(points_.frames()[to], PointClass::opposite(d))) {
      last = static_cast<Directions>(last | 1u << d);
    }
  }
  std::vector<int> directions;
  extend(directions, points_.frames()[from], last);
  std::stable_sort(found_.begin(), found_.end(),
                   [](const Keyed& a, const Keyed& b) { return a.key < b.key; });
  std::vector<WordGroup>& groups = groups_.emplace_back();
  for (std::size_t i = 0; i < found_.size(); ++i) {
    const DirectionWord& word = found_[i].word;
    words_.push_back(word);
    if (i > 0 && found_[i].key == found_[i - 1].key) {
      ++groups.back().count;
      continue;
    }
    WordGroup group;
    group.first = static_cast<std::uint32_t>(words_.size() - 1);
    group.count = 1;
    group.segments = static_cast<std::uint8_t>(found_[i].key >> kBitsOfDirection * kMostSegments);
    group.num_chosen = static_cast<std::uint8_t>(group.segments - 3);
    group.basis = basis_of(word.direction[word.solved[0]], word.direction[word.solved[1]],
                           word.direction[word.solved[2]]);
    const Basis& basis = bases_[group.basis];
    group.log_determinant = static_cast<std::uint8_t>(basis.log_determinant);
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t k = 0; k < group.num_chosen; ++k) {
        group.taken[row][k] = static_cast<std::int16_t>(
            dot(basis.rows[row], points_.step(word.direction[word.chosen[k]])));
      }
    }
    groups.push_back(group);
  }
}

Words::Words(const PointClass& points, int bends) : points_(points), bends_(bends) {
  const std::size_t frames = points.frames().size();
  for (std::size_t from = 0; from < frames; ++from) {
    for (std::size_t to = 0; to < frames; ++to) group(from, to);
  }
  found_ = {};
}

const Words& Words::of(const PointClass& points, int bends) {
  static std::mutex one_at_a_time;
  static std::map<std::pair<bool, int>, std::unique_ptr<const Words>> made;
  const std::lock_guard lock(one_at_a_time);
  std::unique_ptr<const Words>& words = made[{points.is_body(), bends}];
  if (!words) words.reset(new Words(points, bends));
  return *words;
}

}  // namespace ar3d::routed
