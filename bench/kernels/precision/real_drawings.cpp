// Drawings of two-bend-paper in real types where they are hardest: deep nests of figures, and far
// from the origin. What the condition of the drawing in 237 bits predicts, and what is seen.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "ar3d/algorithms/two_bend_paper/two_bend_paper.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/model/real_points.h"
#include "ar3d/verify/assessment/real_assessment.h"
#include "precision.h"

namespace ar3d::precision {
namespace {

/// The real types whose misses are predicted, with the bits of their significands, in the order of
/// two_bend_paper::RealType.
constexpr std::array<std::pair<const char*, int>, 3> kMeasuredTypes = {
    {{"float", 24}, {"double", 53}, {"binary80", 64}}};

/// A miss is kappa 2^-p C radians. Over one graph of each family half of all kappas are above the
/// first, nine in ten below the second; docs/precision.md has those of several graphs.
constexpr double kMedianKappa = 0.15, kHighKappa = 0.53;
constexpr double kDegrees = 57.29577951308232;  ///< in a radian

/// Degrees. @param condition  RealAssessment::condition. @param bits  of the significand.
double predicted_miss(double condition, int bits, double kappa) {
  return kappa * kDegrees * std::ldexp(condition, -bits);
}

using boost::multiprecision::abs;
using boost::multiprecision::msb;

BigInteger rounded(const BigInteger& value, int bits) {
  const BigInteger size = abs(value);
  if (size == 0) return value;
  const int drop = static_cast<int>(msb(size)) + 1 - bits;
  if (drop <= 0) return value;
  const BigInteger half = BigInteger(1) << (drop - 1);
  const BigInteger result = ((size + half) >> drop) << drop;
  return value < 0 ? BigInteger(-result) : result;
}

/// The points with every coordinate rounded once to so many significant bits, to the nearest,
/// halves away from 0: what a type of those bits makes of a drawing that is computed in a wider
/// one. @pre bits > 0.
RealPoints in_bits(RealPoints points, int bits) {
  for (std::vector<BigPoint>* list : {&points.vertices, &points.bends}) {
    for (BigPoint& p : *list) p = {rounded(p.x, bits), rounded(p.y, bits), rounded(p.z, bits)};
  }
  return points;
}

using two_bend_paper::RealType;

constexpr std::array<double, 4> kLimits = {1e-9, 1e-6, 1e-2, 1};

/// The graph with a triangle in place of its vertex 0, and of a corner of that again and again. A
/// corner of a triangle that stands for a vertex of degree 3 has degree 3, so hexagons are nested;
/// one that stands for a vertex of degree 2 leaves two corners of degree 3 and a last one of degree
/// 2, in which heptagons go on. @param heptagons  levels that go on in a last corner.
Graph nest(const Graph& graph, int levels, int heptagons) {
  auto size = static_cast<Vertex>(graph.num_vertices());
  std::vector<Edge> edges(graph.edges().begin(), graph.edges().end());
  Vertex v = 0;
  for (int level = 0; level < levels; ++level) {
    const std::array<Vertex, 3> corners = {v, size, size + 1};
    size += 2;
    std::size_t next = 0;
    for (Edge& e : edges) {  // the edges at v go to the corners, one to each
      if (e.u == v || e.v == v) (e.u == v ? e.u : e.v) = corners.at(next++);
    }
    for (std::size_t i = 0; i < 3; ++i) edges.push_back({corners[i], corners[(i + 1) % 3]});
    v = corners[level < heptagons ? 2 : 0];
  }
  return {size, std::move(edges)};
}

Graph cube() {
  std::vector<Edge> edges;
  for (Vertex v = 0; v < 8; ++v) {
    for (const Vertex axis : {1u, 2u, 4u}) {
      if ((v & axis) == 0) edges.push_back({v, v | axis});
    }
  }
  return {8, std::move(edges)};
}

/// One of a series of drawings that gets harder.
struct HardDrawing {
  double condition = 0;                                     ///< in 237 bits
  std::array<RealAssessment, kMeasuredTypes.size()> found;  ///< by type
};

/// By depth. @param heptagons  how many of so many levels go on in a last corner.
template <class Heptagons>
std::vector<HardDrawing> nests_of(const Graph& core, int most, Heptagons&& heptagons) {
  std::vector<HardDrawing> nests(static_cast<std::size_t>(most) + 1);
  for (int level = 0; level <= most; ++level) {
    const Graph graph = nest(core, level, heptagons(level));
    HardDrawing& one = nests[static_cast<std::size_t>(level)];
    one.condition = assess(graph, two_bend_paper::draw_real(graph, RealType::reference)).condition;
    for (std::size_t t = 0; t < kMeasuredTypes.size(); ++t) {
      one.found[t] = assess(graph, two_bend_paper::draw_real(graph, static_cast<RealType>(t)));
    }
  }
  return nests;
}

/// Where each type passes each limit, predicted with kHighKappa and kMedianKappa, and seen, and
/// where it breaks: rows of texts.
/// @param text  of a place in the series; of -1: there is none.
/// @param skips_plain  without what passes a limit at once, or never, as predicted.
template <class Text>
std::vector<std::vector<std::string>> hard_rows(const std::vector<HardDrawing>& all,
                                                const Text& text, bool skips_plain) {
  const auto first = [&](const auto& holds) {
    const auto at = std::find_if(all.begin(), all.end(), holds);
    return at == all.end() ? -1 : static_cast<int>(at - all.begin());
  };
  std::vector<std::vector<std::string>> rows;
  for (std::size_t t = 0; t < kMeasuredTypes.size(); ++t) {
    const auto& [name, bits] = kMeasuredTypes[t];
    for (const double limit : kLimits) {
      const auto predicted = [&, p = bits](double kappa) {
        return first([&](const HardDrawing& one) {
          return predicted_miss(one.condition, p, kappa) > limit;
        });
      };
      const int early = predicted(kHighKappa), late = predicted(kMedianKappa);
      const int seen =
          first([&](const HardDrawing& one) { return one.found[t].largest_miss > limit; });
      if (skips_plain && seen == late && seen <= 0) continue;
      rows.push_back({name, fmt::format("{:g}", limit),
                      early == late ? text(late) : text(early) + " to " + text(late), text(seen)});
    }
    const int broken = first([&](const HardDrawing& one) { return one.found[t].is_broken(); });
    rows.push_back({name, "broken", "", text(broken)});
  }
  return rows;
}

void add_rows(const std::string& name, const std::vector<HardDrawing>& nests,
              std::vector<std::vector<std::string>>& rows) {
  const auto depth = [&](int at) {
    return at < 0 ? fmt::format("> {}", nests.size() - 1) : fmt::format("{}", at);
  };
  for (std::vector<std::string>& row : hard_rows(nests, depth, true)) {
    row.insert(row.begin(), name);
    rows.push_back(std::move(row));
  }
}

constexpr int kLargestShift = 60;

RealPoints shifted(RealPoints points, int j) {
  const BigInteger move = BigInteger(1) << (j - points.unit_exponent);
  for (std::vector<BigPoint>* list : {&points.vertices, &points.bends}) {
    for (BigPoint& p : *list) {
      p.x += move;
      p.y += move;
    }
  }
  return points;
}

std::string power(int j) { return j < 0 ? "-" : fmt::format("2^{}", j); }

/// Moved by 2^0 to 2^kLargestShift.
std::vector<HardDrawing> moved_away(const Graph& graph) {
  const RealPoints drawing = two_bend_paper::draw_real(graph, RealType::reference);
  std::vector<HardDrawing> all;
  for (int j = 0; j <= kLargestShift; ++j) {
    const RealPoints moved = shifted(drawing, j);
    HardDrawing seen;
    seen.condition = assess(graph, moved).condition;
    for (std::size_t t = 0; t < kMeasuredTypes.size(); ++t) {
      seen.found[t] = assess(graph, in_bits(moved, kMeasuredTypes[t].second));
    }
    all.push_back(std::move(seen));
  }
  return all;
}

}  // namespace

void nest_table(int most) {
  const auto half = [](int levels) { return levels / 2; };
  const auto all = [](int levels) { return levels; };
  const Graph cycle(5, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {0, 4}});
  const Graph random = generate(find_family("random-cubic"), 100, 1);
  std::vector<std::vector<std::string>> rows;
  add_rows("hexagons in K4", nests_of(generate(find_family("union-k4"), 4, 1), most, all), rows);
  add_rows("hexagons in the cube", nests_of(cube(), most, all), rows);
  add_rows("hexagons in a random cubic graph, n = 100", nests_of(random, most, all), rows);
  add_rows("heptagons in C5", nests_of(cycle, most, all), rows);
  add_rows("heptagons, then as many hexagons, in C5", nests_of(cycle, most, half), rows);
  fmt::print(
      "The least depth of a nest at which a drawing misses by more than a limit, predicted with "
      "kappa from {} to {}, and seen, up to depth {}:\n\n",
      kHighKappa, kMedianKappa, most);
  print_table({"nest", "type", "degrees", "predicted", "seen"}, rows);
}

void shift_tables() {
  const std::vector<HardDrawing> all = moved_away(generate(find_family("random-cubic"), 100, 1));
  std::vector<std::vector<std::string>> misses;
  for (std::size_t j = 0; j < all.size(); j += 5) {
    std::vector<std::string> row{fmt::format("2^{}", j),
                                 fmt::format("{:.1f}", std::log2(all[j].condition))};
    for (const RealAssessment& found : all[j].found) {
      row.push_back(
          fmt::format("{:.2g}{}", found.largest_miss, found.is_broken() ? " broken" : ""));
    }
    misses.push_back(std::move(row));
  }
  fmt::print(
      "Largest miss in degrees, random cubic graph with 100 vertices, moved and rounded:\n\n");
  print_table({"moved by", "log2 C", "float", "double", "binary80"}, misses);
  fmt::print(
      "The first move with which the drawing misses by more than a limit, predicted with kappa "
      "from {} to {}, and seen:\n\n",
      kHighKappa, kMedianKappa);
  print_table({"type", "degrees", "predicted", "seen"}, hard_rows(all, power, false));
}

}  // namespace ar3d::precision
