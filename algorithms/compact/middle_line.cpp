// The constants of the words' middle lines. Lengths, forms and heights are affine functions of the
// coordinates of the two ends, so the constants are what two ends at the origin have (Lemma C.4 is
// about their residues). Cost: O(1) for each of the words, once per strip.
#include "ar3d/algorithms/compact/middle_line.h"

namespace ar3d::compact {

WordTable::WordTable() {
  for (unsigned bits = 0; bits < 16; ++bits) {
    Shape shape{(bits & 8) != 0, (bits & 4) != 0 ? 1 : 0, (bits & 2) != 0 ? 1 : 0, (bits & 1) != 0,
                0};
    for (; shape.variant < variants(shape.red); ++shape.variant) {
      const Word word = word_of(shape);
      const Letters origin{};
      const auto length = long_lengths(word, origin, origin);
      const Letters start = middle_start(word, origin, length);
      const Letter other = !shape.red && word.long_letter[1] == kB ? kC : kB;
      constants_[index(shape.red, shape.tail_type, shape.head_type, shape.right) + shape.variant] =
          {length, start[kA] - start[kD], start[other] - start[kD], height(start)};
    }
  }
}

}  // namespace ar3d::compact
