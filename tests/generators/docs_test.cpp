#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "ar3d/generators/catalog.h"

namespace ar3d {
namespace {

std::string parameters_of(const Family& family) {
  std::string text;
  for (const SettingSpec& spec : family.parameters) {
    text += fmt::format("{}`{}` {}..{}, default {}: {}", text.empty() ? "" : "; ", spec.name,
                        spec.low, spec.high, spec.default_value, spec.description);
  }
  return text.empty() ? "–" : text;
}

std::string table_of_families() {
  std::string text;
  for (const Family& family : families()) {
    const Settings defaults = complete_parameters(family, {});
    text += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", family.name, family.summary,
                        family.max_degree, family.is_random ? "random" : "fixed",
                        family.nearest_n(0, defaults), parameters_of(family));
  }
  return text;
}

/// The lines of docs/families.md that start with "| `" below the heading `heading`, up to the next
/// heading.
std::string table_in_docs(const std::string& heading) {
  std::ifstream file(AR3D_SOURCE_DIR "/docs/families.md");
  std::string text;
  std::string line;
  bool inside = false;
  while (std::getline(file, line)) {
    if (line.starts_with("#")) inside = line == heading;
    if (inside && line.starts_with("| `")) text += line + "\n";
  }
  return text;
}

TEST(Docs, FamiliesPageListsExactlyTheCatalogue) {
  EXPECT_EQ(table_in_docs("## The catalogue"), table_of_families());
}

TEST(Docs, EveryFamilyTellsItsSizesConnectivityBridgesAndSource) {
  std::istringstream table(table_in_docs("## What is known of each family"));
  for (const Family& family : families()) {
    std::string line;
    ASSERT_TRUE(std::getline(table, line)) << family.name;
    EXPECT_TRUE(line.starts_with(fmt::format("| `{}` |", family.name))) << line;
    std::istringstream cells(line.substr(1));
    int known = 0;
    for (std::string cell; std::getline(cells, cell, '|');) {
      EXPECT_NE(cell.find_first_not_of(' '), std::string::npos) << line;
      ++known;
    }
    EXPECT_EQ(known, 6) << line;  // family, n, m, connectivity, bridges, source
  }
}

}  // namespace
}  // namespace ar3d
