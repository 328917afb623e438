// Tables of docs/precision.md that no row of a study holds: ar3d_precision damage, families, front,
// modes, nests, onset, positions, predicates, rounding, shift, signs or widths prints them as
// Markdown, ar3d_precision all prints all of them. Everything but times is a function of the
// command.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

#include "ar3d/base/error.h"
#include "tables.h"

int main(int argc, char** argv) {
  CLI::App app("What precision costs and what it catches");
  app.require_subcommand(1);
  std::uint64_t drawings = 320;
  CLI::App* damage =
      app.add_subcommand("damage", "catch rates of certificate modes on damaged drawings");
  damage->add_option("--drawings", drawings, "of each algorithm, scale and kind of damage")
      ->check(CLI::Range(1, 1000000));
  CLI::App* modes = app.add_subcommand("modes", "times of certificate modes");
  CLI::App* shift = app.add_subcommand("shift", "a drawing in real types far from the origin");
  CLI::App* widths = app.add_subcommand("widths", "bits of coordinates and predicates");
  std::uint64_t most = 100000;
  CLI::App* onset = app.add_subcommand("onset", "from which n on angles are wrong");
  onset->add_option("--most", most, "largest n that is tried")->check(CLI::Range(16, 1000000));
  CLI::App* predicates = app.add_subcommand("predicates", "wrong answers by arithmetic");
  std::uint64_t n = 1000;
  CLI::App* families =
      app.add_subcommand("families", "filter failures and wrong answers over every family");
  families->add_option("-n", n, "vertices of each graph")->check(CLI::Range(16, 100000));
  CLI::App* front = app.add_subcommand("front", "time against wrong answers by arithmetic");
  int depth = 120;
  CLI::App* nests = app.add_subcommand("nests", "from which depth on nests miss");
  nests->add_option("--depth", depth, "largest depth")->check(CLI::Range(1, 200));
  std::uint64_t largest = 1000000;
  CLI::App* positions = app.add_subcommand("positions", "what positions of each width cost");
  positions->add_option("--most", largest, "largest n")->check(CLI::Range(1800, 1000000));
  std::uint64_t rounded = 1024;
  CLI::App* rounding =
      app.add_subcommand("rounding", "what computing misses, and storing the result alone");
  rounding->add_option("--most", rounded, "largest n")->check(CLI::Range(16, 2048));
  std::string picture;
  CLI::App* signs = app.add_subcommand("signs", "where rounding gives the wrong sign");
  signs->add_option("--picture", picture, "new SVG file of the worst windows");
  CLI::App* all = app.add_subcommand("all", "all of these tables");
  all->add_option("--picture", picture, "new SVG file of the worst windows");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    const auto wanted = [&](CLI::App* one) { return one->parsed() || all->parsed(); };
    if (wanted(widths)) ar3d::precision::width_tables();
    if (wanted(positions)) ar3d::precision::position_table(largest);
    if (wanted(shift)) ar3d::precision::shift_tables();
    if (wanted(nests)) ar3d::precision::nest_table(depth);
    if (wanted(rounding)) ar3d::precision::rounding_tables(rounded);
    if (wanted(predicates)) ar3d::precision::predicate_tables();
    if (wanted(families)) ar3d::precision::family_tables(n);
    if (wanted(signs)) ar3d::precision::sign_tables(picture);
    if (wanted(onset)) ar3d::precision::onset_table(most);
    if (wanted(front)) ar3d::precision::front_table();
    if (wanted(damage)) ar3d::precision::damage_tables(drawings);
    if (wanted(modes)) ar3d::precision::mode_times();
  } catch (const ar3d::InputError& error) {
    fmt::print(stderr, "ar3d_precision: {}\n", error.what());
    return 2;
  }
  return 0;
}
