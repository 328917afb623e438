// A test's name says what it tests: `ctest -N` and `ctest -R` are read and typed by people.
#include <regex>
#include <sstream>

#include "support/program.h"

namespace ar3d::testing {
namespace {

/// A name in letters and digits; a parameter is named, not printed as bytes or counted.
bool readable(const std::string& name) {
  static const std::regex kWords("[A-Za-z0-9_./]+");
  static const std::regex kCounted(".*/[0-9]+");
  return std::regex_match(name, kWords) && !std::regex_match(name, kCounted);
}

std::vector<std::string> names_in(const std::string& listing) {
  static const std::regex kLine(R"( *Test +#\d+: (.*))");
  std::vector<std::string> names;
  std::istringstream lines(listing);
  std::smatch found;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, found, kLine)) names.push_back(found[1]);
  }
  return names;
}

TEST(TestNames, OfCtestAreReadable) {
  const Outcome listed = expect_exit(0, run("ctest --test-dir " AR3D_BINARY_DIR " -N"));
  const std::vector<std::string> names = names_in(listed.out);
  EXPECT_GT(names.size(), 10u);
  for (const std::string& name : names) EXPECT_TRUE(readable(name)) << name;
}

TEST(TestNames, ThatAreBytesOrCountsAreNot) {
  EXPECT_FALSE(readable("Table/Family.Holds/40-byte object <08-00 00-00>"));
  EXPECT_FALSE(readable("Tests/Violations.NoneInAValidDrawing/2"));
  EXPECT_TRUE(readable("Sizes/TwoBendExhaustive.CertifiesEveryGraph/n5"));
}

}  // namespace
}  // namespace ar3d::testing
