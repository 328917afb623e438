// Step E.4: who meets anything older. Slabs of heights are gone through one after the other; what
// reaches into one goes to the cells of (x, y) that it passes there, and only what shares a cell is
// compared: first modulo 2^16, several pairs at a time, then exactly, in up to 256 bits. So the
// answer is that of exact arithmetic alone. Cost: near n^1.5.
#include "ar3d/algorithms/two_bend_109/drawn_segments.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstring>
#include <span>

#include "ar3d/model/drawing.h"

namespace ar3d::two_bend_109 {
namespace {

// Slabs, columns and rows per square root of the number of middles: measured to be fast for random
// 4-regular graphs of 10^3 to 10^6 vertices and for tori.
constexpr double kSlabs = 0.3, kColumns = 0.2, kRows = 0.35;

__extension__ using Int128 = __int128;
using Int256 = boost::multiprecision::int256_t;

using Wide = std::array<Int128, 3>;

/// Components below 2^62: each product is below 2^124.
Wide cross(Vector u, Vector v) {
  const auto product = [](std::int64_t a, std::int64_t b) { return Int128{a} * b; };
  return {product(u.y, v.z) - product(u.z, v.y), product(u.z, v.x) - product(u.x, v.z),
          product(u.x, v.y) - product(u.y, v.x)};
}

bool is_zero(const Wide& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }

/// Most vectors are seen not to be orthogonal modulo 2^64.
bool is_orthogonal(const Wide& n, Vector w) {
  const auto product = [](Int128 a, std::int64_t b) {
    return static_cast<std::uint64_t>(a) * static_cast<std::uint64_t>(b);
  };
  if (product(n[0], w.x) + product(n[1], w.y) + product(n[2], w.z) != 0) return false;
  return Int256(n[0]) * w.x + Int256(n[1]) * w.y + Int256(n[2]) * w.z == 0;
}

bool overlap(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
  return std::max(std::min(a, b), std::min(c, d)) <= std::min(std::max(a, b), std::max(c, d));
}

/// 0 <= part / whole <= 1.
bool is_fraction(Int128 part, Int128 whole) {
  if (whole < 0) {
    part = -part;
    whole = -whole;
  }
  return 0 <= part && part <= whole;
}

/// The line through a segment modulo 2^16: direction u and moment p x u. Two lines meet only if
/// u1 m2 + u2 m1 = 0, so also modulo 2^16.
using LineModulo = std::array<std::uint16_t, 6>;

LineModulo line_of(const LatticeSegment& segment) {
  const auto low = [](std::int64_t a) { return static_cast<std::uint32_t>(a); };
  const std::uint32_t x = low(segment.from.x), y = low(segment.from.y), z = low(segment.from.z);
  const std::uint32_t u = low(segment.to.x) - x, v = low(segment.to.y) - y,
                      w = low(segment.to.z) - z;
  const auto cut = [](std::uint32_t a) { return static_cast<std::uint16_t>(a); };
  return {cut(u), cut(v), cut(w), cut(y * w - z * v), cut(z * u - x * w), cut(x * v - y * u)};
}

using LineComponents = std::array<const std::uint16_t*, 6>;

/// Finds which of `count` lines, given by component, may be coplanar to this one. Without branches,
/// so that the compiler tests several at a time.
__attribute__((always_inline)) inline void find_coplanar(const LineModulo& line,
                                                         const LineComponents& lines,
                                                         std::size_t count,
                                                         std::uint16_t* __restrict is_coplanar) {
  const auto [a, b, c, d, e, f] = lines;
  const std::uint32_t u = line[0], v = line[1], w = line[2], l = line[3], m = line[4], n = line[5];
  for (std::size_t i = 0; i < count; ++i) {
    const auto sum =
        static_cast<std::uint16_t>(u * d[i] + v * e[i] + w * f[i] + l * a[i] + m * b[i] + n * c[i]);
    is_coplanar[i] = sum == 0 ? 1 : 0;
  }
}

#if defined(__x86_64__)
const bool kHasAvx2 = __builtin_cpu_supports("avx2") != 0;
__attribute__((target("avx2"))) void find_coplanar_avx2(const LineModulo& line,
                                                        const LineComponents& lines,
                                                        std::size_t count,
                                                        std::uint16_t* __restrict is_coplanar) {
  find_coplanar(line, lines, count, is_coplanar);
}
#else
constexpr bool kHasAvx2 = false;
constexpr auto& find_coplanar_avx2 = find_coplanar;
#endif

/// Two segments that meet do so in a slab and a cell that both are entered in: heights are compared
/// exactly, and what is entered is widened by far more than the rounding errors.
class SlabSweep {
 public:
  SlabSweep(const std::vector<DrawnSegment>& middles, const std::vector<DrawnSegment>& stubs)
      : middles_(middles), stubs_(stubs) {}

