// Lemma 2.12: how a SINK, and by reflection a SOURCE, is reached by its two leans. All angles are
// compared in 128-bit integers. The ordinary rounds try every b; the safe layout knows it. Cost: a
// greatest common divisor per b tried, of which there are fewer than half of the gap of the hold.
#include "ar3d/algorithms/two_bend/leans.h"

#include <cstdlib>

namespace ar3d::two_bend {
namespace {

__extension__ using Int128 = __int128;

/// The lean's run towards the special edge's side and its run towards the special row.
std::pair<std::int64_t, std::int64_t> reach_of(const PoleShape& shape, const ViewValues& values,
                                               NodeId from, std::int64_t b) {
  return {std::abs(shape.cross - values.cross[from]) - b,
          std::abs(values.own[from] - shape.own) - 2 * b};
}

/// Places the SINK; the leans still have no b.
PoleShape frame_of(const View& view, const ViewValues& values, const Pole& sink) {
  PoleShape shape;
  const auto [c, w] = view.ordinary_of(sink);
  shape.own = values.own[view.hold_of(sink)];
  shape.special_cross = sink.a_type ? values.cross[sink.node] : values.cross[sink.special];
  const auto [low, high] = std::minmax(values.cross[c], values.cross[w]);
  expect(shape.special_cross < low || shape.special_cross > high,
         "the special edge of a SINK stands outside its ordinary ones");
  shape.cross = shape.special_cross > high ? high : low;
  shape.sign = shape.special_cross > high ? 1 : -1;
  const bool c_is_up = values.own[c] > shape.own;
  expect(c_is_up != (values.own[w] > shape.own),
         "the special row of a SINK is between its ordinary ones");
  shape.up.from = c_is_up ? c : w;
  shape.down.from = c_is_up ? w : c;
  return shape;
}

void set_lean(PoleShape& shape, PoleLean& lean, const ViewValues& values, std::int64_t b) {
  const auto [e, y] = reach_of(shape, values, lean.from, b);
  lean.b = b;
  lean.height = lean_height(std::abs(e), y);
}

}  // namespace

/// Travel directions l = (e, y, h) and (1, 2, -1) in the metric 3, 3, 1: <l, a> = 3e + 6y - h, <a,
/// a> = 16, and a turn of at most 60 degrees is <l, a> > 0 with 4 <l, a>^2 >= 16 <l, l>.
bool lean_turns(std::int64_t e, std::int64_t y) {
  if (y < 1) return false;
  const std::int64_t h = lean_height(std::abs(e), y);
  const std::int64_t inner = 3 * e + 6 * y - h;
  const Int128 square = Int128(inner) * inner;
  const Int128 length = 3 * Int128(e) * e + 3 * Int128(y) * y + Int128(h) * h;
  return inner > 0 && square >= 4 * length;
}

bool lean_fits(std::int64_t e, std::int64_t y) {
  return y >= 1 && std::gcd(e, y) == 1 && lean_turns(e, y);
}

std::optional<PoleShape> fit_pole(const View& view, const ViewValues& values, const Pole& sink,
                                  std::int64_t gap) {
  PoleShape shape = frame_of(view, values, sink);
  for (PoleLean* lean : {&shape.up, &shape.down}) {
    for (std::int64_t b = 1; 2 * b <= gap - 1 && lean->b == 0; ++b) {
      const auto [e, y] = reach_of(shape, values, lean->from, b);
      if (lean_fits(e, y)) set_lean(shape, *lean, values, b);
    }
    if (lean->b == 0) return std::nullopt;
  }
  return shape;
}

PoleShape safe_pole(const View& view, const ViewValues& values, const Pole& sink,
                    std::int64_t far_b, bool alone) {
  PoleShape shape = frame_of(view, values, sink);
  for (PoleLean* lean : {&shape.up, &shape.down}) {
    const std::int64_t b = values.cross[lean->from] == shape.cross ? 1 : far_b;
    const auto [e, y] = reach_of(shape, values, lean->from, b);
    expect(alone ? lean_turns(e, y) : lean_fits(e, y), "the leans of a safe layout fit");
    set_lean(shape, *lean, values, b);
  }
  return shape;
}

}  // namespace ar3d::two_bend
