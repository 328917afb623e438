// The closest pair by two sorts instead of a hash table of cubes. The vertices are sorted along the
// widest axis; the smallest distance of two that are consecutive there bounds the smallest of all.
// So the two vertices searched for are in one strip of that width or in two consecutive ones, and
// within each strip, sorted along the second widest axis, not far from each other. Memory is read
// in order, but for one gathering of the vertices after each sort.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <vector>

#include "ar3d/verify/closest_pair.h"
#include "ar3d/verify/exact.h"
#include "ar3d/verify/order.h"
#include "ar3d/verify/squared_length.h"

namespace ar3d::verify {
namespace {

/// Nine terms of differences below 2^42 and Gram entries below 2^31 stay below 2^119.
constexpr std::int64_t kLargest = std::int64_t{1} << 41;
/// Squared lengths up to here are exact in a double too: every closest pair has the same length.
constexpr std::int64_t kLongest = std::int64_t{1} << 40;
constexpr std::uint64_t kPairsPerVertex = 60;

struct Placed {
  Point at;
  Vertex v;
};

class Strips {
 public:
  explicit Strips(const Drawing& drawing)
      : lattice_(drawing.lattice()), inverse_(inverse_diagonal(lattice_)) {
    for (const auto& row : lattice_.gram) {
      for (const std::int32_t entry : row)
        largest_gram_ = std::max(largest_gram_, magnitude(entry));
    }
    GrowingBox box;
    vertices_.reserve(drawing.num_vertices());
    for (std::size_t i = 0; i < drawing.num_vertices(); ++i) {
      const auto v = static_cast<Vertex>(i);
      vertices_.push_back({drawing.vertex(v), v});
      box.add(vertices_.back().at);
    }
    box_ = box.box();
  }

  std::optional<VertexPair> run() {
    for (const Point corner : {box_.low, box_.high}) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (std::abs(component(corner, i)) >= kLargest) return std::nullopt;
      }
    }
    choose_axes();
    // Nine terms of squared differences up to 2^52 and entries up to 2^7 stay below 2^63.
    const std::int64_t widest = extent(first_);
    return widest < (std::int64_t{1} << 26) && largest_gram_ < (1 << 7) ? search<std::int64_t>()
                                                                        : search<Int128>();
  }

 private:
  static std::int64_t magnitude(std::int32_t entry) { return std::abs(std::int64_t{entry}); }
  std::int64_t extent(std::size_t axis) const { return box_.extents()[axis]; }

  void choose_axes() {
    std::array<std::size_t, 3> axes{0, 1, 2};
    std::stable_sort(axes.begin(), axes.end(),
                     [&](std::size_t a, std::size_t b) { return extent(a) > extent(b); });
    first_ = axes[0];
    second_ = axes[1];
  }

  /// Sorts the vertices stably by a key.
  template <class Key>
  void sort_vertices(Key&& key) {
    order_.clear();
    for (std::uint32_t i = 0; i < vertices_.size(); ++i) order_.push_back({key(vertices_[i]), i});
    sort_by_key(order_, buffer_);
  }
  void gather() {
    std::vector<Placed> sorted;
    sorted.reserve(vertices_.size());
    for (const Keyed& item : order_) sorted.push_back(vertices_[item.item]);
    vertices_.swap(sorted);
  }
  std::uint64_t along(const Placed& placed, std::size_t axis) const {
    return static_cast<std::uint64_t>(component(placed.at, axis) - component(box_.low, axis));
  }

  template <class Integer>
  std::optional<VertexPair> search() {
    Integer smallest = std::numeric_limits<std::int64_t>::max();
    const auto look = [&](const Placed& a, const Placed& b) {
      const Integer d = squared_length<Integer>(lattice_, a.at - b.at);
      if (d >= smallest) return;
      smallest = d;
      best_ = {a.v, b.v};
    };
    sort_vertices([&](const Placed& p) { return along(p, first_); });
    gather();
    for (std::size_t i = 1; i < vertices_.size(); ++i) look(vertices_[i - 1], vertices_[i]);
    if (smallest > kLongest) return std::nullopt;
    if (smallest == 0) return best_;
    into_strips(static_cast<std::uint64_t>(reach(static_cast<double>(smallest), inverse_[first_])));
    const bool complete = search_strips(
        [&](const Placed& a, const Placed& b) {
          look(a, b);
          return reach(static_cast<double>(smallest), inverse_[second_]);
        },
        reach(static_cast<double>(smallest), inverse_[second_]));
    return complete ? std::optional(best_) : std::nullopt;
  }

  /// Afterwards the vertices are sorted by strip, and within a strip along the second axis.
  void into_strips(std::uint64_t width) {
    sort_vertices([&](const Placed& p) { return along(p, second_); });
    gather();
    sort_vertices([&](const Placed& p) { return along(p, first_) / width; });
    gather();
    begins_.clear();
    strips_.clear();
    for (std::size_t i = 0; i < order_.size(); ++i) {
      if (i > 0 && order_[i].key == order_[i - 1].key) continue;
      begins_.push_back(i);
      strips_.push_back(order_[i].key);
    }
    begins_.push_back(order_.size());
  }

  /// Looks at the pairs of a strip, and of it and the next, that are near along the second axis.
  /// @param look  returns how near that is from now on. @return false if they were too many.
  template <class Look>
  bool search_strips(Look&& look, std::int64_t near) {
    std::uint64_t left = kPairsPerVertex * vertices_.size();
    for (std::size_t s = 0; s + 1 < begins_.size(); ++s) {
      const bool has_next = s + 2 < begins_.size() && strips_[s + 1] == strips_[s] + 1;
      std::size_t other = begins_[s + 1];
      for (std::size_t i = begins_[s]; i < begins_[s + 1]; ++i) {
        const std::int64_t at = component(vertices_[i].at, second_);
        const auto look_from = [&](std::size_t j, std::size_t end) {
          for (; j < end && component(vertices_[j].at, second_) - at <= near; ++j) {
            if (left-- == 0) return false;
            near = look(vertices_[i], vertices_[j]);
          }
          return true;
        };
        if (!look_from(i + 1, begins_[s + 1])) return false;
        if (!has_next) continue;
        while (other < begins_[s + 2] && at - component(vertices_[other].at, second_) > near) {
          ++other;
        }
        if (!look_from(other, begins_[s + 2])) return false;
      }
    }
    return true;
  }

  const Lattice& lattice_;
  std::array<double, 3> inverse_;
  std::int64_t largest_gram_ = 0;
  Box box_;
  std::size_t first_ = 0;
  std::size_t second_ = 1;
  std::vector<Placed> vertices_;
  std::vector<Keyed> order_;
  std::vector<Keyed> buffer_;
  std::vector<std::size_t> begins_;    ///< of the strips that are not empty, and the end
  std::vector<std::uint64_t> strips_;  ///< their numbers
  VertexPair best_{};
};

}  // namespace

std::optional<VertexPair> closest_pair_by_strips(const Drawing& drawing) {
  return Strips(drawing).run();
}

}  // namespace ar3d::verify
