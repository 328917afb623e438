// The table of words (docs/compact-120.md, "The edges") and what follows from it: forced long
// lengths, the middle line, the five bends. That lines of different letters never meet (Lemmas D.4
// and D.5) is a matter of this table and of the places of the classes alone. O(1) each.
#include "ar3d/algorithms/compact_120/strip.h"

namespace ar3d::compact_120 {
namespace {

constexpr UnitStep kD01{0, 1}, kD02{0, 2}, kD10{1, 0}, kD21{2, 1}, kD30{3, 0}, kD31{3, 1},
    kD32{3, 2};

constexpr Word kAt12 = {kD01, kD31, kD32, kD30, kD31, kD21};
constexpr Word kAt12Other = {kD01, kD02, kD32, kD30, kD31, kD21};
constexpr Word kAt20 = {kD01, kD21, kD31, kD30, kD32, kD02};
constexpr Word kAt01 = {kD01, kD02, kD32, kD31, kD30, kD10};

}  // namespace

const Word& right_word(Arrival at, unsigned variant) {
  if (at == Arrival::on_20) return kAt20;
  if (at == Arrival::on_01) return kAt01;
  return at == Arrival::on_12 && variant == 0 ? kAt12 : kAt12Other;
}

Word word_of(const Shape& shape) {
  if (shape.right) return right_word(shape.at, shape.variant);
  Word word = right_word(mirrored(shape.at), shape.variant);
  for (UnitStep& direction : word) direction = mirrored(direction);
  return word;
}

Route::Route(const Shape& shape, const Quad& tail, const Quad& head)
    : word_(&right_word(shape.right ? shape.at : mirrored(shape.at), shape.variant)),
      right_(shape.right),
      tail_(shape.right ? tail : mirrored(tail)) {
  const Quad at_head = shape.right ? head : mirrored(head);
  Quad delta{};
  for (std::size_t i = 0; i < 4; ++i) delta[i] = at_head[i] - tail_[i];
  for (const std::size_t s : {1u, 3u, 5u}) step(delta, (*word_)[s], -1);
  // p = 01, and q and r are two of 32, 31, 30: x2 is lost along 32 alone, and 0 + 1 along 31 or 30.
  const std::int32_t by_32 = -delta[2];
  const std::int32_t by_other = -(delta[0] + delta[1]);
  const bool ends_along_30 = (*word_)[4] == kD30;
  lengths_[0] = ends_along_30 ? -delta[1] : delta[0];
  lengths_[1] = (*word_)[2] == kD32 ? by_32 : by_other;
  lengths_[2] = (*word_)[2] == kD32 ? by_other : by_32;
}

Piece Route::middle() const {
  Quad at = tail_;
  step(at, (*word_)[0], lengths_[0]);
  step(at, (*word_)[1], 1);
  const bool along_32 = (*word_)[2] == kD32;
  const unsigned kind = (right_ ? 0u : 2u) + (along_32 ? 0u : 1u);
  return {strips::line_key(kind, at[0], along_32 ? at[1] : at[2]), at[3], at[3] + lengths_[1]};
}

void Route::append_bends(std::vector<Point>& out) const {
  Quad at = tail_;
  for (std::size_t i = 0; i < 5; ++i) {
    step(at, (*word_)[i], i % 2 == 0 ? lengths_[i / 2] : 1);
    out.push_back(to_point(right_ ? at : mirrored(at)));
  }
}

}  // namespace ar3d::compact_120
