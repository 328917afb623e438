// Step E.4: who meets anything older. Slabs of heights are gone through one after the other; what
// reaches into one is cut at rows of y, and each piece is compared with those of its row that begin
// before it ends along x: first modulo 2^16, several pairs at a time, then exactly, in up to 256
// bits. So the answer is that of exact arithmetic alone. Cost: near n^1.5. Dropped: rows of equal
// width, since most middles pass near y = 0, and slabs for few middles, all of which are compared.
#include "ar3d/algorithms/two_bend_109/drawn_segments.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "ar3d/model/drawing.h"

namespace ar3d::two_bend_109 {
namespace {

// Slabs and rows per square root of the number of middles: measured to be fast, as are the columns,
// for random 4-regular graphs of 10^3 to 10^6 vertices and for tori.
constexpr double kSlabs = 0.07, kRows = 0.045;

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

/// So many lines are tested at a time.
using Lanes __attribute__((vector_size(32))) = std::uint16_t;
constexpr std::size_t kLanes = sizeof(Lanes) / sizeof(std::uint16_t);

/// A vector of each component of kLanes lines.
using LineBlock = std::array<Lanes, 6>;

/// Adds those of the lines from begin to end that may be coplanar to this one. Goes through whole
/// blocks, two at a time, and so reads up to one block behind that of the last line.
__attribute__((always_inline)) inline void add_coplanar(const LineModulo& line,
                                                        const std::vector<LineBlock>& lines,
                                                        std::size_t begin, std::size_t end,
                                                        std::vector<std::size_t>& found) {
  std::array<Lanes, 6> factors;
  for (std::size_t k = 0; k < 6; ++k) factors[k] = Lanes{} + line[(k + 3) % 6];
  constexpr Lanes kNumbers = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  Lanes is_behind = static_cast<Lanes>(kNumbers >= static_cast<std::uint16_t>(begin % kLanes));
  for (std::size_t i = begin / kLanes; i * kLanes < end; i += 2) {
    std::array<Lanes, 2> is_zero{};
    for (std::size_t b = 0; b < 2; ++b) {
      Lanes sum{};
      for (std::size_t k = 0; k < 6; ++k) sum += lines[i + b][k] * factors[k];
      is_zero[b] = static_cast<Lanes>(sum == 0);
    }
    is_zero[0] &= is_behind;
    is_behind = ~Lanes{};
    const Lanes any = is_zero[0] | is_zero[1];
    std::array<std::uint64_t, sizeof(is_zero) / sizeof(std::uint64_t)> words;
    std::memcpy(words.data(), &any, sizeof(any));
    if ((words[0] | words[1] | words[2] | words[3]) == 0) continue;
    std::memcpy(words.data(), &is_zero, sizeof(is_zero));
    for (std::size_t k = 0; k < words.size(); ++k) {
      for (std::size_t at = i * kLanes + 4 * k; words[k] != 0; words[k] >>= 16, ++at) {
        if ((words[k] & 1) != 0 && at < end) found.push_back(at);
      }
    }
  }
}

#if defined(__x86_64__)
const bool kHasAvx2 = __builtin_cpu_supports("avx2") != 0;
__attribute__((target("avx2"))) void add_coplanar_avx2(const LineModulo& line,
                                                       const std::vector<LineBlock>& lines,
                                                       std::size_t begin, std::size_t end,
                                                       std::vector<std::size_t>& found) {
  add_coplanar(line, lines, begin, end, found);
}
#else
constexpr bool kHasAvx2 = false;
constexpr auto& add_coplanar_avx2 = add_coplanar;
#endif

/// Two segments that meet do so in a slab and a row that both are entered in, in a column that both
/// pass: heights are compared exactly, all else is widened by far more than the rounding errors.
class SlabSweep {
 public:
  SlabSweep(const LongVector<DrawnSegment>& middles, const LongVector<DrawnSegment>& stubs)
      : middles_(middles), stubs_(stubs) {}

