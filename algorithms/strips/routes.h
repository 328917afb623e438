#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "ar3d/algorithms/algorithm.h"
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

/// Bends that follow from the places of the two ends and the edge's byte, computed when something
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

inline constexpr int kHighestEffort = 2;

/// Returns how narrow the first strip is at efforts 1 and 2; nothing: the zones of the proof at
/// once.
/// @throws InputError naming the algorithm if there is no such effort.
inline std::optional<Tightness> first_tightness(const char* algorithm, int effort,
                                                const std::array<Tightness, 2>& narrow) {
  check_effort(algorithm, effort, kHighestEffort);
  if (effort == 0) return std::nullopt;
  return narrow[static_cast<std::size_t>(effort - 1)];
}

/// The catalogue row of an algorithm that fills strips.
template <auto draw>
Algorithm row_of(const char* name, const char* summary, const Guarantee& guarantee) {
  return {
      .name = name,
      .summary = summary,
      .source = "the paper's last open question",
      .guarantee = guarantee,
      .options = {effort_option(
          kHighestEffort,
          "0: the zones of the proof; 1: a narrow strip; 2: a narrower one, several times slower")},
      .draw = draw_with_effort<draw>};
}

}  // namespace ar3d::strips
