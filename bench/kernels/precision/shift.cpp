// The same drawing far from the origin: the drawing of two-bend-paper in 237 bits, moved by 2^j in
// x and y and then rounded to fewer bits. What its condition predicts, and what is seen.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/algorithms/two_bend_paper/two_bend_paper.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/model/real_points.h"
#include "ar3d/verify/assessment/real_assessment.h"
#include "real_types.h"
#include "tables.h"

namespace ar3d::precision {
namespace {

using boost::multiprecision::abs;
using boost::multiprecision::msb;

constexpr int kLargestShift = 60;

/// To so many significant bits, to the nearest, halves away from 0.
BigInteger rounded(const BigInteger& value, int bits) {
  const BigInteger size = abs(value);
  if (size == 0) return value;
  const int drop = static_cast<int>(msb(size)) + 1 - bits;
  if (drop <= 0) return value;
  const BigInteger half = BigInteger(1) << (drop - 1);
  const BigInteger result = ((size + half) >> drop) << drop;
  return value < 0 ? BigInteger(-result) : result;
}

template <class Change>
RealPoints changed(RealPoints points, Change&& change) {
  for (std::vector<BigPoint>* list : {&points.vertices, &points.bends}) {
    for (BigPoint& p : *list) change(p);
  }
  return points;
}

RealPoints shifted(const RealPoints& points, int j) {
  const BigInteger move = BigInteger(1) << (j - points.unit_exponent);
  return changed(points, [&](BigPoint& p) {
    p.x += move;
    p.y += move;
  });
}

RealPoints in_bits(const RealPoints& points, int bits) {
  return changed(points, [&](BigPoint& p) {
    p = {rounded(p.x, bits), rounded(p.y, bits), rounded(p.z, bits)};
  });
}

struct Seen {
  double condition = 0;
  std::array<RealAssessment, kMeasuredTypes.size()> found;
};

/// The least shift at which value(seen) passes the limit.
template <class Value>
std::string first_beyond(const std::vector<Seen>& all, double limit, Value&& value) {
  for (std::size_t j = 0; j < all.size(); ++j) {
    if (value(all[j]) > limit) return fmt::format("2^{}", j);
  }
  return "-";
}

}  // namespace

void shift_tables() {
  const Graph graph = generate(find_family("random-cubic"), 100, 1);
  const RealPoints drawing = two_bend_paper::draw_real(graph, two_bend_paper::RealType::reference);
  std::vector<Seen> all;
  for (int j = 0; j <= kLargestShift; ++j) {
    const RealPoints moved = shifted(drawing, j);
    Seen seen;
    seen.condition = assess(graph, moved).condition;
    for (std::size_t t = 0; t < kMeasuredTypes.size(); ++t) {
      seen.found[t] = assess(graph, in_bits(moved, kMeasuredTypes[t].bits));
    }
    all.push_back(std::move(seen));
  }
  std::vector<std::vector<std::string>> misses, onsets;
  for (std::size_t j = 0; j < all.size(); j += 5) {
    std::vector<std::string> row{fmt::format("2^{}", j),
                                 fmt::format("{:.1f}", std::log2(all[j].condition))};
    for (std::size_t t = 0; t < kMeasuredTypes.size(); ++t) {
      const RealAssessment& found = all[j].found[t];
      row.push_back(
          fmt::format("{:.2g}{}", found.largest_miss, found.is_broken() ? " broken" : ""));
    }
    misses.push_back(std::move(row));
  }
  for (std::size_t t = 0; t < kMeasuredTypes.size(); ++t) {
    for (const double limit : {1e-9, 1e-6, 1e-2, 1.0}) {
      const auto predicted = [&](double kappa) {
        return first_beyond(all, limit, [&](const Seen& s) {
          return predicted_miss(s.condition, kMeasuredTypes[t].bits, kappa);
        });
      };
      onsets.push_back(
          {kMeasuredTypes[t].name, fmt::format("{:g}", limit),
           fmt::format("{} to {}", predicted(kHighKappa), predicted(kMedianKappa)),
           first_beyond(all, limit, [&](const Seen& s) { return s.found[t].largest_miss; })});
    }
    onsets.push_back({kMeasuredTypes[t].name, "broken", "",
                      first_beyond(all, 0, [&](const Seen& s) { return s.found[t].is_broken(); })});
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

}  // namespace ar3d::precision
