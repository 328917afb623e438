#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ar3d/algorithms/grid/heights.h"

namespace ar3d::grid {

/// The slot kept for a defect (x: label_x, y: 2): heights low and low + 1 of colour 1 - label_x.
struct HeightSlot {
  std::int64_t low = 0;
  std::int64_t below_x = 0;  ///< x's height of that colour minus low
};

/// The paths of colours 0 and 1 of one component that end at the x of a defect.
/// Every x is put above its y in both heights, with the defect's slot between:
/// h_k(y) < low, low + 1 < h_k(x), h_l(x) - h_l(y) >= low + 2 - h_k(y) with l = label_x, k = 1 - l.
/// A path is numbered from its middle upwards to both ends; paths that wait for nobody come first,
/// one above the other; the rest grow side by side, so that their ends come last.
class DefectPaths {
 public:
  /// @param paths_of  scratch for all places, kNoPath everywhere; used while this lives.
  DefectPaths(HeightPool& pool, std::span<const ColourDefect> defects,
              std::vector<std::uint32_t>& path_of);
  ~DefectPaths();
  DefectPaths(const DefectPaths&) = delete;
  DefectPaths& operator=(const DefectPaths&) = delete;

  bool contains(Place v) const { return path_of_[v] != kNoPath; }
  /// To be called when all other chains have numbers.
  /// @return some defects of those that ask for x above y in a circle; none if all is well.
  std::vector<std::size_t> number_all();
  /// One slot a defect, in their order.
  const std::vector<HeightSlot>& slots() const { return slots_; }
  /// Attempts to finish an end so far.
  std::int64_t end_visits() const { return end_visits_; }

  static constexpr std::uint32_t kNoPath = std::numeric_limits<std::uint32_t>::max();

 private:
  enum class EndState : std::uint8_t { open, in_progress, done };

  /// Joint i stands before vertices[i], the last joint after the last vertex. The first vertex is
  /// an x; the last may be one.
  struct Path {
    std::vector<Place> vertices;
    Colour first_colour = 0;  // of joint 0
    bool both_ends = false;
    bool grown = false;
    std::array<EndState, 2> end{};
    std::uint32_t waits_for = 0;  // paths that hold a y of this one's ends
    std::size_t first = 0;        // joints first .. last - 1 are numbered before the ends
    std::size_t last = 0;
    std::size_t left = 0;  // joints left .. right - 1 are numbered
    std::size_t right = 0;
    std::int64_t floor = 0;
    std::array<std::int64_t, 2> side{};  // heights of joints left and right - 1
    Colour colour_of(std::size_t joint) const {
      return (joint & 1) == 0 ? first_colour : 1 - first_colour;
    }
    std::size_t steps() const {
      return last <= first ? 0 : both_ends ? (last - first) / 2 : last - first - 1;
    }
  };

  bool is_x(Place v) const { return !defects_at(v).empty(); }
  std::span<const std::size_t> defects_at(Place x) const;
  std::vector<std::size_t> blocked();
  void collect(std::span<const ColourDefect> defects);
  void add(Path path);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> find_waiting();
  void begin(Path& path);
  void grow(Path& path, unsigned side);
  void grow_alone(Path& path);
  void grow_together();
  void set_joint(Path& path, std::size_t joint, std::int64_t h);
  bool finish_ends(std::uint32_t path, int depth);
  bool finish_end(std::uint32_t path, unsigned side, int depth);
  bool number_lower_ends(std::span<const Place> xs, int depth);
  void place(std::span<const Place> xs);
  void place_colour(std::span<const Place> xs, Place x, Colour c);
  void keep_slot(std::size_t defect);
  std::int64_t least_height(Place x, Colour c) const;

  HeightPool& pool_;
  const std::int64_t height_limit_;
  const std::span<const ColourDefect> defects_;
  std::vector<std::size_t> by_x_;  // defects sorted by x
  std::vector<std::uint32_t>& path_of_;
  std::vector<Path> paths_;
  std::vector<HeightSlot> slots_;
  std::int64_t end_visits_ = 0;
};

}  // namespace ar3d::grid
