#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/model/lattice.h"
#include "ar3d/verify/predicates/functional.h"

// Pairs of segments of any directions that may meet (Steps V.12 to V.14 of docs/verify.md): space
// is halved again and again, each half keeps the segments that may have a point in it, and the few
// segments of a small cell are compared with each other.

namespace ar3d::verify {

/// True if the boxes of two segments have no point in common.
bool are_apart(const Box& a, const Box& b);
/// True only if, seen along an axis, both ends of one lie on the same side of the other's line: then
/// they do not meet (Lemma V.10). Also in one plane, where no pair is skew. @pre as surely_skew.
bool surely_apart(const SegmentInSpace& a, const SegmentInSpace& b);

namespace near_pairs {

/// Coordinates whose axes are roughly the directions that add up to most: then the boxes of most segments are
/// flat, and planes across an axis cut few of them. The map is linear and moves no two points
/// together.
class Axes {
 public:
  /// @param steps  of some segments. @param box  of all; far from the origin the axes stay.
  Axes(const std::vector<Vector>& steps, const Box& box);
  SegmentInSpace operator()(const SegmentInSpace& s) const {
    const Vector from = image({s.from.x, s.from.y, s.from.z});
    return {{from.x, from.y, from.z}, image(s.step)};
  }

 private:
  Vector image(Vector v) const {
    const auto value = [v](Vector row) { return row.x * v.x + row.y * v.y + row.z * v.z; };
    return {value(rows_[0]), value(rows_[1]), value(rows_[2])};
  }

  std::array<Vector, 3> rows_{Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}};
};

/// A segment in a cell: all its points there have begin <= t <= end.
struct Piece {
  std::uint32_t segment;
  float begin;
  float end;
};

/// Holds how far a piece reaches beyond a plane that cuts it, as a part of the whole segment: more
/// than all rounding (Lemma V.7).
inline constexpr double kMargin = 0x1p-22;

/// A plane at right angles to an axis: the axis, and its place in units of 2^-shift lattice units.
using Cut = std::pair<std::size_t, std::int64_t>;

/// Says by how many bits planes may stand finer than the lattice, for each axis.
using Shifts = std::array<unsigned, 3>;
Shifts shifts_for(const Box& box);

/// Where a piece lies along an axis: from low over the middle to high.
using Reached = std::array<double, 3>;
/// The plane through the median of the pieces' middles, on the axis where it cuts fewest of them.
/// @param sample  some pieces of a cell, by axis; at least one.
Cut best_cut(std::array<std::vector<Reached>, 3>& sample);

/// Holds what of a piece may lie on either side of a plane, the plane included.
struct Parts {
  Piece below;
  Piece above;
  bool has_below;
  bool has_above;
};

/// @param from, step  of the piece's segment along the axis, in units of the place.
inline Parts cut_piece(const Piece& piece, std::int64_t from, std::int64_t step,
                       std::int64_t place) {
  if (step == 0) return {piece, piece, from <= place, from >= place};
  const double t = static_cast<double>(place - from) / static_cast<double>(step);
  Piece before = piece;
  Piece after = piece;
  if (t + kMargin < double{piece.end}) before.end = static_cast<float>(t + kMargin);
  if (t - kMargin > double{piece.begin}) after.begin = static_cast<float>(t - kMargin);
  const bool has_before = before.begin <= before.end;
  const bool has_after = after.begin <= after.end;
  return step > 0 ? Parts{before, after, has_before, has_after}
                  : Parts{after, before, has_after, has_before};
}

/// Searches a cell and all that it is cut into.
template <class SegmentAt, class Visit>
class Search {
 public:
  Search(const Shifts& shifts, const SegmentAt& at, Visit& visit, std::size_t few,
         std::uint64_t most, const std::function<void(std::uint64_t)>& compares)
      : shifts_(shifts), at_(at), visit_(visit), few_(few), most_(most), compares_(compares) {}

  /// @return the number of pairs that were compared.
  std::uint64_t run(std::vector<Piece> pieces) {
    pieces_ = std::move(pieces);
    compared_ = 0;
    is_stopped_ = false;
    search(0, 0, 1);
    return compared_;
  }

 private:
  static constexpr std::size_t kSample = 12;  ///< pieces that choose a plane
  static constexpr int kDeepest = 128;
  static constexpr double kMostGrowth = 4;

  /// The cell of the pieces from `begin` to the end of the list, which are dropped from it.
  /// @param growth  of the number of pairs by the cuts down to here (Lemma V.8).
  void search(std::size_t begin, int depth, double growth) {
    const std::size_t end = pieces_.size();
    const std::size_t size = end - begin;
    if (is_stopped_) return pieces_.resize(begin);
    if (size <= few_ || depth == kDeepest) return compare(begin);
    const std::size_t middle = split(begin, chosen_cut(begin));
    const auto square = [](std::size_t count) {
      return static_cast<double>(count) * static_cast<double>(count);
    };
    growth *= (square(middle - end) + square(pieces_.size() - middle)) / square(size);
    if (growth > kMostGrowth) {
      pieces_.resize(end);
      return compare(begin);
    }
    search(middle, depth + 1, growth);
    search(end, depth + 1, growth);
    pieces_.resize(begin);
  }

