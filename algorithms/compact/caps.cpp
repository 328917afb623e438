// The cap rule of Lemma C.7: it keeps any one plane from being crowded, so that few cells are
// closed to a vertex. One number for each family of lines and value of its third form: O(1) per
// question, O(sqrt n) memory. Used in the zones only.
#include "ar3d/algorithms/compact/caps.h"

#include "ar3d/base/error.h"

namespace ar3d::compact {

std::size_t Caps::index(const Shape& shape, const Letters& on_line) const {
  const auto form = [&](Letter x, Letter y) { return on_line[x] - on_line[y]; };
  std::size_t family = 0;
  std::int32_t value = 0;
  if (shape.red) {
    family = shape.right ? 4 : 5;
    value = shape.right ? form(kA, kB) : form(kB, kD);
  } else {
    const bool by_a = shape.tail_type == 0;
    const bool q_is_b = shape.head_type == 0;
    family = (by_a ? 0u : 1u) + (q_is_b ? 0u : 2u);
    value = q_is_b ? (by_a ? form(kA, kC) : form(kC, kD)) : (by_a ? form(kA, kB) : form(kB, kD));
  }
  expect(value >= -widest_ && value <= widest_, "forms keep their width");
  return family * width() + static_cast<std::size_t>(value + widest_);
}

}  // namespace ar3d::compact
