#include "ar3d/model/settings.h"

#include <functional>

#include "ar3d/base/error.h"
#include "support/problem.h"
#include "support/test.h"

namespace ar3d::testing {
namespace {

const std::vector<SettingSpec> kSpecs = {{"k", 1, 9, 2, ""}, {"p", -5, 5, 0, ""}};

std::string refusal(const std::function<void()>& call) {
  return problem([&] { call(); });
}

TEST(Settings, AreReadAndWrittenTheSameWay) {
  for (const std::string text : {"", "a=1", "a=1;b=-2", "k=9223372036854775807"})
    EXPECT_EQ(settings_text(parse_settings(text)), text);
  const std::vector<std::string> words = {"a=1", "b=-2"};
  EXPECT_EQ(parse_settings(words), parse_settings("a=1;b=-2"));
}

TEST(Settings, RefuseWhatIsNoSetting) {
  for (const std::string text :
       {"a", "=1", "a=", "a=x", "a=1x", "a= 1", "a=1;;b=2", "a=9223372036854775808"}) {
    EXPECT_THAT(refusal([&] { parse_settings(text); }), HasSubstr("not of the form name=integer"))
        << text;
  }
}

TEST(Settings, AreCompletedInTheOrderOfTheSpecs) {
  EXPECT_EQ(settings_text(complete_settings("x", "option", kSpecs, {})), "k=2;p=0");
  EXPECT_EQ(settings_text(complete_settings("x", "option", kSpecs, {{"p", 5}, {"k", 1}})),
            "k=1;p=5");
  EXPECT_EQ(value_of({{"k", 7}}, "k"), 7);
  EXPECT_THROW(value_of({{"k", 7}}, "p"), InternalError);
}

TEST(Settings, AreRefusedByNameAndValue) {
  const auto told = [](const Settings& given) {
    return refusal([&] { complete_settings("algorithm x", "option", kSpecs, given); });
  };
  EXPECT_EQ(told({{"size", 1}}),
            "algorithm x has no option 'size' (known: k, p; see: ar3d list algorithms)");
  EXPECT_EQ(refusal([] {
              complete_settings("algorithm x", "option",
                                std::vector<SettingSpec>{{"effort", 0, 2, 1, ""}}, {{"efort", 1}});
            }),
            "algorithm x has no option 'efort'; did you mean 'effort'? (known: effort; see: ar3d "
            "list algorithms)");
  EXPECT_EQ(told({{"k", 1}, {"k", 2}}), "algorithm x: option 'k' is given twice");
  EXPECT_EQ(told({{"k", 10}}), "algorithm x: option k = 10 is outside 1..9");
  EXPECT_EQ(told({{"p", -6}}), "algorithm x: option p = -6 is outside -5..5");
}

}  // namespace
}  // namespace ar3d::testing
