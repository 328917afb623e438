#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "ar3d/algorithms/strips/search.h"
#include "ar3d/model/drawing.h"

namespace ar3d::strips {

/// One byte per edge: whether its tail is its second end, and seven bits that tell its word.
constexpr std::uint8_t code_of(bool backward, unsigned word) {
  return static_cast<std::uint8_t>(word << 1 | (backward ? 1u : 0u));
}

/// The counters that all strips have; an algorithm adds its own.
inline std::vector<Counter> counters_of(const Census& census, bool in_zones, std::int64_t columns,
                                        std::int64_t rows) {
  return {{"zones", in_zones ? 1 : 0},
          {"widenings", census.widenings},
          {"ejections", census.ejections},
          {"trials", census.trials},
          {"scans", census.scans},
          {"columns", columns},
          {"rows", rows}};
}

/// Bends that follow from the places of the two ends and the edge's byte, computed when somebody
/// reads them. `append` adds those of a word from its tail to its head.
template <void append(unsigned word, const Point& tail, const Point& head, std::vector<Point>& out)>
class CodedBends final : public BendSource {
 public:
  explicit CodedBends(std::vector<std::uint8_t> code) : code_(std::move(code)) {}

  void append_bends(EdgeId e, Edge, Point at_u, Point at_v,
                    std::vector<Point>& out) const override {
    const unsigned word = code_[e] >> 1;
    const auto before = static_cast<std::ptrdiff_t>(out.size());
    if ((code_[e] & 1) == 0) return append(word, at_u, at_v, out);
    append(word, at_v, at_u, out);
    std::reverse(out.begin() + before, out.end());
  }

 private:
  std::vector<std::uint8_t> code_;
};

}  // namespace ar3d::strips