  /// Compares these with all others.
  void compare_few(const std::vector<std::uint32_t>& few) {
    std::vector<bool> is_few(middles_.size() + stubs_.size());
    for (const std::uint32_t i : few) is_few[i] = true;
    for (const std::uint32_t i : few) entries_.push_back({line_of(segment(i).at), i, 0});
    for (std::uint32_t i = 0; i < is_few.size(); ++i) {
      if (!is_few[i]) entries_.push_back({line_of(segment(i).at), i, 0});
    }
    compare(entries_, few.size());
  }

  /// Compares all with all, slab by slab.
  void compare_all() {
    const double root = std::sqrt(static_cast<double>(middles_.size()));
    const auto share = [&](double of) { return static_cast<std::uint32_t>(of * root) + 1; };
    columns_ = share(kColumns);
    for (std::uint32_t i = 0; i < middles_.size() + stubs_.size(); ++i) {
      box_.add(segment(i).at.from);
      box_.add(segment(i).at.to);
    }
    const Vector size = box_.high() - box_.low();
    // Narrower rows gain nothing: stubs pass all of them.
    rows_ = static_cast<std::uint32_t>(std::min<std::int64_t>(share(kRows), size.y + 1));
    per_x_ = columns_ / static_cast<double>(size.x + 1);
    per_y_ = rows_ / static_cast<double>(size.y + 1);
    divide(share(kSlabs));
    std::array<std::vector<ReachingSegment>, 2> active;  // middles, stubs
    for (std::size_t slab = 0; slab < bottom_.size(); ++slab) {
      for (const std::uint32_t i : begins_[slab]) {
        active[i < middles_.size() ? 0 : 1].push_back(started(i));
      }
      const bool is_last = slab + 1 == bottom_.size();
      const std::int64_t top = is_last ? box_.high().z : bottom_[slab + 1];
      entries_.clear();
      end_of_cell_.assign(std::size_t{rows_} * columns_ + 2, 0);
      for (auto& some : active) {
        for (const ReachingSegment& one : some) enter(one, bottom_[slab], top);
        std::erase_if(some, [&](const ReachingSegment& one) { return one.high < top; });
      }
      compare_entries();
    }
  }

  std::vector<std::uint32_t> found() {
    std::sort(found_.begin(), found_.end());
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
    return std::move(found_);
  }

 private:
  /// A segment that reaches into the slab; lengths in x and y are in cells.
  struct ReachingSegment {
    double x, y, run_x, run_y;
    double per_rise;  ///< one over its height; any number if that is 0
    std::int64_t low, high;
    LineModulo line;
    std::uint32_t index;
  };
  struct CellEntry {
    LineModulo line;
    std::uint32_t index;
    std::uint32_t cell;
  };

  const DrawnSegment& segment(std::uint32_t i) const {
    return i < middles_.size() ? middles_[i] : stubs_[i - middles_.size()];
  }

  /// Into slabs in which about equally many segments begin, as stubs come upwards.
  void divide(std::size_t slabs) {
    bottom_ = {box_.low().z};
    for (std::size_t i = 1; i < slabs; ++i) {
      const std::int64_t z = stubs_[stubs_.size() * i / slabs].at.from.z;
      if (z > bottom_.back()) bottom_.push_back(z);
    }
    begins_.resize(bottom_.size());
    for (std::uint32_t i = 0; i < middles_.size() + stubs_.size(); ++i) {
      const auto above = std::upper_bound(bottom_.begin(), bottom_.end(), segment(i).at.from.z);
      begins_[static_cast<std::size_t>(above - bottom_.begin()) - 1].push_back(i);
    }
  }

