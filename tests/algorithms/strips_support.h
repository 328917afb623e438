#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "ar3d/algorithms/compact/compact.h"
#include "ar3d/algorithms/compact/fill.h"
#include "ar3d/algorithms/compact_120/compact_120.h"
#include "ar3d/algorithms/compact_120/fill.h"
#include "ar3d/verify/certificate.h"
#include "support/counters.h"
#include "support/graphs.h"

namespace ar3d::testing {

/// An algorithm that fills strips: `compact` or `compact-120`.
struct StripAlgorithm {
  std::string name;   ///< in the catalogue
  std::string suite;  ///< in names of tests
  Algorithm row;
  std::string regular;  ///< random graphs that are hardest for it
  std::string small_union;
  std::vector<Graph> extremes;  ///< the densest graphs of its degree
  Drawing (*draw)(const Graph& graph, int effort);
  Drawing (*draw_from)(const Graph& graph, const strips::Tightness& first);
  /// In the proof's zones with all cells tried in turn, without random ones.
  Drawing (*draw_by_scans)(const Graph& graph);
  strips::Tightness too_tight;  ///< no strip that begins so can be filled
  double volume_per_n_1_5;      ///< more than random regular graphs take
  /// Of its random graph with 300 vertices and seed 2, by effort: recorded with g++ 12.2, the same
  /// with every compiler and on every machine.
  std::array<std::string, 2> hashes;
  std::uint32_t max_degree() const { return row.guarantee.max_degree; }
};

inline Drawing compact_zones_by_scans(const Graph& graph) {
  const compact::Decomposition links = compact::decompose(graph);
  compact::Census census;
  const auto strip = compact::fill_zones(graph, links, RandomStream(1), census, false);
  Drawing drawing = compact::lift(graph, links, strip);
  drawing.counters = {{"scans", census.scans}};
  drawing.instance_bound = compact::box_of(strip.size);
  return drawing;
}

inline const StripAlgorithm& compact_strips() {
  static const StripAlgorithm algorithm = {
      .name = "compact",
      .suite = "Compact",
      .row = compact::row(),
      .regular = "random-4-regular",
      .small_union = "union-k5",
      .extremes = {Graph(5, {{2, 0}, {2, 1}, {2, 3}, {2, 4}}), complete(5), octahedron()},
      .draw = [](const Graph& graph,
                 int effort) { return compact::draw(graph, {.effort = effort}); },
      .draw_from = [](const Graph& graph,
                      const strips::Tightness& first) { return compact::draw_from(graph, first); },
      .draw_by_scans = compact_zones_by_scans,
      .too_tight = {.cells = 25, .rows = 60},
      .volume_per_n_1_5 = 8000,
      .hashes = {"d813043e7bd7b2317bffc5277acc45af", "aabf22af98398fd3928258bf767b90b6"}};
  return algorithm;
}

inline Drawing compact_120_zones_by_scans(const Graph& graph) {
  const compact_120::Order order = compact_120::moved_order(graph);
  const compact_120::Links links =
      compact_120::assign_arms(graph, order, compact_120::choose_owners(graph, order));
  compact_120::Census census;
  const auto strip = compact_120::fill_zones(compact_120::in_levels(graph, order), links,
                                             graph.num_edges(), RandomStream(1), census, false);
  Drawing drawing = compact_120::lift(graph, strip);
  drawing.counters = {{"scans", census.scans}};
  drawing.instance_bound = compact_120::box_of(strip.size());
  return drawing;
}

inline const StripAlgorithm& compact_120_strips() {
  static const StripAlgorithm algorithm = {
      .name = "compact-120",
      .suite = "Compact120",
      .row = compact_120::row(),
      .regular = "random-cubic",
      .small_union = "union-k4",
      .extremes = {Graph(4, {{2, 0}, {2, 1}, {2, 3}}), complete(4), petersen()},
      .draw = [](const Graph& graph,
                 int effort) { return compact_120::draw(graph, {.effort = effort}); },
      .draw_from =
          [](const Graph& graph, const strips::Tightness& first) {
            return compact_120::draw_from(graph, first);
          },
      .draw_by_scans = compact_120_zones_by_scans,
      .too_tight = {.cells = 10, .rows = 60, .extra_columns = 0},
      .volume_per_n_1_5 = 3000,
      .hashes = {"1a12a894c58eb1e68964dcc9748b9916", "710a4ec6aaa310ae2e5a9453063e3974"}};
  return algorithm;
}

/// One for each effort.
inline constexpr int kStripEfforts[] = {0, 1, 2};

/// Empty if the drawing is proved right, has five bends on every edge and keeps the theorem's box
/// and that of its own strip; else what is wrong.
inline std::string strip_fault(const StripAlgorithm& algorithm, const Graph& graph,
                               const Drawing& drawing) {
  const CrossingTest test =
      graph.num_vertices() <= 100 ? CrossingTest::all_pairs : CrossingTest::automatic;
  const Guarantee& guarantee = algorithm.row.guarantee;
  const Certificate certificate = certify(graph, drawing, guarantee, {.crossing_test = test});
  if (!certificate.valid()) return certificate.violations[0].message;
  std::vector<Point> points;
  for (EdgeId e = 0; e < drawing.num_edges(); ++e) {
    drawing.polyline(e, points);
    if (points.size() != 7) return "not five bends";
  }
  if (graph.num_vertices() == 0) return "";
  if (!drawing.instance_bound) return "no bound of its own";
  const auto extents = certificate.box.extents();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (extents[axis] > (*drawing.instance_bound)[axis]) return "passes the box of its strip";
  }
  if (!guarantee.bound.holds(*drawing.instance_bound, graph.num_vertices())) {
    return "the strip's box passes the theorem's";
  }
  return "";
}

