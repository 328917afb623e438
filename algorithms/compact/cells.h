#pragma once

// Random cells for one vertex, eight at a time, and which of them its placed neighbours leave to
// it.

#include <array>
#include <cstdint>
#include <vector>

#include "ar3d/algorithms/compact/letters.h"

namespace ar3d::compact {

inline constexpr std::size_t kCellsAtOnce = 8;

/// Holds which places of a strip are taken: a bit for each cell and type.
class TakenSites {
 public:
  explicit TakenSites(const StripSize& size)
      : rows_of_column_(static_cast<std::size_t>(size.rows / 2 + 1)),
        words_(2 * static_cast<std::size_t>(size.columns) * rows_of_column_ / 32 + 1) {}
  bool is_taken(SiteForms place) const {
    const std::size_t bit = bit_of(place);
    return (words_[bit / 32] >> bit % 32 & 1) != 0;
  }
  void flip(SiteForms place) {
    const std::size_t bit = bit_of(place);
    words_[bit / 32] ^= std::uint32_t{1} << bit % 32;
  }
  // To look at several: the bit of a place is 2 (column * rows_of_column() + (V + 2 type) /
  // 8) + type, below 2^31, in words of 32.
  std::int32_t rows_of_column() const { return static_cast<std::int32_t>(rows_of_column_); }
  const std::uint32_t* words() const { return words_.data(); }

 private:
  std::size_t bit_of(SiteForms place) const {
    const std::int32_t type = place.U / 2 % 2;
    return 2 * (static_cast<std::size_t>(place.U / 4) * rows_of_column_ +
                static_cast<std::size_t>((place.V + 2 * type) / 8)) +
           static_cast<std::size_t>(type);
  }
  std::size_t rows_of_column_;  ///< every other row has a cell in a column
  std::vector<std::uint32_t> words_;
};

/// Holds which cells a vertex takes: a random row, then a random column of low ... high that has a
/// cell in that row.
struct CellChoice {
  std::int32_t rows = 1;
  std::int32_t low = 0;
  std::int32_t high = 0;
  std::int32_t last_of_type_0 = 0;  ///< type 1 in the columns beyond
  std::array<SiteForms, 4> neighbours{};
  std::size_t num_neighbours = 0;

  /// Numbers of the stream tell a cell each by two, unless one of them is refused (`below`): a row
  /// may have no column.
  bool has_cells_in_every_row() const { return low < high; }
};

/// Places drawn from numbers[2k] and numbers[2k + 1], 0 <= k < 8.
struct CellBatch {
  alignas(32) std::array<std::int32_t, kCellsAtOnce> U;
  alignas(32) std::array<std::int32_t, kCellsAtOnce> V;
  /// Bit k: the place is free, no neighbour stands in its column, and |dV| <= |dU| + 2 to each.
  std::uint32_t open = 0;
  bool is_exact = false;  ///< no number is one that RandomStream::below passes over
};

/// @param choice  has_cells_in_every_row(). Several cells at a time on processors that have AVX2.
void draw_cells(const CellChoice& choice, const TakenSites& taken, const std::uint32_t* numbers,
                CellBatch& batch);
/// The same, on every processor.
void draw_cells_plainly(const CellChoice& choice, const TakenSites& taken,
                        const std::uint32_t* numbers, CellBatch& batch);

/// Returns what CellBatch::open says of one place.
bool is_open(const CellChoice& choice, const TakenSites& taken, SiteForms place);

}  // namespace ar3d::compact