  ReachingSegment started(std::uint32_t index) const {
    const auto [p, q] = segment(index).at;
    const Vector from = p - box_.low(), run = q - p;
    return {static_cast<double>(from.x) * per_x_,
            static_cast<double>(from.y) * per_y_,
            static_cast<double>(run.x) * per_x_,
            static_cast<double>(run.y) * per_y_,
            1 / static_cast<double>(std::max<std::int64_t>(run.z, 1)),
            p.z,
            q.z,
            line_of({p, q}),
            index};
  }

  void enter(const ReachingSegment& one, std::int64_t bottom, std::int64_t top) {
    const auto part_below = [&](std::int64_t z) {
      return static_cast<double>(z - one.low) * one.per_rise;
    };
    const double begin = bottom <= one.low ? 0 : part_below(bottom);
    const double end = top >= one.high ? 1 : part_below(top);
    double x0 = one.x + begin * one.run_x, y0 = one.y + begin * one.run_y;
    double x1 = one.x + end * one.run_x, y1 = one.y + end * one.run_y;
    if (y0 > y1) {
      std::swap(x0, x1);
      std::swap(y0, y1);
    }
    const std::uint32_t first_row = cell(y0 - kMargin, rows_), last_row = cell(y1 + kMargin, rows_);
    const double left = std::min(x0, x1), right = std::max(x0, x1);
    if (first_row == last_row || y1 - y0 < kMargin) {  // flat: on the line between two rows
      for (std::uint32_t row = first_row; row <= last_row; ++row) enter_row(one, row, left, right);
      return;
    }
    const double lean = (x1 - x0) / (y1 - y0);
    for (std::uint32_t row = first_row; row <= last_row; ++row) {
      // Where it enters the row and leaves it.
      double from = x0 + (row - kMargin - y0) * lean, to = x0 + (row + 1 + kMargin - y0) * lean;
      from = row == first_row ? x0 : std::clamp(from, left, right);
      to = row == last_row ? x1 : std::clamp(to, left, right);
      enter_row(one, row, std::min(from, to), std::max(from, to));
    }
  }

  static std::uint32_t cell(double a, std::uint32_t count) {
    return std::min(static_cast<std::uint32_t>(static_cast<std::int32_t>(std::max(a, 0.0))),
                    count - 1);
  }

  void enter_row(const ReachingSegment& one, std::uint32_t row, double from, double to) {
    const std::uint32_t first = cell(from - kMargin, columns_), last = cell(to + kMargin, columns_);
    for (std::uint32_t at = row * columns_ + first; at <= row * columns_ + last; ++at) {
      entries_.push_back({one.line, one.index, at});
      ++end_of_cell_[at + 2];
    }
  }

  void compare_entries() {
    for (std::size_t i = 2; i < end_of_cell_.size(); ++i) end_of_cell_[i] += end_of_cell_[i - 1];
    sorted_.resize(entries_.size());
    for (const CellEntry& entry : entries_) sorted_[end_of_cell_[entry.cell + 1]++] = entry;
    for (std::size_t cell = 0; cell + 2 < end_of_cell_.size(); ++cell) {
      const std::size_t begin = end_of_cell_[cell], end = end_of_cell_[cell + 1];
      std::size_t middles = 0;
      while (begin + middles < end && sorted_[begin + middles].index < middles_.size()) ++middles;
      compare({sorted_.data() + begin, sorted_.data() + end}, middles);
    }
  }

