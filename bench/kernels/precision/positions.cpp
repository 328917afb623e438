// Positions in integers of each width: bytes, and what they cost whoever reads the drawing.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/bench/measure/stopwatch.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/certificate.h"
#include "tables.h"

namespace ar3d::precision {
namespace {

constexpr int kRounds = 7;
constexpr std::array<int, 3> kWidths = {16, 32, 64};
constexpr std::uint64_t kMostCertified = 100000;

/// The largest coordinate that is stored in so many bits.
std::int64_t largest(int bits) {
  return bits == 64 ? kMaxCoordinate : (std::int64_t{1} << (bits - 1)) - 1;
}

/// The drawing with its positions in integers of that width.
Drawing in_width(const Drawing& drawing, int bits) {
  Coordinates positions(drawing.num_vertices(), largest(bits));
  for (Vertex v = 0; v < drawing.num_vertices(); ++v) positions.set(v, drawing.vertex(v));
  return {drawing.algorithm(), drawing.lattice(), std::move(positions), drawing.shared_edges(),
          drawing.shared_bends()};
}

/// Least CPU time of several rounds in turns, by width.
struct Times {
  std::array<double, 3> reading{}, certifying{};
};

Times times_of(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee) {
  Times times;
  times.reading.fill(std::numeric_limits<double>::infinity());
  times.certifying = times.reading;
  std::vector<Drawing> drawings;
  for (const int bits : kWidths) drawings.push_back(in_width(drawing, bits));
  GrowingBox box;  // of the ends that were read
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i < kWidths.size(); ++i) {
      const CpuStopwatch time;
      for_each_polyline(drawings[i], [&](EdgeId, const std::vector<Point>& points) {
        box.add(points.front());
        box.add(points.back());
      });
      times.reading[i] = std::min(times.reading[i], time.cpu_s());
      if (graph.num_vertices() > kMostCertified) continue;
      const CpuStopwatch proof;
      expect(certify(graph, drawings[i], guarantee).valid(), "a right drawing");
      times.certifying[i] = std::min(times.certifying[i], proof.cpu_s());
    }
  }
  expect(box.low().x < box.high().x, "points were read");
  return times;
}

}  // namespace

void position_table(std::uint64_t most) {
  const Algorithm& algorithm = find_algorithm("compact");  // the smallest coordinates
  std::vector<std::vector<std::string>> rows;
  for (const std::uint64_t n : {1800u, 100000u, 1000000u}) {
    if (n > most) break;
    const Graph graph = generate(find_family("random-4-regular"), n, 1);
    const Times times = times_of(graph, draw(algorithm, graph), algorithm.guarantee);
    const double per_vertex = 1e9 / static_cast<double>(n);
    for (std::size_t i = 0; i < kWidths.size(); ++i) {
      rows.push_back(
          {fmt::format("{}", n), fmt::format("int{}", kWidths[i]),
           fmt::format("{}", Coordinates(1, largest(kWidths[i])).bytes_per_point()),
           fmt::format("{:.1f}", times.reading[i] * per_vertex),
           n > kMostCertified ? "-" : fmt::format("{:.0f}", times.certifying[i] * per_vertex)});
    }
  }
  fmt::print(
      "`{}`, random 4-regular graphs, positions stored in each width: bytes per vertex, and CPU "
      "time in ns per vertex of making all polylines and of certifying, least of {} rounds in "
      "turns:\n\n",
      algorithm.name, kRounds);
  print_table({"n", "width", "bytes", "polylines", "certifying"}, rows);
}

}  // namespace ar3d::precision
