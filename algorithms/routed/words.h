#pragma once

#include <span>

#include "ar3d/algorithms/routed/steps.h"

namespace ar3d::routed {

/// The directions of an edge's segments, three of which are independent: their lengths are solved
/// for, the others' are chosen.
struct DirectionWord {
  std::array<std::uint8_t, kMostSegments> direction{};
  std::array<std::uint8_t, 3> solved{};  ///< segments
  std::array<std::uint8_t, 3> chosen{};
};

/// Three independent directions; rows of the adjugate of their matrix, with signs such that the
/// determinant, a power of two, is positive: lengths are (row . displacement) / determinant.
struct Basis {
  std::array<Spot, 3> rows;
  int log_determinant = 0;
};

/// Words with the same directions solved for and the same chosen ones, in any order: bounds and
/// lengths are found once for all.
struct WordGroup {
  std::uint32_t first = 0;
  std::uint16_t count = 0;
  std::uint16_t basis = 0;
  std::uint8_t segments = 0;
  std::uint8_t num_chosen = 0;
  std::uint8_t log_determinant = 0;
  /// What one step of chosen segment k takes from row i's inner product.
  std::array<std::array<std::int16_t, 3>, 3> taken{};
};

/// All words of 3 to bends + 1 segments, by the frames of the two ends.
class Words {
 public:
  /// Of a class and a number of bends, 3 to 5; made once for all drawings of a process.
  static const Words& of(const PointClass& points, int bends);

  const PointClass& points() const { return points_; }
  int bends() const { return bends_; }
  const std::vector<Basis>& bases() const { return bases_; }
  const DirectionWord* word(std::uint32_t i) const { return words_.data() + i; }
  /// Ascending by segments; numbers of frames as in points().frames().
  std::span<const WordGroup> groups(std::size_t from, std::size_t to) const {
    return groups_[from * points_.frames().size() + to];
  }

 private:
  Words(const PointClass& points, int bends);
  void group(std::size_t from, std::size_t to);
  void extend(std::vector<int>& directions, Directions first, Directions last);
  void split(const std::vector<int>& directions);
  std::uint16_t basis_of(int a, int b, int c);

  struct Keyed {
    std::uint64_t key = 0;
    DirectionWord word;
  };
  const PointClass& points_;
  int bends_;
  std::vector<Keyed> found_;  // of the pair of frames at hand
  std::vector<std::uint32_t> basis_keys_;
  std::vector<Basis> bases_;
  std::vector<DirectionWord> words_;
  std::vector<std::vector<WordGroup>> groups_;
};

}  // namespace ar3d::routed
