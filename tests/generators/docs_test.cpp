#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "ar3d/generators/catalog.h"

namespace ar3d {
namespace {

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

TEST(Docs, FamiliesPageTellsEveryFamilyOfTheCatalogueInItsOrder) {
  std::istringstream table(table_in_docs("## What is known of each family"));
  std::string line;
  for (const Family& family : families()) {
    ASSERT_TRUE(std::getline(table, line)) << family.name;
    EXPECT_TRUE(line.starts_with(fmt::format("| `{}` | {} |", family.name, family.summary)))
        << line;
    std::istringstream cells(line.substr(1));
    int known = 0;
    for (std::string cell; std::getline(cells, cell, '|');) {
      EXPECT_NE(cell.find_first_not_of(' '), std::string::npos) << line;
      ++known;
    }
    EXPECT_EQ(known, 5) << line;  // family, what it is, n and m, connectivity and bridges, source
  }
  EXPECT_FALSE(std::getline(table, line)) << line;
}

}  // namespace
}  // namespace ar3d