  Cut chosen_cut(std::size_t begin) {
    const std::size_t size = pieces_.size() - begin;
    const std::size_t count = std::min(size, kSample);
    for (auto& list : sample_) list.clear();
    for (std::size_t i = 0; i < count; ++i) {
      const Piece& piece = pieces_[begin + i * size / count];
      const SegmentInSpace s = at_(piece.segment);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto from = static_cast<double>(component(s.from, axis) << shifts_[axis]);
        const auto step = static_cast<double>(component(s.step, axis) << shifts_[axis]);
        const double first = from + step * double{piece.begin};
        const double last = from + step * double{piece.end};
        sample_[axis].push_back({std::min(first, last), (first + last) / 2, std::max(first, last)});
      }
    }
    return best_cut(sample_);
  }

  /// Appends what is below the plane, then what is above it. @return where that begins.
  std::size_t split(std::size_t begin, Cut cut) {
    const std::size_t end = pieces_.size();
    const auto [axis, place] = cut;
    const unsigned shift = shifts_[axis];
    above_.clear();
    for (std::size_t i = begin; i < end; ++i) {
      const Piece piece = pieces_[i];
      const SegmentInSpace s = at_(piece.segment);
      const Parts parts = cut_piece(piece, component(s.from, axis) << shift,
                                    component(s.step, axis) << shift, place);
      if (parts.has_below) pieces_.push_back(parts.below);
      if (parts.has_above) above_.push_back(parts.above);
    }
    const std::size_t middle = pieces_.size();
    pieces_.insert(pieces_.end(), above_.begin(), above_.end());
    return middle;
  }

  void compare(std::size_t begin) {
    constexpr std::uint64_t kMany = 100'000'000;  // pairs, which take seconds
    const std::uint64_t size = pieces_.size() - begin, pairs = size * (size - 1) / 2;
    if (pairs > kMany && compares_) compares_(pairs);
    cell_.clear();
    for (std::size_t i = begin; i < pieces_.size(); ++i) {
      const SegmentInSpace s = at_(pieces_[i].segment);
      GrowingBox box;
      box.add(s.from);
      box.add(s.from + s.step);
      cell_.emplace_back(box.box(), s);
    }
    for (std::size_t i = 1; i < cell_.size() && !is_stopped_; ++i) {
      compared_ += i;
      is_stopped_ = compared_ > most_;
      for (std::size_t j = 0; j < i && !is_stopped_; ++j) {
        const auto& [box, s] = cell_[i];
        const auto& [other_box, t] = cell_[j];
        if (are_apart(box, other_box) || surely_skew(s, t) || surely_apart(s, t)) continue;
        is_stopped_ = !visit_(pieces_[begin + i].segment, pieces_[begin + j].segment);
      }
    }
    pieces_.resize(begin);
  }

  Shifts shifts_;
  const SegmentAt& at_;
  Visit& visit_;
  std::size_t few_;
  std::uint64_t most_;
  const std::function<void(std::uint64_t)>& compares_;
  std::uint64_t compared_ = 0;
  bool is_stopped_ = false;
  std::vector<Piece> pieces_;  ///< of the cell at hand, and of those that wait on the way to it
  std::vector<Piece> above_;
  std::array<std::vector<Reached>, 3> sample_;
  std::vector<std::pair<Box, SegmentInSpace>> cell_;
};

}  // namespace near_pairs

/// Calls visit(i, j) for pairs i != j of the segments at(0), ..., at(size - 1) whose boxes meet, among
/// them every pair that meets; some of them more than once; until it returns false. O(size log size) time
/// where segments are short, about O(size^1.5) where long ones are spread evenly, never more than
/// O(size^2). Memory: 12 bytes for each segment of the cells on one path, about 40 bytes per
/// segment.
/// @param few  pieces in a cell that are compared with each other; tests set it small.
/// @param most  comparisons; the search ends behind the first cell that passes it.
/// @param compares  is called for a cell with so many pairs that comparing them takes seconds.
/// @return the number of pairs that were compared. @pre coordinates are in range.
template <class SegmentAt, class Visit>
std::uint64_t for_each_near_pair(std::uint32_t size, const SegmentAt& at, Visit&& visit,
                                 std::size_t few = 48,
                                 std::uint64_t most = std::numeric_limits<std::uint64_t>::max(),
                                 const std::function<void(std::uint64_t)>& compares = {}) {
  constexpr std::uint32_t kSample = 1000;  // steps that choose the axes
  GrowingBox box;
  std::vector<near_pairs::Piece> all;
  std::vector<Vector> steps;
  all.reserve(size);
  for (std::uint32_t i = 0; i < size; ++i) {
    const SegmentInSpace s = at(i);
    box.add(s.from);
    box.add(s.from + s.step);
    all.push_back({i, 0, 1});
    if (i % (size / kSample + 1) == 0) steps.push_back(s.step);
  }
  const near_pairs::Axes axes(steps, box.box());
  const auto seen = [&](std::uint32_t i) { return axes(at(i)); };
  GrowingBox seen_box;
  for (std::uint32_t i = 0; i < size; ++i) {
    const SegmentInSpace s = seen(i);
    seen_box.add(s.from);
    seen_box.add(s.from + s.step);
  }
  near_pairs::Search search(near_pairs::shifts_for(seen_box.box()), seen, visit, few, most,
                            compares);
  return search.run(std::move(all));
}

}  // namespace ar3d::verify
