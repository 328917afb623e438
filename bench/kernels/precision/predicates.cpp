// Wrong answers of predicates: as drawn, one unit beside, and where segments touch or nearly do.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include "../inputs.h"
#include "ar3d/algorithms/catalog.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/model/cosine_comparison.h"
#include "ar3d/verify/checks/exact.h"
#include "ar3d/verify/predicates/choices.h"
#include "decisions.h"
#include "questions.h"
#include "tables.h"

namespace ar3d::precision {
namespace {

using kernels::random_family;
using verify::PredicateChoice;

constexpr std::size_t kMost = 20000;
constexpr double kMostOfFamilies = 4096;
constexpr std::array<const char*, 4> kChoices = {"float", "double", "long-double", "cosine"};

std::vector<std::string> row_of(const Algorithm& algorithm, std::uint64_t n, int bits,
                                const char* what) {
  return {fmt::format("`{}`", algorithm.name), fmt::format("{}", n), what, fmt::format("{}", bits)};
}

void add_rows(const Algorithm& algorithm, std::uint64_t n,
              std::vector<std::vector<std::string>>& rows,
              std::vector<std::vector<std::string>>& filters) {
  const Guarantee& guarantee = algorithm.guarantee;
  const Decisions decisions =
      decisions_of(draw(algorithm, generate(random_family(algorithm), n, 1)), guarantee, kMost);
  const auto near_angles = one_off(decisions.angles);
  const auto near_pairs = touching(decisions.pairs);
  auto drawn = row_of(algorithm, n, decisions.bits.angle, "angle as drawn");
  auto off = row_of(algorithm, n, decisions.bits.angle, "angle, one unit off");
  auto touch = row_of(algorithm, n, decisions.bits.meeting, "touching or one off");
  for (const char* name : kChoices) {
    const PredicateChoice& choice = verify::predicate_choice(name);
    drawn.push_back(
        rate(wrong_angles(choice, guarantee, decisions.angles), decisions.angles.size()));
    off.push_back(rate(wrong_angles(choice, guarantee, near_angles), near_angles.size()));
    touch.push_back(rate(wrong_meetings(choice, near_pairs), near_pairs.size()));
  }
  rows.insert(rows.end(), {drawn, off, touch});
  std::uint64_t open_angles = 0, open_pairs = 0;
  for (const auto& [from, at, to] : decisions.angles) {
    open_angles += !verify::filtered_angle(guarantee.lattice, from, at, to, guarantee.cosine);
  }
  for (const auto& [a, b, c, d] : decisions.pairs) {
    open_pairs += !verify::surely_apart(a, b, c, d);
  }
  filters.push_back({fmt::format("`{}`", algorithm.name), fmt::format("{}", n),
                     rate(open_angles, decisions.angles.size()),
                     rate(open_pairs, decisions.pairs.size())});
}

/// Bits that decide angles without any rounding that could differ between the two sides: of squared
/// lengths if the cosine's denominator is a power of two, since then both sides are rounded once
/// and equal numbers stay equal; else of the products that are compared.
double bits_without_rounding(const Decisions& decisions) {
  using cosine_comparison::converted;
  using cosine_comparison::inner;
  const bool is_power = std::has_single_bit(static_cast<unsigned>(decisions.cosine.denominator));
  double largest = 1;
  for (const auto& [from, at, to] : decisions.angles) {
    const auto u = converted<double>(from - at), v = converted<double>(to - at);
    const double uu = inner(decisions.lattice, u, u), vv = inner(decisions.lattice, v, v);
    const double p = inner(decisions.lattice, u, v) * decisions.cosine.denominator;
    largest = std::max({largest, uu, vv, is_power ? 1.0 : std::max(p * p, uu * vv)});
  }
  return std::log2(largest);
}

/// On a ladder of n by factors of sqrt(2): the first at which rounding can differ, and the first
/// with a wrong answer; 0 if there is none.
struct AngleOnset {
  std::size_t predicted = 0, seen = 0;
};

AngleOnset onset_of(const Algorithm& algorithm, const Family& family, const char* type,
                    double most) {
  const PredicateChoice& choice = verify::predicate_choice(type);
  AngleOnset onset;
  for (double n = 16; n <= most && (onset.predicted == 0 || onset.seen == 0); n *= std::sqrt(2.0)) {
    const Graph graph = generate(family, static_cast<std::uint64_t>(n), 1);
    if (graph.num_edges() == 0) return onset;
    const Decisions decisions =
        decisions_of(draw(algorithm, graph), algorithm.guarantee, 10 * kMost);
    const bool can_differ = bits_without_rounding(decisions) > choice.exact_bits;
    const bool is_wrong = wrong_angles(choice, algorithm.guarantee, decisions.angles) +
                              wrong_angles(choice, algorithm.guarantee, one_off(decisions.angles)) >
                          0;
    if (onset.predicted == 0 && can_differ) onset.predicted = graph.num_vertices();
    if (onset.seen == 0 && is_wrong) onset.seen = graph.num_vertices();
  }
  return onset;
}

std::string place(std::size_t n, double most) {
  return n == 0 ? fmt::format("> {}", most) : fmt::format("{}", n);
}

/// How seen onsets lie to predicted ones.
struct OnsetTally {
  int early = 0;   ///< seen before rounding can differ: would refute the prediction's proof
  int within = 0;  ///< seen from there to twice the n
  int later = 0;   ///< seen later, or not up to twice the n
  int none = 0;    ///< neither, up to the largest n, or that is too near to tell
  void add(AngleOnset onset, double most) {
    const auto n = [](std::size_t size) { return static_cast<double>(size); };
    if (onset.seen > 0 && (onset.predicted == 0 || onset.seen < onset.predicted)) {
      ++early;
    } else if (onset.seen > 0) {
      ++(n(onset.seen) <= 2.05 * n(onset.predicted) ? within : later);
    } else {
      ++(onset.predicted > 0 && 2.05 * n(onset.predicted) < most ? later : none);
    }
  }
};

void family_onsets(double most) {
  std::vector<std::vector<std::string>> tallies, all;
  for (const char* name : {"diamond", "grid", "compact", "two-bend"}) {
    const Algorithm& algorithm = find_algorithm(name);
    OnsetTally tally;
    for (const Family& family : families()) {
      if (family.max_degree > algorithm.guarantee.max_degree) continue;
      const AngleOnset onset = onset_of(algorithm, family, "float", most);
      tally.add(onset, most);
      if (onset.predicted == 0 && onset.seen == 0) continue;
      all.push_back({fmt::format("`{}`", name), fmt::format("`{}`", family.name),
                     place(onset.predicted, most), place(onset.seen, most)});
    }
    tallies.push_back({fmt::format("`{}`", name), fmt::format("{}", tally.early),
                       fmt::format("{}", tally.within), fmt::format("{}", tally.later),
                       fmt::format("{}", tally.none)});
  }
  fmt::print(
      "Every family, float, n up to {}: families whose first wrong angle is seen before rounding "
      "can matter, from there to twice the n, later, and that have neither:\n\n",
      most);
  print_table({"algorithm", "before", "up to twice", "later", "neither"}, tallies);
  print_table({"algorithm", "family", "predicted", "seen"}, all);
}

}  // namespace

void predicate_tables() {
  std::vector<std::vector<std::string>> rows, filters;
  for (const char* name : {"diamond", "grid", "compact", "two-bend"}) {
    const Algorithm& algorithm = find_algorithm(name);
    for (const std::uint64_t n : {100u, 1000u, 10000u}) add_rows(algorithm, n, rows, filters);
    if (algorithm.name != "two-bend") continue;
    for (const std::uint64_t n : {30000u, 100000u}) add_rows(algorithm, n, rows, filters);
  }
  fmt::print("Wrong answers, percent with 95 % Wilson intervals:\n\n");
  print_table(
      {"algorithm", "n", "question", "bits", "float", "double", "long double", "cosine in double"},
      rows);
  fmt::print("What the filter leaves to exact integers:\n\n");
  print_table({"algorithm", "n", "angles as drawn", "pairs with meeting boxes"}, filters);
}

void onset_table(std::uint64_t most) {
  const auto largest = static_cast<double>(most);
  std::vector<std::vector<std::string>> onsets;
  for (const char* name : {"diamond", "grid", "compact", "two-bend"}) {
    const Algorithm& algorithm = find_algorithm(name);
    for (const char* type : {"float", "double"}) {
      const AngleOnset onset = onset_of(algorithm, random_family(algorithm), type, largest);
      onsets.push_back({fmt::format("`{}`", name), type, place(onset.predicted, largest),
                        place(onset.seen, largest)});
    }
  }
  fmt::print("The first n at which an angle's rounding can matter, and with a wrong answer:\n\n");
  print_table({"algorithm", "type", "predicted", "seen"}, onsets);
  family_onsets(std::min(largest, kMostOfFamilies));
}

}  // namespace ar3d::precision
