#pragma once

// The words of the edges: +p (long) -s1 (short) +q (long) -s2 (short) +r (long) -s3 (short), from
// tail to head. Long lengths are forced by the two ends; short ones are 1 or 2.

#include <array>
#include <vector>

#include "ar3d/algorithms/compact/letters.h"
#include "ar3d/algorithms/strips/lines.h"

namespace ar3d::compact {

using strips::Piece;

/// The contested lines.
enum class LineKind : std::uint8_t { upper_b = 1, upper_c = 2, lower_c = 3 };

/// The number of the line of the kind's letter through the point.
std::uint64_t line_key(LineKind kind, const Letters& through);

/// What determines the word of an edge.
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

/// Where the contested segment of the edge begins, its middle one (q); it runs down from there.
Letters middle_start(const Word& word, const Letters& tail,
                     const std::array<std::int32_t, 3>& lengths);
Piece middle_piece(const Word& word, bool red, const Letters& start, std::int32_t length);

/// The whole line on which a green edge arrives at a vertex (letter c at type 0, b at type 1).
Piece arrival_line(Site head);

/// Appends the five bends from tail to head.
void append_bends_of(const Word& word, const Letters& tail,
                     const std::array<std::int32_t, 3>& lengths, std::vector<Point>& out);

}  // namespace ar3d::compact
