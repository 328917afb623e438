// Widths of coordinates and of predicates: what the theorems' bounds prove, and what drawings need.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../inputs.h"
#include "ar3d/algorithms/catalog.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/coordinate_width.h"
#include "ar3d/verify/metrics/metrics.h"
#include "precision.h"

namespace ar3d::precision {
namespace {

constexpr std::uint64_t kLargestN = 4294967295;

Drawing random_drawing(const Algorithm& algorithm, std::uint64_t n) {
  return draw(algorithm, generate(kernels::random_family(algorithm), n, 1));
}

std::int64_t extent_of(const Drawing& drawing) {
  const auto extents = measure(drawing).box.extents();
  return *std::max_element(extents.begin(), extents.end());
}

/// Extrapolated from a drawing by the order of its largest bound.
double actual_n(const Algorithm& algorithm, std::uint64_t n, double extent, double limit) {
  unsigned half_power = 0;
  for (const AxisBound& axis : algorithm.guarantee.bound.axes) {
    half_power = std::max(half_power, axis.half_power);
  }
  return static_cast<double>(n) * std::pow(limit / extent, 2.0 / half_power);
}

}  // namespace

void width_tables() {
  std::vector<std::vector<std::string>> widths, bits;
  for (const char* name : {"diamond", "two-bend", "grid", "compact", "compact-120"}) {
    const Algorithm* const algorithm = &find_algorithm(name);
    constexpr std::uint64_t kDrawn = 10000;
    const Drawing drawing = random_drawing(*algorithm, kDrawn);
    const auto extent = static_cast<double>(extent_of(drawing));
    std::vector<std::string> row{fmt::format("`{}`", algorithm->name)};
    for (const int width : {16, 32, 64}) {
      const double limit = std::ldexp(1, width - 1) - 1;
      const std::uint64_t proved = proved_n(algorithm->guarantee.bound, width);
      row.push_back(proved == kLargestN ? "all" : fmt::format("{}", proved));
      const double actual = actual_n(*algorithm, kDrawn, extent, limit);
      row.push_back(actual >= static_cast<double>(kLargestN) ? "all"
                                                             : fmt::format("{:.2g}", actual));
    }
    widths.push_back(std::move(row));
    for (const std::uint64_t n : {100u, 1000u, 10000u, 100000u}) {
      const Decisions decisions =
          decisions_of(random_drawing(*algorithm, n), algorithm->guarantee, 1);
      bits.push_back({fmt::format("`{}`", algorithm->name), fmt::format("{}", n),
                      fmt::format("{}", decisions.bits.angle),
                      fmt::format("{}", decisions.bits.meeting),
                      fmt::format("{}", decisions.bits.height)});
    }
  }
  fmt::print(
      "Largest n whose extents fit, by the theorem's bound (proved) and extrapolated from a "
      "random graph with 10^4 vertices (drawn):\n\n");
  print_table(
      {"algorithm", "int16 proved", "drawn", "int32 proved", "drawn", "int64 proved", "drawn"},
      widths);
  fmt::print(
      "Bits that the predicates of a drawing need (random graphs; double holds 53, int64 63, "
      "int128 127):\n\n");
  print_table({"algorithm", "n", "angle", "meeting", "height"}, bits);
}

}  // namespace ar3d::precision
