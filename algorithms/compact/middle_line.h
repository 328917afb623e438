#pragma once

// The contested segment of an edge in few additions: along each word the lengths, the middle line
// and its heights are sums of coordinates of the two ends and constants of the word.

#include <array>
#include <cstdint>

#include "ar3d/algorithms/compact/words.h"

namespace ar3d::compact {

/// A vertex at a place with what its edges ask of it.
struct End {
  std::int32_t U = 0;
  std::int32_t type = 0;
  std::array<std::int32_t, 2> form{};  ///< g = BD, h = CD
};
inline End end_at(Place p) { return {p.U, p.U / 2 % 2, {(p.U + p.V) / 2, (p.U - p.V) / 2}}; }

/// What a word adds to the coordinates of the ends.
struct WordConstants {
  std::array<std::int32_t, 3> length{};  ///< of p, q, r
  std::int32_t first = 0;                ///< the form AD of the middle line
  std::int32_t second = 0;               ///< its other form: CD of letter b, BD of letter c
  std::int32_t top = 0;                  ///< the height where it begins
};

/// The constants of all words, read off word_of().
class WordTable {
 public:
  WordTable();
  /// The place in constants() of variant 0 of an edge; its other variants follow.
  static std::size_t index(bool red, std::int32_t tail_type, std::int32_t head_type, bool right) {
    return 4 * ((red ? 8u : 0u) + static_cast<std::size_t>(4 * tail_type + 2 * head_type) +
                (right ? 1u : 0u));
  }
  const std::array<WordConstants, 64>& constants() const { return constants_; }

 private:
  std::array<WordConstants, 64> constants_{};
};

/// The numbers of an edge but for its word's constants, and where these are.
struct MiddleLine {
  std::array<std::int32_t, 3> length;
  std::int32_t first;
  std::int32_t second;
  std::int32_t top;
  std::size_t word;  ///< WordTable::index
};

/// Types and sides are as good as random, so they are indices and signs rather than branches.
inline MiddleLine middle_line(bool red, const End& tail, const End& head) {
  const bool right = head.U > tail.U;
  const auto of_b = static_cast<std::size_t>(!right);
  const std::int32_t sign = 2 * static_cast<std::int32_t>(right) - 1;
  const std::int32_t along_ad = sign * (head.U - tail.U);  // letter a to the right, else d
  const std::int32_t along_b = sign * (head.form[of_b] - tail.form[of_b]);
  const std::int32_t along_c = sign * (head.form[1 - of_b] - tail.form[1 - of_b]);
  MiddleLine line;
  line.word = WordTable::index(red, tail.type, head.type, right);
  std::int32_t form = 0;
  if (red) {
    line.length = {along_b, along_c, along_ad};
    line.first = tail.U;
    line.top = -along_b;
    form = head.form[of_b];
  } else {
    const bool q_is_b = head.type == 0;
    line.length = {along_ad, q_is_b ? along_b : along_c, q_is_b ? along_c : along_b};
    line.first = head.U;
    line.top = along_ad;
    form = tail.form[tail.type == head.type ? 1 : 0];
  }
  line.second = right ? form : line.first - form;
  return line;
}

}  // namespace ar3d::compact
