// Wrong answers of predicates: as drawn, one unit beside, and where segments touch or nearly do.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/model/cosine_comparison.h"
#include "ar3d/verify/exact.h"
#include "ar3d/verify/predicates/choices.h"
#include "decisions.h"
#include "questions.h"
#include "tables.h"

namespace ar3d::precision {
namespace {

using verify::PredicateChoice;

constexpr std::size_t kMost = 20000;
constexpr std::array<const char*, 4> kChoices = {"float", "double", "long-double", "cosine"};

std::vector<std::string> row_of(const Algorithm& algorithm, std::uint64_t n, int bits,
                                const char* what) {
  return {fmt::format("`{}`", algorithm.name), fmt::format("{}", n), what, fmt::format("{}", bits)};
}

void add_rows(const Algorithm& algorithm, std::uint64_t n,
              std::vector<std::vector<std::string>>& rows,
              std::vector<std::vector<std::string>>& filters) {
  const Guarantee& guarantee = algorithm.guarantee;
  const char* family = guarantee.max_degree == 4 ? "random-4-regular" : "random-cubic";
  const Decisions decisions =
      decisions_of(draw(algorithm, generate(find_family(family), n, 1)), guarantee, kMost);
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
/// with a wrong answer.
std::vector<std::string> onset_row(const Algorithm& algorithm, const char* type, double most) {
  const PredicateChoice& choice = verify::predicate_choice(type);
  const char* family = algorithm.guarantee.max_degree == 4 ? "random-4-regular" : "random-cubic";
  std::string predicted = fmt::format("> {}", most), seen = predicted;
  for (double n = 16; n <= most && (predicted[0] == '>' || seen[0] == '>'); n *= std::sqrt(2.0)) {
    const Graph graph = generate(find_family(family), static_cast<std::uint64_t>(n), 1);
    const Decisions decisions =
        decisions_of(draw(algorithm, graph), algorithm.guarantee, 10 * kMost);
    const std::string size = fmt::format("{}", graph.num_vertices());
    if (predicted[0] == '>' && bits_without_rounding(decisions) > choice.exact_bits) {
      predicted = size;
    }
    const bool is_wrong = wrong_angles(choice, algorithm.guarantee, decisions.angles) +
                              wrong_angles(choice, algorithm.guarantee, one_off(decisions.angles)) >
                          0;
    if (seen[0] == '>' && is_wrong) seen = size;
  }
  return {fmt::format("`{}`", algorithm.name), type, predicted, seen};
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
  std::vector<std::vector<std::string>> onsets;
  for (const char* name : {"diamond", "grid", "compact", "two-bend"}) {
    for (const char* type : {"float", "double"}) {
      onsets.push_back(onset_row(find_algorithm(name), type, static_cast<double>(most)));
    }
  }
  fmt::print("The first n at which an angle's rounding can matter, and with a wrong answer:\n\n");
  print_table({"algorithm", "type", "predicted", "seen"}, onsets);
}

}  // namespace ar3d::precision
