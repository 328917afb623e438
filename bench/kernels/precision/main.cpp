// Tables of docs/precision.md that no row of a study holds: ar3d_precision NAME prints one as
// Markdown, ar3d_precision all prints all of them. All is a function of the command.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <functional>
#include <utility>

#include "ar3d/base/error.h"
#include "precision.h"

namespace ar3d::precision {

std::string rate(std::uint64_t successes, std::uint64_t trials) {
  if (trials == 0) return "-";
  const auto n = static_cast<double>(trials);
  const double share = static_cast<double>(successes) / n;
  constexpr double kZ = 1.959964;  // 95 % of a normal distribution
  if (successes == 0) return fmt::format("0 (< {:.2g} %)", 100 * kZ * kZ / (n + kZ * kZ));
  const double middle = share + kZ * kZ / (2 * n);
  const double half = kZ * std::sqrt(share * (1 - share) / n + kZ * kZ / (4 * n * n));
  const double scale = 1 + kZ * kZ / n;
  return fmt::format("{:.3g} % ({:.3g}-{:.3g})", 100 * share, 100 * (middle - half) / scale,
                     100 * (middle + half) / scale);
}

void print_table(const std::vector<std::string>& head,
                 const std::vector<std::vector<std::string>>& rows) {
  fmt::print("| {} |\n|", fmt::join(head, " | "));
  for (std::size_t i = 0; i < head.size(); ++i) fmt::print("---|");
  fmt::print("\n");
  for (const std::vector<std::string>& row : rows) fmt::print("| {} |\n", fmt::join(row, " | "));
  fmt::print("\n");
}

namespace {

int print_tables(int argc, char** argv) {
  CLI::App app("What precision costs");
  app.require_subcommand(1);
  app.fallthrough();
  int depth = 120;
  std::string picture;
  app.add_option("--depth", depth, "nests: largest depth")->check(CLI::Range(1, 200));
  app.add_option("--picture", picture, "signs: new SVG file of the worst windows");
  std::vector<std::pair<const CLI::App*, std::function<void()>>> tables;
  const auto add = [&](const char* name, const char* what, std::function<void()> print) {
    tables.emplace_back(app.add_subcommand(name, what), std::move(print));
  };
  add("widths", "bits of coordinates and predicates", width_tables);
  add("shift", "a drawing in real types far from the origin", shift_tables);
  add("nests", "from which depth on nests miss", [&] { nest_table(depth); });
  add("predicates", "wrong answers by arithmetic", predicate_tables);
  add("signs", "where rounding gives the wrong sign", [&] { sign_tables(picture); });
  const CLI::App* const all = app.add_subcommand("all", "all of these tables");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  for (const auto& [table, print] : tables) {
    if (all->parsed() || table->parsed()) print();
  }
  return 0;
}

}  // namespace
}  // namespace ar3d::precision

int main(int argc, char** argv) {
  try {
    return ar3d::precision::print_tables(argc, argv);
  } catch (const ar3d::InputError& error) {
    fmt::print(stderr, "ar3d_precision: {}\n", error.what());
    return 2;
  }
}
