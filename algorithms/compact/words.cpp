// The words of the edges (docs/compact.md, "The edges") and what follows from them: forced long
// lengths, the middle line, the arrival line, the five bends. Residues modulo 4 (Lemma C.4) are a
// matter of these tables alone. O(1) each.
#include "ar3d/algorithms/compact/words.h"

namespace ar3d::compact {

namespace {

Word green_word(const Shape& shape) {
  Word word;
  const Letter p = shape.tail_type == 0 ? kA : kD;
  const bool to_d = shape.head_type == 0;  // the edge enters the head by letter d, else by a
  const Letter q = to_d ? kB : kC;
  const Letter r = to_d ? kC : kB;
  word.spare = p == kA ? kD : kA;
  word.long_letter = {p, q, r};
  const Letter s1 = (shape.variant & 1) == 0 ? r : word.spare;
  const Letter s2 = ((shape.variant & 2) == 0) == to_d ? kA : kD;
  word.short_letter = {s1, s2, to_d ? kD : kA};
  return word;
}

/// The choices of s1 and s2 give the middle line the residues BD = 2 mod 4, AB odd.
Word red_word(const Shape& shape) {
  Word word;
  const bool same = shape.tail_type == shape.head_type;
  const bool first = shape.variant == 0;
  if (shape.right) {
    word.long_letter = {kB, kC, kA};
    word.spare = kD;
    word.short_letter = {same ? kD : kA, first ? kB : kD, kC};
    word.short_length = {1, 2, 1};
  } else {
    word.long_letter = {kB, kC, kD};
    word.spare = kA;
    word.short_letter = {first ? kA : kD, first == same ? kA : kB, kC};
    word.short_length = {1, 1, 2};
  }
  return word;
}

}  // namespace

std::uint64_t line_key(LineKind kind, const Letters& through) {
  const std::int64_t first = std::int64_t{through[kA]} - through[kD];  // forms are below 2^24
  const std::int64_t second = kind == LineKind::upper_b ? std::int64_t{through[kC]} - through[kD]
                                                        : std::int64_t{through[kB]} - through[kD];
  return strips::line_key(static_cast<unsigned>(kind), first, second);
}

Word word_of(const Shape& shape) { return shape.red ? red_word(shape) : green_word(shape); }

std::array<std::int32_t, 3> long_lengths(const Word& word, const Letters& tail,
                                         const Letters& head) {
  Letters delta{};
  for (std::size_t x = 0; x < 4; ++x) delta[x] = head[x] - tail[x];
  for (std::size_t i = 0; i < 3; ++i) delta[word.short_letter[i]] += word.short_length[i];
  std::array<std::int32_t, 3> lengths{};
  for (std::size_t i = 0; i < 3; ++i) {
    lengths[i] = delta[word.long_letter[i]] - delta[word.spare];
  }
  return lengths;
}

Letters middle_start(const Word& word, const Letters& tail,
                     const std::array<std::int32_t, 3>& lengths) {
  Letters at = tail;
  at[word.long_letter[0]] += lengths[0];
  at[word.short_letter[0]] -= word.short_length[0];
  return at;
}

Piece middle_piece(const Word& word, bool red, const Letters& start, std::int32_t length) {
  const LineKind kind = red                         ? LineKind::lower_c
                        : word.long_letter[1] == kB ? LineKind::upper_b
                                                    : LineKind::upper_c;
  const std::int32_t top = height(start);
  return {line_key(kind, start), top - length, top};
}

Piece arrival_line(Site head) {
  Letters at = letters_of(head);
  at[head.type == 0 ? kD : kA] += 2;
  return strips::whole_line(line_key(head.type == 0 ? LineKind::upper_c : LineKind::upper_b, at));
}

void append_bends_of(const Word& word, const Letters& tail,
                     const std::array<std::int32_t, 3>& lengths, std::vector<Point>& out) {
  Letters at = tail;
  for (std::size_t i = 0; i < 3; ++i) {
    at[word.long_letter[i]] += lengths[i];
    out.push_back(to_point(at));
    if (i == 2) return;
    at[word.short_letter[i]] -= word.short_length[i];
    out.push_back(to_point(at));
  }
}

// The constants of the words' middle lines. Lengths, forms and heights are affine functions of the
// coordinates of the two ends, so the constants are what two ends at the origin have (Lemma C.4 is
// about their residues). Cost: O(1) for each of the words, once per strip.

WordTable word_table() {
  WordTable table;
  for (unsigned bits = 0; bits < 16; ++bits) {
    Shape shape{(bits & 8) != 0, (bits & 4) != 0 ? 1 : 0, (bits & 2) != 0 ? 1 : 0, (bits & 1) != 0,
                0};
    for (; shape.variant < variants(shape.red); ++shape.variant) {
      const Word word = word_of(shape);
      const Letters origin{};
      const auto length = long_lengths(word, origin, origin);
      const Letters start = middle_start(word, origin, length);
      const Letter other = !shape.red && word.long_letter[1] == kB ? kC : kB;
      table[word_index(shape.red, shape.tail_type, shape.head_type, shape.right) + shape.variant] =
          {length, start[kA] - start[kD], start[other] - start[kD], height(start)};
    }
  }
  return table;
}

}  // namespace ar3d::compact