  /// Each of the first few with all behind it.
  void compare(std::span<const CellEntry> cell, std::size_t few) {
    if (cell.size() < 2 || few == 0) return;
    for (std::size_t k = 0; k < 6; ++k) {
      lines_[k].resize(std::max(lines_[k].size(), cell.size() + kLanes));
      for (std::size_t i = 0; i < cell.size(); ++i) lines_[k][i] = cell[i].line[k];
      std::fill_n(&lines_[k][cell.size()], kLanes, std::uint16_t{0});
    }
    for (std::size_t i = 0; i < few; ++i) {
      for (std::size_t begin = i + 1; begin < cell.size(); begin += kBlock) {
        const std::size_t count = std::min(kBlock, cell.size() - begin);
        const std::size_t padded = (count + kLanes - 1) / kLanes * kLanes;
        const LineComponents lines = {&lines_[0][begin], &lines_[1][begin], &lines_[2][begin],
                                      &lines_[3][begin], &lines_[4][begin], &lines_[5][begin]};
        std::uint16_t* const found = is_coplanar_.data();
        kHasAvx2 ? find_coplanar_avx2(cell[i].line, lines, padded, found)
                 : find_coplanar(cell[i].line, lines, padded, found);
        const auto next = [&](const std::uint16_t* from) {  // a byte of each of them is 1
          return static_cast<const std::uint16_t*>(
              std::memchr(from, 1, 2 * static_cast<std::size_t>(found + count - from)));
        };
        for (const std::uint16_t* at = next(found); at != nullptr; at = next(at + 1)) {
          compare(cell[i].index, cell[begin + static_cast<std::size_t>(at - found)].index);
        }
      }
    }
  }

  void compare(std::uint32_t i, std::uint32_t j) {
    if (std::min(i, j) >= middles_.size()) return;
    const DrawnSegment& a = segment(std::min(i, j));
    if (middles_.size() + a.stub == std::max(i, j)) return;
    const DrawnSegment& b = segment(std::max(i, j));
    if (a.owner != b.owner && meet(a.at, b.at)) found_.push_back(std::max(a.owner, b.owner));
  }

  static constexpr std::size_t kLanes = 16, kBlock = 256;
  static constexpr double kMargin = 0x1p-20;  // of a cell
  const std::vector<DrawnSegment>& middles_;
  const std::vector<DrawnSegment>& stubs_;  ///< by index behind the middles
  std::uint32_t columns_, rows_;
  GrowingBox box_;
  double per_x_, per_y_;                            ///< cells in a unit of length
  std::vector<std::int64_t> bottom_;                ///< of each slab
  std::vector<std::vector<std::uint32_t>> begins_;  ///< what begins in each slab
  std::vector<CellEntry> entries_, sorted_;         ///< sorted by cell
  std::vector<std::uint32_t> end_of_cell_;
  std::array<std::vector<std::uint16_t>, 6> lines_;  ///< of one cell, by component
  std::array<std::uint16_t, kBlock> is_coplanar_{};
  std::vector<std::uint32_t> found_;
};

}  // namespace

bool are_parallel(Vector u, Vector v) { return is_zero(cross(u, v)); }

bool meet(const LatticeSegment& a, const LatticeSegment& b) {
  if (!overlap(a.from.x, a.to.x, b.from.x, b.to.x) ||
      !overlap(a.from.y, a.to.y, b.from.y, b.to.y) ||
      !overlap(a.from.z, a.to.z, b.from.z, b.to.z)) {
    return false;
  }
  const Vector u = a.to - a.from;
  const Vector v = b.to - b.from;
  const Vector w = b.from - a.from;
  const Wide normal = cross(u, v);
  // On one line, boxes that overlap are segments that overlap.
  if (is_zero(normal)) return is_zero(cross(u, w));
  if (!is_orthogonal(normal, w)) return false;
  // a.from + s u = b.from + t v with s = (w x v) / (u x v), t = (w x u) / (u x v).
  const std::size_t k = normal[0] != 0 ? 0 : normal[1] != 0 ? 1 : 2;
  return is_fraction(cross(w, v)[k], normal[k]) && is_fraction(cross(w, u)[k], normal[k]);
}

std::vector<std::uint32_t> owners_that_meet(const DrawnSegments& drawn,
                                            const DrawnSegments& before) {
  std::vector<std::uint32_t> moved;
  const auto add_moved = [&](const auto& now, const auto& then, std::size_t first) {
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (i < then.size() && now[i].at == then[i].at) continue;
      moved.push_back(static_cast<std::uint32_t>(first + i));
    }
  };
  add_moved(drawn.middles, before.middles, 0);
  add_moved(drawn.stubs, before.stubs, drawn.middles.size());
  SlabSweep sweep(drawn.middles, drawn.stubs);
  if (moved.size() * moved.size() < drawn.middles.size()) {
    sweep.compare_few(moved);
  } else if (!drawn.middles.empty()) {
    sweep.compare_all();
  }
  return sweep.found();
}

}  // namespace ar3d::two_bend_109
