// Predicates over every family: what the filter leaves open, and where rounding answers wrongly.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/generators/catalog.h"
#include "decisions.h"
#include "questions.h"
#include "tables.h"

namespace ar3d::precision {
namespace {

constexpr std::size_t kMost = 2000;  // questions of each kind and family

/// A share of questions.
struct Share {
  std::uint64_t count = 0, of = 0;
  double percent() const {
    return of == 0 ? 0 : 100 * static_cast<double>(count) / static_cast<double>(of);
  }
};

/// The columns: what the filter leaves open, then wrong answers.
constexpr std::array<const char*, 7> kColumns = {
    "filter: angles left",     "filter: pairs left",         "float: angles",
    "float: one unit off",     "float: touching or one off", "double: any",
    "cosine in double: angles"};

struct FamilyRow {
  std::string family;
  std::size_t n = 0;
  int bits = 0;
  std::array<Share, kColumns.size()> shares;
};

Share& operator+=(Share& share, Share other) {
  share.count += other.count;
  share.of += other.of;
  return share;
}

FamilyRow row_of(const Algorithm& algorithm, const std::string& family, const Graph& graph) {
  const Guarantee& guarantee = algorithm.guarantee;
  const Decisions decisions = decisions_of(draw(algorithm, graph), guarantee, kMost);
  const auto& angles = decisions.angles;
  const auto near_angles = one_off(angles);
  const auto near_pairs = touching(decisions.pairs);
  FamilyRow row{family, graph.num_vertices(), decisions.bits.angle, {}};
  for (const auto& [from, at, to] : angles) {
    row.shares[0].count +=
        !verify::filtered_angle(guarantee.lattice, from, at, to, guarantee.cosine);
  }
  row.shares[0].of = angles.size();
  for (const auto& [a, b, c, d] : decisions.pairs) {
    row.shares[1].count += !verify::surely_apart(a, b, c, d);
  }
  row.shares[1].of = decisions.pairs.size();
  const auto wrong = [&](const char* choice, const std::vector<Angle>& questions) {
    return Share{wrong_angles(verify::predicate_choice(choice), guarantee, questions),
                 questions.size()};
  };
  const auto wrong_pairs = [&](const char* choice) {
    return Share{wrong_meetings(verify::predicate_choice(choice), near_pairs), near_pairs.size()};
  };
  row.shares[2] = wrong("float", angles);
  row.shares[3] = wrong("float", near_angles);
  row.shares[4] = wrong_pairs("float");
  row.shares[5] = wrong("double", angles);
  row.shares[5] += wrong("double", near_angles);
  row.shares[5] += wrong_pairs("double");
  row.shares[6] = wrong("cosine", angles);
  return row;
}

std::vector<FamilyRow> rows_of(const Algorithm& algorithm, std::uint64_t n) {
  std::vector<FamilyRow> rows;
  for (const Family& family : families()) {
    if (family.max_degree > algorithm.guarantee.max_degree) continue;
    const Graph graph = generate(family, n, 1);
    if (graph.num_edges() > 0) rows.push_back(row_of(algorithm, family.name, graph));
  }
  return rows;
}

/// "34.1 (0 `path` - 100 `k4`)": of all questions, and the least and largest family.
std::string spread(const std::vector<FamilyRow>& rows, std::size_t column) {
  Share all;
  const FamilyRow *least = nullptr, *most = nullptr;
  for (const FamilyRow& row : rows) {
    if (row.shares[column].of == 0) continue;
    all += row.shares[column];
    const double percent = row.shares[column].percent();
    if (least == nullptr || percent < least->shares[column].percent()) least = &row;
    if (most == nullptr || percent > most->shares[column].percent()) most = &row;
  }
  if (least == nullptr) return "-";
  if (most->shares[column].count == 0) return rate(0, all.of);
  if (least->shares[column].percent() == 100) return "100 %, every family";
  return fmt::format("{:.3g} % ({:.3g} `{}` - {:.3g} `{}`)", all.percent(),
                     least->shares[column].percent(), least->family, most->shares[column].percent(),
                     most->family);
}

std::vector<std::string> head(std::vector<std::string> first) {
  for (const char* column : kColumns) first.emplace_back(column);
  return first;
}

}  // namespace

void family_tables(std::uint64_t n) {
  std::vector<std::vector<std::string>> summary, all;
  for (const char* name : {"diamond", "compact", "grid", "compact-120", "two-bend"}) {
    const std::vector<FamilyRow> rows = rows_of(find_algorithm(name), n);
    std::vector<std::string> line{fmt::format("`{}`", name), fmt::format("{}", rows.size())};
    for (std::size_t column = 0; column < kColumns.size(); ++column) {
      line.push_back(spread(rows, column));
    }
    summary.push_back(std::move(line));
    for (const FamilyRow& row : rows) {
      std::vector<std::string> cells{fmt::format("`{}`", name), fmt::format("`{}`", row.family),
                                     fmt::format("{}", row.n), fmt::format("{}", row.bits)};
      for (const Share& share : row.shares) cells.push_back(rate(share.count, share.of));
      all.push_back(std::move(cells));
    }
  }
  fmt::print(
      "Every family with about {} vertices, up to {} questions of each kind: over all families, "
      "and "
      "the least and the largest family:\n\n",
      n, kMost);
  print_table(head({"algorithm", "families"}), summary);
  fmt::print("By family, percent with 95 % Wilson intervals:\n\n");
  print_table(head({"algorithm", "family", "n", "bits"}), all);
}

}  // namespace ar3d::precision
