#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "ar3d/generators/catalog.h"

namespace ar3d {
namespace {

/// The list of docs/families.md below the heading `heading`, up to the next heading.
std::string list_in_docs(const std::string& heading) {
  std::ifstream file(AR3D_SOURCE_DIR "/docs/families.md");
  std::string text;
  std::string line;
  bool inside = false;
  while (std::getline(file, line)) {
    if (line.starts_with("#")) inside = line == heading;
    if (inside && line.starts_with("- `")) text += line + "\n";
  }
  return text;
}

TEST(Docs, FamiliesPageTellsEveryFamilyOfTheCatalogueInItsOrder) {
  std::istringstream list(list_in_docs("## What is known of each family"));
  std::string line;
  for (const Family& family : families()) {
    ASSERT_TRUE(std::getline(list, line)) << family.name;
    const std::string known = fmt::format("- `{}`: {}", family.name, family.summary);
    EXPECT_TRUE(line.starts_with(known)) << line;
  }
  EXPECT_FALSE(std::getline(list, line)) << line;
}

}  // namespace
}  // namespace ar3d
