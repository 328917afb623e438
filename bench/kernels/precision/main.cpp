// Tables of docs/precision.md that no row of a study holds: ar3d_precision damage|widths|predicates
// prints them as Markdown. Everything but times is a function of the command.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>

#include "ar3d/model/error.h"
#include "tables.h"

int main(int argc, char** argv) {
  CLI::App app("What precision costs and what it catches");
  app.require_subcommand(1);
  std::uint64_t drawings = 100;
  CLI::App* damage = app.add_subcommand(
      "damage", "catch rates and times of certificate modes on damaged drawings");
  damage->add_option("--drawings", drawings, "of each algorithm, scale and kind of damage")
      ->check(CLI::Range(1, 1000000));
  CLI::App* widths = app.add_subcommand("widths", "bits of coordinates and predicates");
  CLI::App* predicates = app.add_subcommand("predicates", "wrong answers by arithmetic");
  CLI11_PARSE(app, argc, argv);
  try {
    if (damage->parsed()) ar3d::precision::damage_tables(drawings);
    if (widths->parsed()) ar3d::precision::width_tables();
    if (predicates->parsed()) ar3d::precision::predicate_tables();
  } catch (const ar3d::InputError& error) {
    fmt::print(stderr, "ar3d_precision: {}\n", error.what());
    return 2;
  }
  return 0;
}
