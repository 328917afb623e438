// Tables of docs/precision.md that no row of a study holds: ar3d_precision damage|modes|onset|
// predicates|shift|widths prints them as Markdown. Everything but times is a function of the
// command.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>

#include "ar3d/model/error.h"
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
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    if (damage->parsed()) ar3d::precision::damage_tables(drawings);
    if (modes->parsed()) ar3d::precision::mode_times();
    if (onset->parsed()) ar3d::precision::onset_table(most);
    if (shift->parsed()) ar3d::precision::shift_tables();
    if (widths->parsed()) ar3d::precision::width_tables();
    if (predicates->parsed()) ar3d::precision::predicate_tables();
  } catch (const ar3d::InputError& error) {
    fmt::print(stderr, "ar3d_precision: {}\n", error.what());
    return 2;
  }
  return 0;
}
