// One function writes what people read, so that no name or message of others can steer a terminal.
#include <gtest/gtest.h>

#include <regex>

#include "support/references.h"

namespace ar3d::testing {
namespace {

/// What writes to a stream without looking at the text; "" if nothing. A constant may be written.
std::string direct_output(const std::string& source) {
  static const std::regex direct(
      "\\bfmt::print\\(|std::(cout|cerr|clog|puts)\\b|\\bv?f?printf\\([^;]*%s|fputs\\((?!\")");
  std::smatch found;
  return std::regex_search(source, found, direct) ? found.str() : "";
}

TEST(Terminal, EveryVerbWritesThroughSay) {
  expect_of_sources("(apps|analysis|bench/(compare|keep|plan|replay|search|spec))/.*\\.(cpp|h)",
                    100, direct_output);
}

TEST(Terminal, DirectOutputIsFound) {
  EXPECT_EQ(direct_output("say(stderr, \"{}\", x); std::fputs(\"\\r\", stdout);"), "");
  EXPECT_EQ(direct_output("fmt::print(\"{}\", x);"), "fmt::print(");
  EXPECT_NE(direct_output("std::printf(\"%s\", x);"), "");
  EXPECT_NE(direct_output("std::cerr << x;"), "");
}

}  // namespace
}  // namespace ar3d::testing
