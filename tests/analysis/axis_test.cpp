// Ticks and numbers of the report's page.
#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/plot.h"
#include "ar3d/store/columns/run_record.h"
#include "support/test.h"

namespace ar3d::testing {
namespace {

TEST(Axis, TicksAreDecadesOrOneTwoFive) {
  const auto labels = [](const report::LogAxis& axis, report::TickStyle style) {
    std::vector<std::string> labels;
    for (const report::Tick& tick : axis.ticks(style, 6)) {
      if (!tick.label.empty()) labels.push_back(tick.label);
    }
    return labels;
  };
  EXPECT_THAT(labels({1, 5, 0, 100}, report::TickStyle::count),
              ElementsAre("10", "100", "1k", "10k", "100k"));
  EXPECT_THAT(labels({2, 3, 0, 100}, report::TickStyle::count),
              ElementsAre("100", "200", "500", "1k"));
  EXPECT_THAT(labels({-6, -2, 0, 100}, report::TickStyle::seconds),
              ElementsAre("1 µs", "10 µs", "100 µs", "1 ms", "10 ms"));
  EXPECT_THAT(labels({0, 20, 0, 100}, report::TickStyle::power),
              ElementsAre("1", "10⁴", "10⁸", "10¹²", "10¹⁶", "10²⁰"));
  EXPECT_THAT(labels({-68, 1, 0, 100}, report::TickStyle::power),
              ElementsAre("10⁻⁶⁰", "10⁻⁴⁰", "10⁻²⁰", "1"));
  EXPECT_THAT(labels({10.3, 10.5, 0, 100}, report::TickStyle::power),
              ElementsAre("2·10¹⁰", "2.5·10¹⁰", "3·10¹⁰"));
  EXPECT_THAT(labels({2.05, 2.2, 0, 100}, report::TickStyle::count),
              ElementsAre("120", "130", "140", "150", "160"));
  EXPECT_THAT(labels({0, 0.3, 0, 100}, report::TickStyle::count), ElementsAre("1", "1.5", "2"));
}

TEST(Labels, ThoseThatDifferBehindTheCutAreToldApart) {
  const std::string svg = report::labels_svg(
      {{0, 0, "igraph-fr (iterations=10)", ""}, {200, 0, "igraph-fr (iterations=100)", ""}}, 0,
      100);
  EXPECT_THAT(svg, HasSubstr(">igraph-fr (i…ons=10)<"));
  EXPECT_THAT(svg, HasSubstr(">igraph-fr (i…ns=100)<"));
}

TEST(Bins, OfSizesAreEvenOnALogarithmicScale) {
  const auto texts = [](const std::set<std::int64_t>& sizes, std::size_t most) {
    std::vector<std::string> texts;
    for (const report::SizeBin& bin : report::size_bins(sizes, most)) texts.push_back(bin.text());
    return texts;
  };
  EXPECT_THAT(texts({10, 11, 99, 1000}, 4), ElementsAre("10", "11", "99", "1,000"));
  EXPECT_THAT(texts({10, 11, 99, 100, 999, 1000}, 2), ElementsAre("10 – 99", "100 – 1,000"));
  EXPECT_THAT(texts({0, 1, 2, 1000}, 3), ElementsAre("0 – 2", "1,000"));
  EXPECT_TRUE(report::size_bins({}, 3).empty());
}

TEST(Html, Numbers) {
  EXPECT_EQ(report::grouped(1234567), "1,234,567");
  EXPECT_EQ(report::grouped(-123), "-123");
  EXPECT_EQ(report::grouped(-1234), "-1,234");
  EXPECT_EQ(report::short_count(215), "215");
  EXPECT_EQ(report::short_count(4642), "4.6k");
  EXPECT_EQ(report::short_count(9990), "10k");
  EXPECT_EQ(report::short_count(1000000), "1M");
  EXPECT_EQ(report::json_string("a\"</script>\xff"), "\"a\\\"\\u003c/script\\u003e\\ufffd\"");
  EXPECT_EQ(report::duration(0.00123), "1.23 ms");
  EXPECT_EQ(report::duration(kMissing), "–");
  EXPECT_EQ(report::percent(0.5), "50.0 %");
}

}  // namespace
}  // namespace ar3d::testing
