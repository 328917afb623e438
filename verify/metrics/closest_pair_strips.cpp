// The closest pair by sorting instead of a tree of boxes. The vertices are sorted along the
// widest axis; the smallest distance of two that are consecutive there bounds the smallest of all.
// So the two vertices searched for are in one strip of that width or in two consecutive ones, and
// within each strip, sorted along the second widest axis, not far from each other. Pairs farther
// apart than kLongest along an axis are not multiplied out, so coordinates may have any size.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <vector>

#include "ar3d/verify/crossings/radix_sort.h"
#include "ar3d/verify/metrics/summary_pass.h"
#include "ar3d/verify/predicates/exact.h"
#include "ar3d/verify/predicates/functional.h"

namespace ar3d::verify {
namespace {

/// Nine terms of differences up to 2^42 and Gram entries below 2^31 stay below 2^119.
constexpr std::int64_t kFarthest = std::int64_t{1} << 42;
/// Squared lengths up to here are exact in a double too: every closest pair has the same length.
constexpr std::int64_t kLongest = std::int64_t{1} << 40;
constexpr std::uint64_t kPairsPerVertex = 60;
constexpr std::int64_t kShort = std::numeric_limits<std::uint32_t>::max();

struct Placed {
  Point at;
  Vertex v;
};

class Strips {
 public:
  explicit Strips(const Drawing& drawing)
      : drawing_(drawing),
        lattice_(drawing.lattice()),
        inverse_(inverse_diagonal(lattice_)),
        left_(kPairsPerVertex * drawing.num_vertices()) {
    for (const auto& row : lattice_.gram) {
      for (const std::int64_t entry : row) largest_gram_ = std::max(largest_gram_, std::abs(entry));
    }
    GrowingBox box;
    for (std::size_t v = 0; v < drawing.num_vertices(); ++v) box.add(at(v));
    box_ = box.box();
  }

  std::optional<VertexPair> run() {
    std::int64_t farthest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      farthest_[i] = reach(static_cast<double>(kLongest), inverse_[i]);
      farthest = std::max(farthest, farthest_[i]);
    }
    if (farthest > kFarthest || !in_range(box_.low) || !in_range(box_.high)) return std::nullopt;
    choose_axes();
    // Nine terms of squared differences up to 2^52 and entries up to 2^7 stay below 2^63.
    const bool fits = farthest <= (std::int64_t{1} << 26) && largest_gram_ < (1 << 7);
    const bool is_short = extent(first_) <= kShort;
    if (fits) {
      return is_short ? search<std::int64_t, ShortKeyed>() : search<std::int64_t, Keyed>();
    }
    return is_short ? search<Int128, ShortKeyed>() : search<Int128, Keyed>();
  }

 private:
  std::int64_t extent(std::size_t axis) const { return box_.extents()[axis]; }

  void choose_axes() {
    std::array<std::size_t, 3> axes{0, 1, 2};
    std::stable_sort(axes.begin(), axes.end(),
                     [&](std::size_t a, std::size_t b) { return extent(a) > extent(b); });
    first_ = axes[0];
    second_ = axes[1];
  }

  /// No pair with a squared length up to kLongest is farther apart.
  bool is_near(Vector apart) const {
    return std::abs(apart.x) <= farthest_[0] && std::abs(apart.y) <= farthest_[1] &&
           std::abs(apart.z) <= farthest_[2];
  }

  Point at(std::size_t v) const { return drawing_.vertex(static_cast<Vertex>(v)); }

  /// The vertices along the first axis; a key is a place on it.
  template <class Item>
  std::vector<Item> ordered() const {
    std::vector<Item> order;
    order.reserve(drawing_.num_vertices());
    for (std::size_t v = 0; v < drawing_.num_vertices(); ++v) {
      const std::int64_t along = component(at(v), first_) - component(box_.low, first_);
      order.push_back({static_cast<decltype(Item::key)>(along), static_cast<std::uint32_t>(v)});
    }
    std::vector<Item> buffer;
    sort_by_key(order, buffer);
    return order;
  }

