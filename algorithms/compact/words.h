#pragma once

// The words of the edges: +p (long) -s1 (short) +q (long) -s2 (short) +r (long) -s3 (short), from
// tail to head. Long lengths are forced by the two ends; short ones are 1 or 2.

#include <array>
#include <cstdint>
#include <vector>

#include "ar3d/algorithms/compact/letters.h"
#include "ar3d/algorithms/strips/lines.h"

namespace ar3d::compact {

using strips::Piece;

/// The contested lines.
enum class LineKind : std::uint8_t { upper_b = 1, upper_c = 2, lower_c = 3 };

/// The number of the line of the kind's letter through the point.
std::uint64_t line_key(LineKind kind, const Letters& through);

/// Holds what determines the word of an edge.
struct Shape {
  bool red = false;
  std::int32_t tail_type = 0;
  std::int32_t head_type = 0;
  bool right = true;     ///< the head is in a higher column than the tail; green: tail_type == 0
  unsigned variant = 0;  ///< below variants(red); 0 is the one of the size bound's proof
};

inline unsigned variants(bool red) { return red ? 2 : 4; }

struct Word {
  std::array<Letter, 3> long_letter{};                ///< p, q, r, all different
  std::array<Letter, 3> short_letter{};               ///< s1, s2, s3
  std::array<std::int32_t, 3> short_length{2, 2, 2};  ///< of s1, s2, s3
  Letter spare = kD;                                  ///< m, the letter that is not long
};

Word word_of(const Shape& shape);

/// The lengths of p, q, r between the two vertices. The word fits if all are at least 1.
std::array<std::int32_t, 3> long_lengths(const Word& word, const Letters& tail,
                                         const Letters& head);

/// Returns where the contested segment of the edge begins, its middle one (q); it runs down from
/// there.
Letters middle_start(const Word& word, const Letters& tail,
                     const std::array<std::int32_t, 3>& lengths);
Piece middle_piece(const Word& word, bool red, const Letters& start, std::int32_t length);

/// The whole line on which a green edge arrives at a vertex (letter c at type 0, b at type 1).
Piece arrival_line(Site head);

/// Appends the five bends from tail to head.
void append_bends_of(const Word& word, const Letters& tail,
                     const std::array<std::int32_t, 3>& lengths, std::vector<Point>& out);

// The contested segment of an edge in few additions: along each word the lengths, the middle line
// and its heights are sums of coordinates of the two ends and constants of the word.

/// A vertex at a place with what its edges ask of it.
struct PlacedEnd {
  std::int32_t U = 0;
  std::int32_t type = 0;
  std::array<std::int32_t, 2> form{};  ///< g = BD, h = CD
};
inline PlacedEnd end_at(SiteForms p) {
  return {p.U, p.U / 2 % 2, {(p.U + p.V) / 2, (p.U - p.V) / 2}};
}

/// Holds what a word adds to the coordinates of the ends.
struct WordConstants {
  std::array<std::int32_t, 3> length{};  ///< of p, q, r
  std::int32_t first = 0;                ///< the form AD of the middle line
  std::int32_t second = 0;               ///< its other form: CD of letter b, BD of letter c
  std::int32_t top = 0;                  ///< the height where it begins
  std::uint64_t step = 0;                ///< for strips: from the line's number in variant 0
};

/// The index of the constants of variant 0 of an edge; its other variants follow.
inline std::size_t word_index(bool red, std::int32_t tail_type, std::int32_t head_type,
                              bool right) {
  return 4 * ((red ? 8u : 0u) + static_cast<std::size_t>(4 * tail_type + 2 * head_type) +
              (right ? 1u : 0u));
}
using WordTable = std::array<WordConstants, 64>;
/// The constants of all words, read off word_of(); `step` is 0.
WordTable word_table();

/// The numbers of an edge except its word's constants, and where these are.
struct MiddleLine {
  std::array<std::int32_t, 3> length;
  std::int32_t first;
  std::int32_t second;
  std::int32_t top;
  std::size_t word;      ///< word_index
  std::uint64_t number;  ///< for strips: the line's in variant 0
};

/// Types and sides are as good as random, so they are indices and signs rather than branches.
inline MiddleLine middle_line(bool red, const PlacedEnd& tail, const PlacedEnd& head) {
  const bool right = head.U > tail.U;
  const auto of_b = static_cast<std::size_t>(!right);
  const std::int32_t sign = 2 * static_cast<std::int32_t>(right) - 1;
  const std::int32_t along_ad = sign * (head.U - tail.U);  // letter a to the right, else d
  const std::int32_t along_b = sign * (head.form[of_b] - tail.form[of_b]);
  const std::int32_t along_c = sign * (head.form[1 - of_b] - tail.form[1 - of_b]);
  MiddleLine line;
  line.word = word_index(red, tail.type, head.type, right);
  line.number = 0;
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
