// One scale of effort for all algorithms.
#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/verify/certificate.h"
#include "support/graphs.h"

namespace ar3d::testing {
namespace {

TEST(Effort, IsTheOptionOfEveryProvedAlgorithmWithOneDefault) {
  for (const Algorithm* row : proved_algorithms()) {
    const Algorithm& algorithm = *row;
    ASSERT_EQ(algorithm.options.size(), 1u) << algorithm.name;
    const SettingSpec& effort = algorithm.options[0];
    EXPECT_EQ(effort.name, "effort") << algorithm.name;
    EXPECT_EQ(effort.default_value, kDefaultEffort) << algorithm.name;
    EXPECT_EQ(effort.low, 0) << algorithm.name;
    EXPECT_THAT(effort.high, AnyOf(1, 2)) << algorithm.name;
  }
}

TEST(Effort, OutsideTheScaleIsRefusedByName) {
  for (const Algorithm* row : proved_algorithms()) {
    const Algorithm& algorithm = *row;
    const Graph graph = path(3);
    for (const std::int64_t effort : {std::int64_t{-1}, algorithm.options[0].high + 1}) {
      EXPECT_THROW(draw(algorithm, graph, {{"effort", effort}}), InputError) << algorithm.name;
      EXPECT_THROW(algorithm.draw(graph, {{"effort", effort}}), InputError)
          << algorithm.name << ": the library's function checks, too";
    }
  }
  EXPECT_THROW(check_effort("x", 3, 2), InputError);
  EXPECT_NO_THROW(check_effort("x", 2, 2));
}

TEST(Effort, EveryOneDrawsTheSameGraphTheSameWayAndKeepsTheGuarantee) {
  for (const Algorithm* row : proved_algorithms()) {
    const Graph graph = row->guarantee.max_degree == 3 ? petersen() : squared_cycle(60);
    for (std::int64_t effort = 0; effort <= row->options[0].high; ++effort) {
      const Drawing one = draw(*row, graph, {{"effort", effort}});
      const Drawing two = draw(*row, graph, {{"effort", effort}});
      EXPECT_EQ(drawing_hash(one), drawing_hash(two)) << row->name << effort;
      EXPECT_EQ(one.counters, two.counters) << row->name << effort;
      EXPECT_EQ(one.algorithm(), row->name);
      EXPECT_TRUE(certify(graph, one, row->guarantee).valid()) << row->name << effort;
    }
  }
}

}  // namespace
}  // namespace ar3d::testing
