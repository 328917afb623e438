#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "ar3d/generators/catalog.h"

namespace ar3d::testing {
namespace {

TEST(Docs, FamiliesPageNamesEveryFamilyInTheOrderOfTheCatalogue) {
  std::ifstream file(AR3D_SOURCE_DIR "/docs/families.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  std::size_t at = page.find("## What is known of each family");
  for (const Family& family : families()) {
    at = page.find(fmt::format("`{}`", family.name), at);
    ASSERT_NE(at, std::string::npos) << family.name;
  }
}

}  // namespace
}  // namespace ar3d::testing
