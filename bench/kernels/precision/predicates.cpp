// Wrong answers of predicates: as drawn, one unit beside, and where segments touch or nearly do.
#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

#include "../inputs.h"
#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/ieee_arithmetic.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/predicates/choices.h"
#include "ar3d/verify/predicates/exact.h"
#include "precision.h"

namespace ar3d::precision {
namespace {

using kernels::random_family;
using verify::PredicateChoice;

constexpr std::size_t kMost = 20000;
constexpr std::array<const char*, 4> kChoices = {"float", "double", kLongDouble, "cosine"};

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

}  // namespace

void predicate_tables(const TableOptions&) {
  std::vector<std::vector<std::string>> rows, filters;
  for (const char* name : {"diamond", "grid", "compact", "two-bend"}) {
    const Algorithm& algorithm = find_algorithm(name);
    for (const std::uint64_t n : {100u, 1000u, 10000u}) add_rows(algorithm, n, rows, filters);
    if (algorithm.name != "two-bend") continue;
    for (const std::uint64_t n : {30000u, 100000u}) add_rows(algorithm, n, rows, filters);
  }
  fmt::print("Wrong answers, percent with 95 % Wilson intervals:\n\n");
  print_table(
      {"algorithm", "n", "question", "bits", "float", "double", kLongDouble, "cosine in double"},
      rows);
  fmt::print("What the filter leaves to exact integers:\n\n");
  print_table({"algorithm", "n", "angles as drawn", "pairs with meeting boxes"}, filters);
}

}  // namespace ar3d::precision
