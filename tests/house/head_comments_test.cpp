// Each source opens with what it does; each stage of an algorithm with two to six lines: which step
// of which proof, and what it costs (CONTRIBUTING.md, "Rules of the house").
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "support/references.h"

namespace ar3d::testing {
namespace {

/// What the lines that a source begins with lack; "" if nothing.
std::string lacks_in_head(const std::string& source) {
  static const std::regex step("\\b(Step|Lemma|Rule|Theorem)s?\\s+[0-9A-Z]");
  static const std::regex cost("\\bO\\(|\\bCost:");
  std::istringstream lines(source);
  std::string head;
  int count = 0;
  for (std::string line; std::getline(lines, line) && line.starts_with("//"); ++count) {
    head += line.substr(2);
  }
  if (count < 2 || count > 6) return "two to six lines of comment";
  if (!std::regex_search(head, step)) return "a step, lemma, rule or theorem";
  return std::regex_search(head, cost) ? "" : "its cost";
}

TEST(HeadComments, OfEveryStageNameItsStepAndItsCost) {
  expect_of_sources("algorithms/\\w+/\\w+\\.cpp", 60, lacks_in_head);
}

TEST(HeadComments, OpenEverySource) {
  expect_of_sources(
      "(algorithms|analysis|apps|base|bench|formats|generators|model|python|store|verify)/.*\\.cpp",
      250, [](const std::string& source) {
        return std::string(source.starts_with("// ") ? "" : "a comment at its head");
      });
}

TEST(HeadComments, AreFollowedByOneAnonymousNamespaceAtMost) {
  const std::string opening = "\nnamespace {\n";
  expect_of_sources(".*\\.(cpp|h)", 250, [&](const std::string& source) {
    const bool is_reopened = source.find(opening) != source.rfind(opening);
    return std::string(is_reopened ? "one anonymous namespace instead of several" : "");
  });
}

TEST(HeadComments, LackWhatIsNotThere) {
  EXPECT_EQ(lacks_in_head("// Step 3.1: orders.\n// Cost: O(n).\nint n;\n"), "");
  EXPECT_EQ(lacks_in_head("// Steps 3.1 and\n// 3.2. O(n).\nint n;\n"), "");
  EXPECT_EQ(lacks_in_head("int n;\n"), "two to six lines of comment");
  EXPECT_EQ(lacks_in_head("// Step 3.1. O(n).\nint n;\n"), "two to six lines of comment");
  EXPECT_EQ(lacks_in_head("// Orders.\n// O(n).\nint n;  // Step 3.1\n"),
            "a step, lemma, rule or theorem");
  EXPECT_EQ(lacks_in_head("// Step 3.1:\n// orders.\nint n;  // O(n)\n"), "its cost");
}

}  // namespace
}  // namespace ar3d::testing
