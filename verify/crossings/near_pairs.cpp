// Where space is halved, so that few segments are cut, and filters in double that drop pairs which
// surely do not meet; Lemmas V.9 and V.10 bound their errors. The filter of Lemma V.9 alone leaves
// all pairs of one plane to exact arithmetic.
#include "ar3d/verify/crossings/near_pairs.h"

#include <map>

namespace ar3d::verify {
namespace {

std::int64_t triple(Vector u, Vector v, Vector w) {
  const Vector n = plane_normal(u, v);
  return n.x * w.x + n.y * w.y + n.z * w.z;
}

// Lemma V.10 bounds the errors.
bool has_on_one_side(const SegmentInSpace& line, const SegmentInSpace& other) {
  const auto u = rounded(line.step);
  const auto from = rounded(other.from - line.from);
  const auto to = rounded(other.from + other.step - line.from);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const auto side = [&](const std::array<double, 3>& p) {
      const double one = u[i] * p[j];
      const double another = u[j] * p[i];
      const double miss = 0x1p-46 * (std::abs(one) + std::abs(another));
      return one - another > miss ? 1 : another - one > miss ? -1 : 0;
    };
    if (side(from) * side(to) > 0) return true;
  }
  return false;
}

}  // namespace

bool are_apart(const Box& a, const Box& b) {
  return a.high.x < b.low.x || b.high.x < a.low.x || a.high.y < b.low.y || b.high.y < a.low.y ||
         a.high.z < b.low.z || b.high.z < a.low.z;
}

bool surely_apart(const SegmentInSpace& a, const SegmentInSpace& b) {
  return has_on_one_side(a, b) || has_on_one_side(b, a);
}

namespace near_pairs {

Axes::Axes(const std::vector<Vector>& steps, const Box& box) {
  constexpr double kLongest = 16;  // component of a rough direction
  std::map<Vector, double> lengths;
  for (const Vector step : steps) {
    const auto d = rounded(step);
    const double size = std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
    if (size == 0) continue;
    const auto part = [&](std::size_t axis) { return std::llround(kLongest / size * d[axis]); };
    const Vector rough = primitive({part(0), part(1), part(2)});
    lengths[std::min(rough, -rough)] += size;
  }
  std::vector<std::pair<double, Vector>> longest;
  for (const auto& [d, length] : lengths) longest.emplace_back(length, d);
  std::sort(longest.rbegin(), longest.rend());
  for (const Vector unit : rows_) longest.emplace_back(0, unit);
  std::vector<Vector> axes;
  for (const auto& [length, d] : longest) {
    if (axes.size() == 1 && parallel(axes[0], d)) continue;
    if (axes.size() < 3 && !(axes.size() == 2 && triple(axes[0], axes[1], d) == 0))
      axes.push_back(d);
  }
  // Rows have components up to 2 * 16^2.
  if (largest_coordinate(box) > kMaxCoordinate / (std::int64_t{6} * 16 * 16)) return;
  for (std::size_t i = 0; i < 3; ++i) rows_[i] = plane_normal(axes[(i + 1) % 3], axes[(i + 2) % 3]);
}

Shifts shifts_for(const Box& box) {
  constexpr int kFinest = 20;
  constexpr int kBits = 61;  // of every coordinate in these units
  Shifts shifts{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto size = [axis](Point p) {
      return static_cast<std::uint64_t>(std::abs(component(p, axis)));
    };
    const int bits = static_cast<int>(std::bit_width(std::max(size(box.low), size(box.high))));
    shifts[axis] = static_cast<unsigned>(std::clamp(kBits - bits, 0, kFinest));
  }
  return shifts;
}

Cut best_cut(std::array<std::vector<Reached>, 3>& sample) {
  Cut best;
  std::ptrdiff_t fewest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    auto& list = sample[axis];
    const auto median = list.begin() + static_cast<std::ptrdiff_t>(list.size() / 2);
    std::nth_element(list.begin(), median, list.end(),
                     [](const Reached& a, const Reached& b) { return a[1] < b[1]; });
    const double place = std::floor((*median)[1]);
    const auto cuts = std::count_if(list.begin(), list.end(), [place](const Reached& piece) {
      return piece[0] <= place && place <= piece[2];
    });
    if (axis > 0 && cuts >= fewest) continue;
    fewest = cuts;
    best = {axis, static_cast<std::int64_t>(place)};
  }
  return best;
}

}  // namespace near_pairs
}  // namespace ar3d::verify
