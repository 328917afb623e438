// What is said to the user: the name that was meant, and nothing that a terminal obeys.
#include <gtest/gtest.h>

#include "ar3d/base/nearest_name.h"
#include "ar3d/base/printable.h"

namespace ar3d::testing {
namespace {

const std::vector<std::string_view> kNames = {"cycle", "path", "random-cubic", "random-4-regular"};

TEST(NearestName, TakesTheFewestChanges) {
  EXPECT_EQ(nearest_name("cycel", kNames), "cycle");  // exchanged
  EXPECT_EQ(nearest_name("paths", kNames), "path");
  EXPECT_EQ(nearest_name("Random_Cubic", kNames), "random-cubic");
  EXPECT_EQ(nearest_name("random-regular", kNames), "random-4-regular");
  EXPECT_EQ(did_you_mean("cycel", kNames), "; did you mean 'cycle'?");
}

TEST(NearestName, NothingThatIsFarAway) {
  EXPECT_EQ(nearest_name("petersen", kNames), std::nullopt);
  EXPECT_EQ(nearest_name("", kNames), std::nullopt);
  EXPECT_EQ(nearest_name(std::string(100000, 'c'), kNames), std::nullopt);
  EXPECT_EQ(did_you_mean("petersen", kNames), "");
}

TEST(Printable, KeepsText) {
  EXPECT_EQ(printable("K\u2085, 109.47\u00b0 \u2026 \U0001d54c"),
            "K\u2085, 109.47\u00b0 \u2026 \U0001d54c");
}

TEST(Printable, EscapesWhatATerminalObeys) {
  EXPECT_EQ(printable("\x1b[31mred\n"), "\\x1b[31mred\\x0a");
  EXPECT_EQ(printable("\x7f\t\r"), "\\x7f\\x09\\x0d");
  EXPECT_EQ(printable("\u009b31m"), "\\xc2\\x9b31m");  // C1 control sequence introducer
  EXPECT_EQ(printable("a\u202eb\u2066"), "a\\xe2\\x80\\xaeb\\xe2\\x81\\xa6");
  EXPECT_EQ(printable("\u2028"), "\\xe2\\x80\\xa8");
}

TEST(Printable, EscapesWhatIsNoUtf8) {
  EXPECT_EQ(printable("\xff\xfe"), "\\xff\\xfe");
  EXPECT_EQ(printable("\xc3"), "\\xc3");           // cut
  EXPECT_EQ(printable("\xc0\x9b"), "\\xc0\\x9b");  // longer than need be
  EXPECT_EQ(printable("\xe0\x80\x9b"), "\\xe0\\x80\\x9b");
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // a surrogate
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
}

}  // namespace
}  // namespace ar3d::testing
