// The same drawing far from the origin: the drawing of two-bend-paper in 237 bits, moved by 2^j in
// x and y and then rounded to fewer bits. What its condition predicts, and what is seen.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "ar3d/algorithms/two_bend_paper/two_bend_paper.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/model/real_points.h"
#include "ar3d/verify/assessment/real_assessment.h"
#include "real_types.h"
#include "rounded_points.h"
#include "tables.h"

namespace ar3d::precision {
namespace {

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

struct Seen {
  double condition = 0;
  std::array<RealAssessment, kMeasuredTypes.size()> found;
};

/// The least shift at which holds(seen); -1 if there is none.
template <class Holds>
int first(const std::vector<Seen>& all, Holds&& holds) {
  for (std::size_t j = 0; j < all.size(); ++j) {
    if (holds(all[j])) return static_cast<int>(j);
  }
  return -1;
}

std::string power(int j) { return j < 0 ? "-" : fmt::format("2^{}", j); }

/// Where one type of a graph's drawing passes a limit.
struct Onset {
  int early = -1, late = -1;  ///< predicted with kHighKappa and kMedianKappa
  int seen = -1;
};

Onset onset_of(const std::vector<Seen>& all, std::size_t type, double limit) {
  const auto predicted = [&](double kappa) {
    return first(all, [&](const Seen& s) {
      return predicted_miss(s.condition, kMeasuredTypes[type].bits, kappa) > limit;
    });
  };
  return {predicted(kHighKappa), predicted(kMedianKappa),
          first(all, [&](const Seen& s) { return s.found[type].largest_miss > limit; })};
}

int broken_at(const std::vector<Seen>& all, std::size_t type) {
  return first(all, [&](const Seen& s) { return s.found[type].is_broken(); });
}

/// Moved by 2^0 to 2^kLargestShift, in the measured types from `from` to before `to`.
std::vector<Seen> moved_away(const Graph& graph, std::size_t from, std::size_t to) {
  const RealPoints drawing = two_bend_paper::draw_real(graph, two_bend_paper::RealType::reference);
  std::vector<Seen> all;
  for (int j = 0; j <= kLargestShift; ++j) {
    const RealPoints moved = shifted(drawing, j);
    Seen seen;
    seen.condition = assess(graph, moved).condition;
    for (std::size_t t = from; t < to; ++t) {
      seen.found[t] = assess(graph, in_bits(moved, kMeasuredTypes[t].bits));
    }
    all.push_back(std::move(seen));
  }
  return all;
}

void one_graph() {
  const std::vector<Seen> all =
      moved_away(generate(find_family("random-cubic"), 100, 1), 0, kMeasuredTypes.size());
  std::vector<std::vector<std::string>> misses, onsets;
  for (std::size_t j = 0; j < all.size(); j += 5) {
    std::vector<std::string> row{fmt::format("2^{}", j),
                                 fmt::format("{:.1f}", std::log2(all[j].condition))};
    for (const RealAssessment& found : all[j].found) {
      row.push_back(
          fmt::format("{:.2g}{}", found.largest_miss, found.is_broken() ? " broken" : ""));
    }
    misses.push_back(std::move(row));
  }
  for (std::size_t t = 0; t < kMeasuredTypes.size(); ++t) {
    for (const double limit : {1e-9, 1e-6, 1e-2, 1.0}) {
      const Onset onset = onset_of(all, t, limit);
      onsets.push_back({kMeasuredTypes[t].name, fmt::format("{:g}", limit),
                        fmt::format("{} to {}", power(onset.early), power(onset.late)),
                        power(onset.seen)});
    }
    onsets.push_back({kMeasuredTypes[t].name, "broken", "", power(broken_at(all, t))});
  }
  fmt::print(
      "Largest miss in degrees, random cubic graph with 100 vertices, moved and rounded:\n\n");
  print_table({"moved by", "log2 C", "float", "double", "long double"}, misses);
  fmt::print(
      "The first move with which the drawing misses by more than a limit, predicted with kappa "
      "from {} to {}, and seen:\n\n",
      kHighKappa, kMedianKappa);
  print_table({"type", "degrees", "predicted", "seen"}, onsets);
}

/// How many powers of two the seen one lies outside of the band; negative: before it.
int beside(const Onset& onset) {
  if (onset.seen < onset.early) return onset.seen - onset.early;
  return std::max(0, onset.seen - onset.late);
}

void every_family() {
  constexpr std::uint64_t kVertices = 48;
  constexpr std::size_t kDouble = 1;
  std::vector<std::vector<std::string>> rows;
  std::map<int, int> count_of;
  for (const Family& family : families()) {
    if (family.max_degree > 3) continue;
    const Graph graph = generate(family, kVertices, 1);
    if (graph.num_edges() == 0) continue;
    const std::vector<Seen> all = moved_away(graph, kDouble, kDouble + 1);
    if (all[0].condition == 0) continue;  // no angle
    std::vector<std::string> row{fmt::format("`{}`", family.name),
                                 fmt::format("{}", graph.num_vertices()),
                                 fmt::format("{:.1f}", std::log2(all[0].condition))};
    for (const double limit : {1e-6, 1.0}) {
      const Onset onset = onset_of(all, kDouble, limit);
      row.push_back(fmt::format("{} to {}", power(onset.early), power(onset.late)));
      row.push_back(power(onset.seen));
      if (onset.seen >= 0 && onset.late >= 0) ++count_of[beside(onset)];
    }
    row.push_back(power(broken_at(all, kDouble)));
    rows.push_back(std::move(row));
  }
  fmt::print(
      "Every family, about {} vertices, in double: the first move with which 10^-6 and 1 degree "
      "are passed, predicted and seen, and with which the drawing is broken:\n\n",
      kVertices);
  print_table({"family", "n", "log2 C", "10^-6 degrees: predicted", "seen", "1 degree: predicted",
               "seen", "broken"},
              rows);
  fmt::print("Powers of two by which the seen move lies outside of the predicted ones:\n\n");
  std::vector<std::vector<std::string>> counts;
  for (const auto& [off, count] : count_of) {
    counts.push_back({fmt::format("{:+}", off), fmt::format("{}", count)});
  }
  print_table({"off by", "onsets"}, counts);
}

}  // namespace

void shift_tables() {
  one_graph();
  every_family();
}

}  // namespace ar3d::precision
