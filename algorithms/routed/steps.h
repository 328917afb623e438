#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace ar3d::routed {

/// A point, or a difference of points, of a box with sides below 2^15.
struct Spot {
  int x = 0;
  int y = 0;
  int z = 0;
  friend bool operator==(const Spot&, const Spot&) = default;
};

inline Spot operator+(Spot a, Spot b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Spot operator-(Spot a, Spot b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Spot operator*(int k, Spot a) { return {k * a.x, k * a.y, k * a.z}; }
inline int dot(Spot a, Spot b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// A box of points: from low to high, both included.
struct Limits {
  Spot low;
  Spot high;
  Spot sides() const { return high - low + Spot{1, 1, 1}; }
  int longest() const { return std::max({sides().x, sides().y, sides().z}); }
  bool contain(Spot p) const {
    return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y && p.z >= low.z &&
           p.z <= high.z;
  }
};

inline constexpr int kMostDirections = 12;
inline constexpr int kMostBends = 5;
inline constexpr int kMostSegments = kMostBends + 1;

/// A set of directions, bit d for direction d.
using Directions = std::uint16_t;
inline bool has(Directions set, int d) { return (set >> d & 1) != 0; }
inline Directions without(Directions set, int d) {
  return static_cast<Directions>(set & ~(1u << d));
}

/// The points of one class and the unit steps between them. Different steps meet in points of the
/// class only (Lemma R.1), so routes that share no point do not cross.
class PointClass {
 public:
  /// Points whose coordinates are all even or all odd; the 8 body diagonals, 109.47 degrees.
  static const PointClass& body();
  /// Points whose coordinates have an even sum; the 12 face diagonals, 120 degrees.
  static const PointClass& face();

  bool is_body() const { return is_body_; }
  int num_directions() const { return static_cast<int>(steps_.size()); }
  Spot step(int d) const { return steps_[static_cast<std::size_t>(d)]; }
  static int opposite(int d) { return d ^ 1; }
  /// Returns the directions that a segment in direction d may turn to.
  Directions turns(int d) const { return turns_[static_cast<std::size_t>(d)]; }
  /// Returns the largest sets of directions in which edges may leave one vertex.
  const std::vector<Directions>& frames() const { return frames_; }
  bool contains(Spot p) const {
    return is_body_ ? ((p.x ^ p.y) & 1) == 0 && ((p.x ^ p.z) & 1) == 0
                    : ((p.x + p.y + p.z) & 1) == 0;
  }

 private:
  explicit PointClass(bool is_body);
  bool is_body_;
  std::vector<Spot> steps_;
  std::array<Directions, kMostDirections> turns_{};
  std::vector<Directions> frames_;
};

/// An edge's way from its end u to its end v: so many unit steps in each direction.
struct Route {
  std::uint8_t segments = 0;  ///< 0: no route
  std::array<std::uint8_t, kMostSegments> direction{};
  std::array<std::int16_t, kMostSegments> length{};
  explicit operator bool() const { return segments > 0; }
  /// Goes on in a direction for so many steps.
  void add(int d, int steps) {
    direction[segments] = static_cast<std::uint8_t>(d);
    length[segments++] = static_cast<std::int16_t>(steps);
  }
  /// Returns the same way from v to u.
  Route reversed() const {
    Route result;
    for (std::size_t s = segments; s-- > 0;) result.add(direction[s] ^ 1, length[s]);
    return result;
  }
};

/// Calls visit(p) for the bends of a route from `from` on, and for its end.
template <class Visit>
void for_each_corner(const PointClass& points, Spot from, const Route& route, const Visit& visit) {
  for (std::size_t s = 0; s < route.segments; ++s) {
    from = from + route.length[s] * points.step(route.direction[s]);
    visit(from);
  }
}

}  // namespace ar3d::routed
