// Damaged drawings and who notices. A drawing of two disjoint graphs is damaged in one of three
// ways: a bend or a vertex moved by one unit along one axis, which no angle and no direction of a
// right drawing survives, or one of the two graphs shifted as a whole until two points fall
// together, or one unit beside that: then all angles are right and only meetings can be wrong. Each
// also with all coordinates multiplied, so that their bits are those of far larger drawings.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "../inputs.h"
#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/random.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/examination.h"
#include "certificate_modes.h"
#include "precision.h"

namespace ar3d::precision {
namespace {

using Kind = JudgingMode::Kind;

/// A drawing as lists of points that can be changed.
struct Points {
  std::vector<Point> vertices;
  std::vector<Edge> edges;
  std::vector<std::vector<Point>> bends;

  Drawing drawing(const Guarantee& guarantee) const {
    Coordinates places(vertices.size(), kMaxCoordinate);
    for (std::size_t v = 0; v < vertices.size(); ++v) places.set(v, vertices[v]);
    auto stored = std::make_shared<StoredBends>();
    for (const std::vector<Point>& each : bends) stored->add_edge(each);
    return Drawing("damaged", guarantee.lattice, std::move(places),
                   std::make_shared<std::vector<Edge>>(edges), std::move(stored));
  }
  /// Calls change(point) for each point of the vertices from `first` and of their edges.
  template <class Change>
  void change(Vertex first, Change&& change) {
    for (std::size_t v = first; v < vertices.size(); ++v) change(vertices[v]);
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (edges[e].u < first) continue;
      for (Point& bend : bends[e]) change(bend);
    }
  }
};

/// Two copies of a random graph's drawing side by side, numbers of the second from n on.
Points two_copies(const Algorithm& algorithm, std::uint64_t n, std::uint64_t seed, Graph& graph) {
  const Graph one = generate(kernels::random_family(algorithm), n, seed);
  const Drawing drawing = draw(algorithm, one);
  const auto size = static_cast<Vertex>(one.num_vertices());
  const std::int64_t aside = measure(drawing).box.extents()[0] + 2;
  Points points;
  std::vector<Edge> edges;
  for (Vertex copy = 0; copy < 2; ++copy) {
    const Vector move{2 * aside * copy, 0, 0};
    for (Vertex v = 0; v < size; ++v) points.vertices.push_back(drawing.vertex(v) + move);
    for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& polyline) {
      const Edge ends = drawing.edge(e);
      points.edges.push_back({ends.u + copy * size, ends.v + copy * size});
      points.bends.emplace_back();
      for (std::size_t i = 1; i + 1 < polyline.size(); ++i) {
        points.bends.back().push_back(polyline[i] + move);
      }
    });
  }
  edges = points.edges;
  graph = Graph(points.vertices.size(), std::move(edges));
  return points;
}

enum class Damage { none, bend, vertex, shift };
constexpr std::array<std::pair<Damage, const char*>, 4> kDamages = {
    {{Damage::none, "none (false alarms)"},
     {Damage::bend, "a bend moved by 1"},
     {Damage::vertex, "a vertex moved by 1"},
     {Damage::shift, "a graph shifted onto another"}}};