/// Likewise of all efforts, naming the effort.
inline std::string strip_fault(const StripAlgorithm& algorithm, const Graph& graph) {
  for (const int effort : kStripEfforts) {
    const std::string fault = strip_fault(algorithm, graph, algorithm.draw(graph, effort));
    if (!fault.empty()) return "effort " + std::to_string(effort) + ": " + fault;
  }
  return "";
}

/// Expects that the proof's zones keep the theorem's box for graphs of every size, with 1 to `most`
/// zones, which are as large as each other or as different as can be.
/// @param size_of  of the strip with zones of these sizes. @param dense  below it, every n.
template <class SizeOf, class BoxOf>
void expect_zones_fit(const StripAlgorithm& algorithm, std::int64_t most, std::int64_t dense,
                      SizeOf size_of, BoxOf box_of) {
  RandomStream random(3);
  for (std::int64_t n = 1; n <= std::int64_t{compact::kMaxVertices};) {
    for (std::int64_t zones = 1; zones <= std::min(most, n); zones += 1 + zones / 8) {
      for (const bool even : {true, false}) {
        std::vector<std::int64_t> sizes(static_cast<std::size_t>(zones), even ? n / zones : 1);
        sizes[0] = n - (zones - 1) * sizes.back();
        EXPECT_TRUE(algorithm.row.guarantee.bound.holds(box_of(size_of(sizes, n)),
                                                        static_cast<std::uint64_t>(n)))
            << n << " vertices, " << zones << " zones";
      }
    }
    n = n < dense ? n + 1 : n + n / 50 + random.below(7);
  }
}

/// Expects that no more of the sites of v's zone are closed than the proof counts, and fewer than
/// there are; places v at the first one that is open.
template <class Strip, class Site>
void expect_few_closed(Strip& strip, Vertex v, const std::vector<Site>& sites, std::int64_t most) {
  std::vector<Site> open;
  std::ranges::copy_if(sites, std::back_inserter(open),
                       [&](const Site& site) { return strip.fits(v, site); });
  ASSERT_LE(static_cast<std::int64_t>(sites.size() - open.size()), most);
  ASSERT_GT(static_cast<std::int64_t>(sites.size()), most);
  ASSERT_TRUE(strip.try_place(v, open.at(0)));
}

/// Tests of both algorithms, each named after it.
class Strips : public ::testing::TestWithParam<const StripAlgorithm*> {
 protected:
  const StripAlgorithm& algorithm() const { return *GetParam(); }
};
inline const auto kBothStripAlgorithms =
    ::testing::Values(&compact_strips(), &compact_120_strips());
inline const auto kStripSuite = [](const ::testing::TestParamInfo<const StripAlgorithm*>& info) {
  return info.param->suite;
};

}  // namespace ar3d::testing
