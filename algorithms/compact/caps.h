#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ar3d/algorithms/compact/words.h"

namespace ar3d::compact {

/// The cap rule of the size bound's proof: of every family of contested lines (green by q and the
/// tail's letter, red to the right, red to the left) at most T + 1 have one value of the form that
/// neither their tail nor their head fixes. No more than (edges of the colour) / T values are ever
/// closed.
class Caps {
 public:
  /// @param widest  bound on the absolute value of the forms.
  Caps(std::int32_t cap, std::int32_t widest)
      : cap_(cap), widest_(widest), counts_(kFamilies * width()) {}

  /// False if the value of this edge is closed. @param on_line  a point of its middle line.
  bool is_open(const Shape& shape, const Letters& on_line) const {
    return counts_[index(shape, on_line)] < cap_;
  }
  void add(const Shape& shape, const Letters& on_line) { ++counts_[index(shape, on_line)]; }

 private:
  static constexpr std::size_t kFamilies = 6;
  std::size_t width() const { return 2 * static_cast<std::size_t>(widest_) + 1; }
  std::size_t index(const Shape& shape, const Letters& on_line) const;

  std::int32_t cap_;
  std::int32_t widest_;
  std::vector<std::int32_t> counts_;
};

}  // namespace ar3d::compact