  /// Compares these with all others, or all with all if none is named.
  void compare_few(const std::vector<std::uint32_t>& few) {
    const auto all = static_cast<std::uint32_t>(middles_.size() + stubs_.size());
    sorted_.reserve(few.size() + all);
    const auto add = [&](std::uint32_t i) { sorted_.push_back({line_of(segment(i).at), i, 0, 0}); };
    for (const std::uint32_t i : few) add(i);
    for (std::uint32_t i = 0; i < all; ++i) add(i);
    separate_components();
    const std::size_t count = few.empty() ? middles_.size() : few.size();
    for (std::size_t i = 0; i < count; ++i) {
      compare_run(i, few.empty() ? i + 1 : count, sorted_.size());
    }
    compare_coplanar();
  }

  /// Compares all with all, slab by slab.
  void compare_all() {
    const double root = std::sqrt(static_cast<double>(middles_.size()));
    const auto share = [&](double of) { return static_cast<std::uint32_t>(of * root) + 1; };
    for (std::uint32_t i = 0; i < middles_.size() + stubs_.size(); ++i) {
      box_.add(segment(i).at.from);
      box_.add(segment(i).at.to);
    }
    columns_ = static_cast<std::uint32_t>(16 * std::pow(middles_.size(), 0.4)) + 1;
    const Vector size = box_.high() - box_.low();
    per_x_ = columns_ / static_cast<double>(size.x + 1);
    per_y_ = 1024 / static_cast<double>(size.y + 1);
    divide_rows(std::max(share(kRows), 3u) - 2);
    divide_slabs(std::min(share(3 * kSlabs), share(kSlabs) + 8));
    std::vector<ReachingSegment> active;  // middles
    std::vector<std::uint32_t> stubs;
    for (std::size_t slab = 0; slab < bottom_.size(); ++slab) {
      const bool is_last = slab + 1 == bottom_.size();
      const std::int64_t top = is_last ? box_.high().z + 1 : bottom_[slab + 1];
      entries_.clear();
      end_of_cell_.assign(std::size_t{rows_} * columns_ + 2, 0);
      for (const std::uint32_t i : begins_[slab]) {
        i < middles_.size() ? active.push_back(started(i)) : stubs.push_back(i);
      }
      for (ReachingSegment& one : active) enter(one, top);
      for (const std::uint32_t i : stubs) enter_stub(i);
      std::erase_if(active, [&](const ReachingSegment& one) { return one.high < top; });
      std::erase_if(stubs, [&](std::uint32_t i) { return segment(i).at.to.z < top; });
      compare_entries();
    }
  }

  std::vector<std::uint32_t> found() {
    std::sort(found_.begin(), found_.end());
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
    return std::move(found_);
  }

 private:
  /// What reaches into the slab or those above of a segment; lengths in x are in columns.
  struct ReachingSegment {
    double x, y;            ///< where it reaches `low`
    double lean_x, lean_y;  ///< per height
    double lean;            ///< in x per y
    std::int64_t low, high;
    LineModulo line;
    std::uint32_t index;
    std::uint32_t row;  ///< near the row that it is in
  };
  /// What of a segment is in a row and a slab.
  struct CellEntry {
    LineModulo line;
    std::uint32_t index;
    std::uint32_t first, last;  ///< cells
  };

  const DrawnSegment& segment(std::uint32_t i) const {
    return i < middles_.size() ? middles_[i] : stubs_[i - middles_.size()];
  }

