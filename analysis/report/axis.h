#pragma once

#include <string>
#include <vector>

namespace ar3d::report {

/// What the ticks of a logarithmic axis count.
enum class TickStyle {
  count,    ///< 200, 1k, 10k, 1M
  power,    ///< 10⁶, 10⁹
  seconds,  ///< 10 µs, 1 ms, 1 s
};

struct Tick {
  double log10 = 0;
  std::string label;  ///< empty: a minor tick
};

/// A logarithmic axis from data to pixels. Values are decimal logarithms throughout.
class LogAxis {
 public:
  /// Covers [low, high] with a little air; a range of no width is opened to half a decade either
  /// way.
  LogAxis(double low, double high, double first_pixel, double last_pixel);

  double pixel(double log10) const;
  double low() const { return low_; }
  double high() const { return high_; }
  /// At most about `most` labelled ticks: decades (every k-th if there are many), else 1-2-5 within
  /// a decade, else numbers of two digits.
  std::vector<Tick> ticks(TickStyle style, int most) const;

 private:
  /// Numbers of two digits; none if they would be more than `most`.
  std::vector<Tick> narrow_ticks(TickStyle style, int most) const;

  double low_;
  double high_;
  double first_pixel_;
  double last_pixel_;
};

}  // namespace ar3d::report
