#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "ar3d/model/lattice.h"
#include "ar3d/verify/checks/exact.h"

namespace ar3d::verify {

/// A segment; a vertex without edges is one of length zero.
struct Item {
  Point from;
  Point to;
};

/// The pairs of items that stand in a common cell of a grid over their box, with about as many
/// cells as items. Items with a common point are such a pair, once or several times: an item stands
/// in every cell that has a point of it (and in some others nearby). 4 bytes per item and cell.
/// Time and memory grow with the cells that long items pass through, the pairs up to quadratically.
class CandidatePairs {
 public:
  static constexpr std::size_t kMostItems = 1000000;

  /// @param most_places  of items in cells, together. @throws InputError if there are more items
  /// than kMostItems, or more places.
  explicit CandidatePairs(const std::vector<Item>& items,
                          std::size_t most_places = std::size_t{1} << 28);

  /// How many pairs there are, counted in every cell that they share.
  std::uint64_t size() const { return first_pair_.back(); }
  /// The pair of that number, first < second. @pre number < size(). O(log cells).
  std::pair<std::uint32_t, std::uint32_t> operator[](std::uint64_t number) const;
  /// Calls visit(first, second) for every pair while it returns true.
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (std::size_t cell = 0; cell + 1 < begin_.size(); ++cell) {
      for (std::size_t j = begin_[cell] + 1; j < begin_[cell + 1]; ++j) {
        for (std::size_t i = begin_[cell]; i < j; ++i) {
          if (!visit(places_[i], places_[j])) return;
        }
      }
    }
  }

 private:
  using Cells = std::array<std::int64_t, 3>;

  Cells cell_of(Point p) const;
  template <class Visit>
  void for_each_cell(const Item& item, Visit&& visit) const;

  Point low_;
  Cells size_{1, 1, 1};                    ///< of a cell, by axis
  Cells count_{1, 1, 1};                   ///< of cells, by axis
  std::vector<std::size_t> begin_;         ///< of each cell in places_, and their end
  std::vector<std::uint32_t> places_;      ///< items by cell, ascending in each
  std::vector<std::uint64_t> first_pair_;  ///< number of each cell's first pair, and their end
};

}  // namespace ar3d::verify