  template <class Integer, class Item>
  std::optional<VertexPair> search() {
    Integer smallest = std::numeric_limits<std::int64_t>::max();
    std::int64_t beside = 0;  // how near a closer pair is along the second axis
    const auto near = [&](std::size_t axis) {
      return reach(static_cast<double>(smallest), inverse_[axis]);
    };
    const auto look = [&](const Placed& a, const Placed& b) {
      const Vector apart = a.at - b.at;
      if (!is_near(apart)) return beside;
      const Integer d = squared_length<Integer>(lattice_, apart);
      if (d >= smallest) return beside;
      smallest = d;
      best_ = {a.v, b.v};
      return beside = near(second_);
    };
    const std::vector<Item> order = ordered<Item>();
    Placed before = placed(order[0].item);
    for (std::size_t i = 1; i < order.size(); ++i) {
      const Placed next = placed(order[i].item);
      look(before, next);
      before = next;
    }
    if (smallest > kLongest) return std::nullopt;
    if (smallest == 0) return best_;
    const bool complete =
        search_strips(order, static_cast<std::uint64_t>(near(first_)), beside, look);
    return complete ? std::optional(best_) : std::nullopt;
  }

  /// Looks at the pairs of a strip, and of it and the next, that are near along the second axis.
  /// @param look  returns how near that is from now on. @return false if they were too many.
  template <class Item, class Look>
  bool search_strips(const std::vector<Item>& order, std::uint64_t width, std::int64_t near,
                     Look&& look) {
    std::vector<Placed> strip, next;
    std::uint64_t number = 0, next_number = 0;
    std::size_t end = 0;  // of the next strip
    take_strip(order, width, end, next, next_number);
    while (!next.empty()) {
      strip.swap(next);
      number = next_number;
      take_strip(order, width, end, next, next_number);
      const bool has_next = !next.empty() && next_number == number + 1;
      std::size_t other = 0;
      for (std::size_t i = 0; i < strip.size(); ++i) {
        const std::int64_t here = component(strip[i].at, second_);
        if (!look_from(strip[i], strip, i + 1, near, look)) return false;
        if (!has_next) continue;
        while (other < next.size() && here - component(next[other].at, second_) > near) ++other;
        if (!look_from(strip[i], next, other, near, look)) return false;
      }
    }
    return true;
  }

  /// The strip that begins at `end`, along the second axis; empty if there is none.
  template <class Item>
  void take_strip(const std::vector<Item>& order, std::uint64_t width, std::size_t& end,
                  std::vector<Placed>& strip, std::uint64_t& number) const {
    strip.clear();
    if (end == order.size()) return;
    number = order[end].key / width;  // keys and widths stay below 2^62
    for (; end < order.size() && order[end].key < (number + 1) * width; ++end) {
      strip.push_back(placed(order[end].item));
    }
    std::sort(strip.begin(), strip.end(), [this](const Placed& a, const Placed& b) {
      const std::int64_t along_a = component(a.at, second_);
      const std::int64_t along_b = component(b.at, second_);
      return along_a != along_b ? along_a < along_b : a.v < b.v;
    });
  }

  template <class Look>
  bool look_from(const Placed& from, const std::vector<Placed>& others, std::size_t begin,
                 std::int64_t& near, Look&& look) {
    const std::int64_t here = component(from.at, second_);
    for (std::size_t j = begin;
         j < others.size() && component(others[j].at, second_) - here <= near; ++j) {
      if (left_-- == 0) return false;
      near = look(from, others[j]);
    }
    return true;
  }

  Placed placed(std::uint32_t v) const { return {at(v), v}; }

  const Drawing& drawing_;
  const Lattice& lattice_;
  std::array<double, 3> inverse_;
  std::array<std::int64_t, 3> farthest_{};  ///< two vertices as close as kLongest, along each axis
  std::int64_t largest_gram_ = 0;
  Box box_;
  std::size_t first_ = 0;
  std::size_t second_ = 1;
  std::uint64_t left_;  ///< pairs that may still be looked at
  VertexPair best_{};
};

}  // namespace

std::optional<VertexPair> closest_pair_by_strips(const Drawing& drawing) {
  return Strips(drawing).run();
}

}  // namespace ar3d::verify