  /// Into slabs in which about equally many segments begin, as stubs come upwards.
  void divide_slabs(std::size_t slabs) {
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

  /// Into rows through which about equally many middles pass, most of them near y = 0, and which
  /// are not very wide elsewhere.
  void divide_rows(std::size_t rows) {
    const std::size_t step = middles_.size() / (16 * rows) + 1;
    std::vector<double> passed;
    for (std::size_t i = 0; i < middles_.size(); i += step) {
      const auto& [from, to] = middles_[i].at;
      const double part = std::fmod(static_cast<double>(i) * 0.6180339887498949, 1.0);
      passed.push_back(height(from) + part * (height(to) - height(from)));
      passed.push_back(1024 * part);
    }
    std::sort(passed.begin(), passed.end());
    row_begin_ = {-1};
    for (std::size_t i = 1; i < rows; ++i) {
      const double y = passed[passed.size() * i / rows];
      if (y > row_begin_.back() + 1 / 1024.0) row_begin_.push_back(y);
    }
    rows_ = static_cast<std::uint32_t>(row_begin_.size());
    row_begin_.push_back(std::numeric_limits<double>::infinity());
  }

  double column(Point p) const { return static_cast<double>(p.x - box_.low().x) * per_x_; }
  double height(Point p) const { return static_cast<double>(p.y - box_.low().y) * per_y_; }

  ReachingSegment started(std::uint32_t index) const {
    const auto [p, q] = segment(index).at;
    const std::int64_t rise = std::max<std::int64_t>(q.z - p.z, 1);
    const double x = column(p), y = height(p), dx = column(q) - x, dy = height(q) - y;
    const auto above = std::upper_bound(row_begin_.begin(), row_begin_.end(), y);
    return {x,
            y,
            dx / static_cast<double>(rise),
            dy / static_cast<double>(rise),
            dy == 0 ? 0 : dx / dy,
            p.z,
            p.z + rise,
            line_of({p, q}),
            index,
            static_cast<std::uint32_t>(above - row_begin_.begin()) - 1};
  }

  /// Enters what is below the top.
  void enter(ReachingSegment& one, std::int64_t top) {
    const auto rise = static_cast<double>(std::min(top, one.high) - one.low);
    double x0 = one.x, y0 = one.y, x1 = x0 + rise * one.lean_x, y1 = y0 + rise * one.lean_y;
    one.x = x1;
    one.y = y1;
    one.low = top;
    if (y0 > y1) {
      std::swap(x0, x1);
      std::swap(y0, y1);
    }
    while (row_begin_[one.row] > y0 - kMargin) --one.row;
    while (row_begin_[one.row + 1] < y0 - kMargin) ++one.row;
    const bool is_flat = y1 - y0 < kMargin;
    for (std::uint32_t row = one.row; row_begin_[row] <= y1 + kMargin; ++row) {
      // Where it enters the row and leaves it.
      const double in = row_begin_[row] - kMargin - y0, out = row_begin_[row + 1] + kMargin - y0;
      const double from = is_flat || in <= 0 ? x0 : x0 + in * one.lean;
      const double to = is_flat || out >= y1 - y0 ? x1 : x0 + out * one.lean;
      enter_row(row, from, to, one.line, one.index);
    }
  }

  /// Enters the whole box of a stub, which is short.
  void enter_stub(std::uint32_t index) {
    const auto& [p, q] = segment(index).at;
    const auto [low, high] = std::minmax({height(p), height(q)});
    const auto above = std::upper_bound(row_begin_.begin(), row_begin_.end(), low - kMargin);
    auto row = static_cast<std::uint32_t>(above - row_begin_.begin()) - 1;
    for (const LineModulo line = line_of({p, q}); row_begin_[row] <= high + kMargin; ++row) {
      enter_row(row, column(p), column(q), line, index);
    }
  }

  void enter_row(std::uint32_t row, double from, double to, const LineModulo& line,
                 std::uint32_t index) {
    const std::uint32_t first = row * columns_ + cell(std::min(from, to) - kMargin);
    const std::uint32_t last = row * columns_ + cell(std::max(from, to) + kMargin);
    entries_.push_back({line, index, first, last});
    ++end_of_cell_[first + 2];
  }

  std::uint32_t cell(double x) const {
    return std::min(static_cast<std::uint32_t>(static_cast<std::int32_t>(std::max(x, 0.0))),
                    columns_ - 1);
  }

  /// From left to right in each row: each with those that begin before it ends.
  void compare_entries() {
    for (std::size_t i = 2; i < end_of_cell_.size(); ++i) end_of_cell_[i] += end_of_cell_[i - 1];
    sorted_.resize(entries_.size());
    for (const CellEntry& entry : entries_) sorted_[end_of_cell_[entry.first + 1]++] = entry;
    separate_components();
    std::size_t middle = sorted_.size();  // the next one behind
    for (std::size_t i = sorted_.size(); i-- > 0;) {
      const bool is_middle = sorted_[i].index < middles_.size();
      compare_run(i, is_middle ? i + 1 : middle, end_of_cell_[sorted_[i].last + 1]);
      if (is_middle) middle = i;
    }
    compare_coplanar();
  }

  void separate_components() {
    lines_.resize(std::max(lines_.size(), sorted_.size() / kLanes + 2));
    for (std::size_t i = 0; i < sorted_.size(); ++i) {
      LineBlock& block = lines_[i / kLanes];
      for (std::size_t k = 0; k < 6; ++k) block[k][i % kLanes] = sorted_[i].line[k];
    }
  }

  /// Entry i with those from begin to end, which are behind it.
  void compare_run(std::size_t i, std::size_t begin, std::size_t end) {
    if (begin >= end) return;
    const CellEntry& one = sorted_[i];
    behind_.clear();
    kHasAvx2 ? add_coplanar_avx2(one.line, lines_, begin, end, behind_)
             : add_coplanar(one.line, lines_, begin, end, behind_);
    for (const std::size_t j : behind_) {
      const auto [low, high] = std::minmax({one.index, sorted_[j].index});
      if (low < middles_.size()) coplanar_.emplace_back(low, high);
    }
  }

  /// What may be coplanar: exactly. The segments are asked for ahead, as they stand anywhere.
  void compare_coplanar() {
    constexpr std::size_t kAhead = 8;
    for (std::size_t i = 0; i < coplanar_.size() + kAhead; ++i) {
      if (i < coplanar_.size()) {
        __builtin_prefetch(&segment(coplanar_[i].first));
        __builtin_prefetch(&segment(coplanar_[i].second));
      }
      if (i < kAhead) continue;
      const auto [first, second] = coplanar_[i - kAhead];
      const DrawnSegment &a = segment(first), &b = segment(second);
      if (middles_.size() + a.stub == second || a.owner == b.owner) continue;
      if (meet(a.at, b.at)) found_.push_back(std::max(a.owner, b.owner));
    }
    coplanar_.clear();
  }

  static constexpr double kMargin = 0x1p-20;  // of a column, and of 1024 in y
  const LongVector<DrawnSegment>& middles_;
  const LongVector<DrawnSegment>& stubs_;  ///< by index behind the middles
  std::uint32_t columns_, rows_;
  GrowingBox box_;
  double per_x_, per_y_;
  std::vector<double> row_begin_;
  std::vector<std::int64_t> bottom_;                ///< of each slab
  std::vector<std::vector<std::uint32_t>> begins_;  ///< what begins in each slab
  std::vector<CellEntry> entries_, sorted_;         ///< sorted by first cell
  std::vector<std::uint32_t> end_of_cell_;
  std::vector<LineBlock> lines_;  ///< of sorted_
  std::vector<std::size_t> behind_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> coplanar_;  ///< middle and other
  std::vector<std::uint32_t> found_;
};

}  // namespace

std::vector<std::uint32_t> owners_that_meet(const DrawnSegments& drawn,
                                            const DrawnSegments& before) {
  if (drawn.middles.empty()) return {};
  constexpr std::size_t kSmall = 60;  // up to here slabs cost more than they save
  SlabSweep sweep(drawn.middles, drawn.stubs);
  std::vector<std::uint32_t> moved;
  const auto add_moved = [&](const auto& now, const auto& then, std::size_t first) {
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (i < then.size() && now[i].at == then[i].at) continue;
      moved.push_back(static_cast<std::uint32_t>(first + i));
    }
  };
  if (drawn.middles.size() > kSmall) {
    add_moved(drawn.middles, before.middles, 0);
    add_moved(drawn.stubs, before.stubs, drawn.middles.size());
  }
  moved.size() * moved.size() < drawn.middles.size() ? sweep.compare_few(moved)
                                                     : sweep.compare_all();
  return sweep.found();
}

}  // namespace ar3d::two_bend_109
