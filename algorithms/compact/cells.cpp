// Of 27 cells that are tried for a vertex of a random 4-regular graph 26 are refused, nearly all
// since they are taken or a length to a neighbour would be below 1 (rule (b) of Lemmas C.3 to C.5).
// Places alone tell that, so it is decided first, for eight cells side by side. Cost: 20
// instructions per cell with AVX2.
#include "ar3d/algorithms/compact/cells.h"

#include <cstdlib>

#if defined(__x86_64__) && defined(__GNUC__)
#include <immintrin.h>
#endif

namespace ar3d::compact {

bool is_open(const CellChoice& choice, const TakenSites& taken, SiteForms place) {
  for (std::size_t i = 0; i < choice.num_neighbours; ++i) {
    const SiteForms& other = choice.neighbours[i];
    if (other.U / 4 == place.U / 4) return false;
    if (std::abs(other.V - place.V) > std::abs(other.U - place.U) + 2) return false;
  }
  return !taken.is_taken(place);
}

void draw_cells_plainly(const CellChoice& choice, const TakenSites& taken,
                        const std::uint32_t* numbers, CellBatch& batch) {
  batch.open = 0;
  batch.is_exact = true;
  for (std::size_t k = 0; k < kCellsAtOnce; ++k) {
    const auto below = [&](std::uint32_t number, std::int32_t bound) {
      const std::uint64_t product = std::uint64_t{number} * static_cast<std::uint32_t>(bound);
      if (static_cast<std::uint32_t>(product) < static_cast<std::uint32_t>(bound)) {
        batch.is_exact = false;
      }
      return static_cast<std::int32_t>(product >> 32);
    };
    const std::int32_t row = below(numbers[2 * k], choice.rows);
    const std::int32_t first = choice.low + ((choice.low ^ row) & 1);
    const std::int32_t column =
        first + 2 * below(numbers[2 * k + 1], (choice.high - first) / 2 + 1);
    const SiteForms place = forms_of({column, row, column > choice.last_of_type_0 ? 1 : 0});
    batch.U[k] = place.U;
    batch.V[k] = place.V;
    batch.open |= (is_open(choice, taken, place) ? 1u : 0u) << k;
  }
}

#if defined(__x86_64__) && defined(__GNUC__)
namespace {

const bool kHasAvx2 = __builtin_cpu_supports("avx2") != 0;

#define AR3D_AVX2 __attribute__((target("avx2")))
#define AR3D_AVX2_INLINE __attribute__((target("avx2"), always_inline)) inline

/// Eight cells. Cells 0 to 3 are in the even lanes of 32 bits, cells 4 to 7 in the odd ones: there
/// a row's number is the low half of a lane of 64 bits and a column's the high half.
struct Cells {
  __m256i row;
  __m256i column;
  __m256i minus_two_types;
  __m256i U;
  __m256i V;
  bool is_exact;
};

AR3D_AVX2_INLINE Cells drawn_cells(const CellChoice& choice, const std::uint32_t* numbers) {
  const __m256i a = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(numbers));
  const __m256i b = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(numbers) + 1);
  const __m256i rows = _mm256_set1_epi32(choice.rows);
  const __m256i row_a = _mm256_mul_epu32(a, rows);
  const __m256i row_b = _mm256_mul_epu32(b, rows);
  const __m256i row = _mm256_blend_epi32(_mm256_srli_epi64(row_a, 32), row_b, 0xaa);
  const __m256i row_rest = _mm256_blend_epi32(row_a, _mm256_slli_epi64(row_b, 32), 0xaa);

  const __m256i low = _mm256_set1_epi32(choice.low);
  const __m256i is_odd =  // of the first column, beyond `low`
      _mm256_and_si256(_mm256_xor_si256(low, row), _mm256_set1_epi32(1));
  const __m256i width = _mm256_set1_epi32(choice.high - choice.low + 2);
  const __m256i choices = _mm256_srli_epi32(_mm256_sub_epi32(width, is_odd), 1);
  const __m256i column_a = _mm256_mul_epu32(_mm256_srli_epi64(a, 32), choices);
  const __m256i column_b =
      _mm256_mul_epu32(_mm256_srli_epi64(b, 32), _mm256_srli_epi64(choices, 32));
  const __m256i chosen = _mm256_blend_epi32(_mm256_srli_epi64(column_a, 32), column_b, 0xaa);
  const __m256i column_rest = _mm256_blend_epi32(column_a, _mm256_slli_epi64(column_b, 32), 0xaa);
  const __m256i column =
      _mm256_add_epi32(_mm256_add_epi32(low, is_odd), _mm256_slli_epi32(chosen, 1));