std::int64_t& any_coordinate(Point& p, RandomStream& random) {
  const std::uint32_t axis = random.below(3);
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

Point& any(std::vector<Point>& points, RandomStream& random) {
  return points[random.below(static_cast<std::uint32_t>(points.size()))];
}

std::vector<Point>& any_bends(Points& points, RandomStream& random) {
  for (;;) {
    auto& bends = points.bends[random.below(static_cast<std::uint32_t>(points.bends.size()))];
    if (!bends.empty()) return bends;
  }
}

/// In the plane z = 0 if the vertices are promised there.
void shift(Points& points, const Guarantee& guarantee, RandomStream& random) {
  const auto n = static_cast<Vertex>(points.vertices.size() / 2);
  const auto half = static_cast<std::uint32_t>(points.bends.size() / 2);
  Point onto{}, from{};
  for (bool found = false; !found;) {
    const auto& first = points.bends[random.below(half)];
    const auto& second = points.bends[half + random.below(half)];
    found = !first.empty() && !second.empty();
    if (found) onto = first.front(), from = second.back();
  }
  Vector move = onto - from;
  if (guarantee.vertices_in_plane) move.z = 0;
  if (random.chance(1, 2)) move.x += random.chance(1, 2) ? 1 : -1;
  points.change(n, [&](Point& p) { p = p + move; });
}

void damage(Points& points, Damage kind, const Guarantee& guarantee, RandomStream& random) {
  const std::int64_t step = random.chance(1, 2) ? 1 : -1;
  if (kind == Damage::bend) {
    any_coordinate(any(any_bends(points, random), random), random) += step;
  } else if (kind == Damage::vertex) {
    any_coordinate(any(points.vertices, random), random) += step;
  } else if (kind == Damage::shift) {
    shift(points, guarantee, random);
  }
}

/// The factor that brings the largest coordinate just below 2^bits; 1 if bits is 0.
std::int64_t factor_for(int bits, const Points& points) {
  std::int64_t largest = 1;
  Points copy = points;
  copy.change(0, [&](Point& p) {
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  });
  return bits == 0 ? 1 : std::max<std::int64_t>(1, (std::int64_t{1} << bits) / largest);
}

struct Tally {
  std::uint64_t broken = 0, right = 0;
  std::vector<std::uint64_t> caught, false_alarms;
};

Tally judge_all(const Algorithm& algorithm, int bits, Damage kind, std::uint64_t drawings) {
  constexpr std::uint64_t kVertices = 16;
  Tally tally{0, 0, std::vector<std::uint64_t>(judging_modes().size()),
              std::vector<std::uint64_t>(judging_modes().size())};
  RandomStream random(static_cast<std::uint64_t>(bits) * 4 + static_cast<std::uint64_t>(kind), 14);
  for (std::uint64_t i = 0; i < drawings; ++i) {
    Graph graph;
    Points points = two_copies(algorithm, kVertices, i, graph);
    const std::int64_t factor = factor_for(bits, points);
    if (kind == Damage::shift) damage(points, kind, algorithm.guarantee, random);
    points.change(0, [&](Point& p) { p = {factor * p.x, factor * p.y, factor * p.z}; });
    if (kind != Damage::shift) damage(points, kind, algorithm.guarantee, random);
    const Drawing drawing = points.drawing(algorithm.guarantee);
    const bool is_broken =  // by the oracle: every pair of segments
        certify(graph, drawing, algorithm.guarantee,
                {.crossing_test = CrossingTest::all_pairs, .check_size = false})
            .violated();
    ++(is_broken ? tally.broken : tally.right);
    for (std::size_t m = 0; m < judging_modes().size(); ++m) {
      const bool accepted =
          judge_by_mode(graph, drawing, algorithm.guarantee, judging_modes()[m], i).accepts;
      (is_broken ? tally.caught : tally.false_alarms)[m] += !accepted;
    }
  }
  return tally;
}

std::vector<std::string> head(std::vector<std::string> first) {
  for (const JudgingMode& mode : judging_modes())
    first.push_back(fmt::format("`{}`", to_string(mode)));
  return first;
}

void catch_table(std::uint64_t drawings) {
  std::vector<std::vector<std::string>> caught, alarms;
  std::uint64_t all = 0, broken = 0;
  for (const auto& [kind, name] : kDamages) {
    for (const int bits : {0, 40, 60}) {
      Tally sum{0, 0, std::vector<std::uint64_t>(judging_modes().size()),
                std::vector<std::uint64_t>(judging_modes().size())};
      for (const char* algorithm : {"diamond", "grid", "compact", "two-bend"}) {
        const Tally tally = judge_all(find_algorithm(algorithm), bits, kind, drawings);
        sum.broken += tally.broken;
        sum.right += tally.right;
        for (std::size_t m = 0; m < judging_modes().size(); ++m) {
          sum.caught[m] += tally.caught[m];
          sum.false_alarms[m] += tally.false_alarms[m];
        }
      }
      all += sum.broken + sum.right;
      broken += sum.broken;
      const std::string scale = bits == 0 ? "as drawn" : fmt::format("2^{}", bits);
      std::vector<std::string> row{name, scale, fmt::format("{}", sum.broken)};
      std::vector<std::string> alarm{name, scale, fmt::format("{}", sum.right)};
      for (std::size_t m = 0; m < judging_modes().size(); ++m) {
        row.push_back(rate(sum.caught[m], sum.broken));
        alarm.push_back(rate(sum.false_alarms[m], sum.right));
      }
      if (sum.broken > 0) caught.push_back(std::move(row));
      if (sum.right > 0) alarms.push_back(std::move(alarm));
    }
  }
  fmt::print("{} drawings, {} of them wrong. Wrong drawings that a mode rejects:\n\n", all, broken);
  print_table(head({"damage", "largest coordinate", "wrong"}), caught);
  fmt::print("Right drawings that a mode rejects:\n\n");
  print_table(head({"damage", "largest coordinate", "right"}), alarms);
}

}  // namespace

void damage_tables(const TableOptions& options) { catch_table(options.drawings); }

}  // namespace ar3d::precision