  const __m256i exact =
      _mm256_and_si256(_mm256_cmpeq_epi32(_mm256_max_epu32(row_rest, rows), row_rest),
                       _mm256_cmpeq_epi32(_mm256_max_epu32(column_rest, choices), column_rest));
  const __m256i minus_two_types =
      _mm256_slli_epi32(_mm256_cmpgt_epi32(column, _mm256_set1_epi32(choice.last_of_type_0)), 1);
  return {row,
          column,
          minus_two_types,
          _mm256_sub_epi32(_mm256_slli_epi32(column, 2), minus_two_types),
          _mm256_add_epi32(_mm256_slli_epi32(row, 2), minus_two_types),
          _mm256_movemask_ps(_mm256_castsi256_ps(exact)) == 0xff};
}

/// All ones in the lanes whose cell the neighbours do not leave open.
AR3D_AVX2_INLINE __m256i closed_by_neighbours(const CellChoice& choice, const Cells& cells) {
  __m256i closed = _mm256_setzero_si256();
  for (std::size_t i = 0; i < choice.num_neighbours; ++i) {
    const SiteForms& other = choice.neighbours[i];
    const __m256i across = _mm256_abs_epi32(_mm256_sub_epi32(_mm256_set1_epi32(other.U), cells.U));
    const __m256i along = _mm256_abs_epi32(_mm256_sub_epi32(_mm256_set1_epi32(other.V), cells.V));
    const __m256i most = _mm256_add_epi32(across, _mm256_set1_epi32(2));
    const __m256i their_column = _mm256_set1_epi32(other.U / 4);
    closed =
        _mm256_or_si256(closed, _mm256_or_si256(_mm256_cmpgt_epi32(along, most),
                                                _mm256_cmpeq_epi32(cells.column, their_column)));
  }
  return closed;
}

/// The highest bit of the lanes that are not closed and whose place is taken. The type comes from
/// the low bits of -2 type.
AR3D_AVX2_INLINE __m256i taken_places(const TakenSites& taken, const Cells& cells, __m256i closed) {
  const __m256i ones = _mm256_set1_epi32(-1);
  const __m256i cell =
      _mm256_add_epi32(_mm256_mullo_epi32(cells.column, _mm256_set1_epi32(taken.rows_of_column())),
                       _mm256_srli_epi32(cells.row, 1));
  const __m256i bit =
      _mm256_sub_epi32(_mm256_slli_epi32(cell, 1), _mm256_srai_epi32(cells.minus_two_types, 1));
  const __m256i word =
      _mm256_mask_i32gather_epi32(ones, reinterpret_cast<const int*>(taken.words()),
                                  _mm256_srli_epi32(bit, 5), _mm256_xor_si256(closed, ones), 4);
  const __m256i in_word = _mm256_and_si256(bit, _mm256_set1_epi32(31));
  return _mm256_slli_epi32(_mm256_srlv_epi32(word, in_word), 31);
}

AR3D_AVX2 void draw_cells_avx2(const CellChoice& choice, const TakenSites& taken,
                               const std::uint32_t* numbers, CellBatch& batch) {
  const Cells cells = drawn_cells(choice, numbers);
  const __m256i closed = closed_by_neighbours(choice, cells);
  const __m256i refused = _mm256_or_si256(closed, taken_places(taken, cells, closed));
  const __m256i in_order = _mm256_set_epi32(7, 5, 3, 1, 6, 4, 2, 0);
  _mm256_store_si256(reinterpret_cast<__m256i*>(batch.U.data()),
                     _mm256_permutevar8x32_epi32(cells.U, in_order));
  _mm256_store_si256(reinterpret_cast<__m256i*>(batch.V.data()),
                     _mm256_permutevar8x32_epi32(cells.V, in_order));
  const __m256i refused_in_order = _mm256_permutevar8x32_epi32(refused, in_order);
  batch.open =
      static_cast<std::uint32_t>(~_mm256_movemask_ps(_mm256_castsi256_ps(refused_in_order))) &
      0xffu;
  batch.is_exact = cells.is_exact;
}

#undef AR3D_AVX2
#undef AR3D_AVX2_INLINE

}  // namespace
#endif

void draw_cells(const CellChoice& choice, const TakenSites& taken, const std::uint32_t* numbers,
                CellBatch& batch) {
#if defined(__x86_64__) && defined(__GNUC__)
  if (kHasAvx2) return draw_cells_avx2(choice, taken, numbers, batch);
#endif
  draw_cells_plainly(choice, taken, numbers, batch);
}

}  // namespace ar3d::compact
