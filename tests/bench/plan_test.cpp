#include "ar3d/bench/plan/plan.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "ar3d/base/error.h"
#include "ar3d/generators/catalog.h"

namespace ar3d::testing {
namespace {

StudyPlan plan_of(const std::string& toml) {
  return plan_study(parse_study("study = \"t\"\n" + toml, "t.toml"));
}

std::string sweep(const std::string& families, const std::string& sizes,
                  const std::string& rest = "") {
  return "[[sweep]]\nfamilies = " + families + "\nsizes = " + sizes +
         "\nalgorithms = \"diamond\"\n" + rest + "\n";
}

TEST(Plan, RowsFollowTheSpecification) {
  const StudyPlan plan = plan_of(
      sweep("[\"random-regular\", \"cycle\"]", "[10, 20]", "instances = 2\nrepetitions = 3"));
  ASSERT_EQ(plan.instances.size(), 2u * 2 + 2);
  EXPECT_EQ(plan.rows(), plan.instances.size() * 3);
  EXPECT_EQ(plan.instances[0].choice.family->name, "random-regular");
  EXPECT_EQ(plan.instances[1].index, 1u);
  EXPECT_EQ(plan.instances[2].n, 20u);
  EXPECT_EQ(plan.instances[4].choice.family->name, "cycle");
  std::size_t row = 0;
  std::set<std::string> keys;
  std::set<std::uint64_t> seeds;
  for (const PlannedInstance& instance : plan.instances) {
    EXPECT_TRUE(seeds.insert(instance.seed).second);
    for (const PlannedRun& run : instance.runs) {
      EXPECT_EQ(run.row, row++);
      EXPECT_EQ(run.row_key.size(), 32u);
      EXPECT_TRUE(keys.insert(run.row_key).second);
    }
  }
}

TEST(Plan, ShuffledFamiliesHaveInstances) {
  const StudyPlan plan =
      plan_of(sweep("{ family = \"cycle\", shuffle = [0, 1] }", "10", "instances = 3"));
  ASSERT_EQ(plan.instances.size(), 1u + 3);
  EXPECT_EQ(plan.instances[0].parameters, "");
  EXPECT_EQ(plan.instances[1].parameters, "shuffle=1");
  EXPECT_NE(plan.instances[1].seed, plan.instances[2].seed);
}

// Adding algorithms, sizes or repetitions changes neither graphs nor the keys of the rows that were
// there.
TEST(Plan, IdentityDependsOnNothingElse) {
  const PlannedInstance alone = plan_of(sweep("\"random-regular\"", "20")).instances[0];
  const StudyPlan larger =
      plan_of(sweep("\"cycle\"", "7") +
              sweep("\"random-regular\"", "[10, 20]", "instances = 5\nrepetitions = 2"));
  const PlannedInstance& among = larger.instances[6];
  EXPECT_EQ(among.n, 20u);
  EXPECT_EQ(among.seed, alone.seed);
  EXPECT_EQ(among.runs[0].row_key, alone.runs[0].row_key);
  const PlannedInstance other =
      plan_of("seed = 1\n" + sweep("\"random-regular\"", "20")).instances[0];
  EXPECT_NE(other.seed, alone.seed);
  EXPECT_NE(other.runs[0].row_key, alone.runs[0].row_key);
}

TEST(Plan, PlansNothingTwice) {
  // A 4-vertex union rounds 8..11 to 8; the second sweep repeats the first.
  const StudyPlan plan =
      plan_of(sweep("\"union-k4\"", "[8, 9, 11, 12]") + sweep("\"union-k4\"", "8"));
  ASSERT_EQ(plan.instances.size(), 2u);
  EXPECT_EQ(plan.instances[0].n, 8u);
  EXPECT_EQ(plan.instances[1].n, 12u);
  EXPECT_EQ(plan.rows(), 2u);
}

std::vector<std::string> keys_of(const PlannedInstances& instances) {
  std::vector<std::string> keys;
  for (const PlannedInstance& instance : instances) {
    for (const PlannedRun& run : instance.runs) {
      EXPECT_EQ(run.row, keys.size());
      keys.push_back(run.row_key);
    }
  }
  return keys;
}

// Sweeps that ask for different numbers of instances of the same graphs: an instance stands where
// the first sweep asks for it and has the rows of all that ask for it.
TEST(Plan, SweepsShareInstances) {
  const std::string family = "\"random-regular\"";
  const StudyPlan plan = plan_of(sweep(family, "20", "instances = 3\nrepetitions = 2") +
                                 sweep(family, "[20, 30]", "instances = 5") +
                                 sweep(family, "20", "instances = 2\nrepetitions = 3"));
  std::vector<std::vector<std::size_t>> found;  // n, index, rows
  for (const PlannedInstance& instance : plan.instances) {
    found.push_back({instance.n, instance.index, instance.runs.size()});
  }
  EXPECT_EQ(found, (std::vector<std::vector<std::size_t>>{{20, 0, 3},
                                                          {20, 1, 3},
                                                          {20, 2, 2},
                                                          {20, 3, 1},
                                                          {20, 4, 1},
                                                          {30, 0, 1},
                                                          {30, 1, 1},
                                                          {30, 2, 1},
                                                          {30, 3, 1},
                                                          {30, 4, 1}}));
  const std::vector<std::string> keys = keys_of(plan.instances);
  EXPECT_EQ(keys.size(), plan.rows());
  EXPECT_EQ(std::set<std::string>(keys.begin(), keys.end()).size(), keys.size());
}

TEST(Plan, ShardsAreEveryNthInstance) {
  const StudyPlan plan = plan_of(
      sweep("[\"cycle\", \"random-regular\"]", "[10, 20, 30]", "instances = 7\nrepetitions = 2"));
  for (const std::size_t parts : {1, 2, 5, 8, 100}) {
    std::vector<std::string> all(plan.rows());
    for (std::size_t part = 0; part < parts; ++part) {
      const PlannedInstances shard = plan.instances.every_nth(part, parts);
      const std::vector<std::string> keys = keys_of(shard);
      ASSERT_EQ(keys.size(), shard.rows());
      for (std::size_t i = 0; i < shard.size(); ++i) {
        const PlannedInstance whole = plan.instances[part + i * parts];
        EXPECT_EQ(shard[i].seed, whole.seed);
        for (std::size_t k = 0; k < whole.runs.size(); ++k) {
          EXPECT_EQ(shard[i].runs[k].row_key, whole.runs[k].row_key);
          all[whole.runs[k].row] = whole.runs[k].row_key;
        }
      }
    }
    EXPECT_EQ(all, keys_of(plan.instances)) << parts;
  }
}

TEST(Plan, PatternsAndLimitsDropCells) {
  EXPECT_EQ(plan_of(sweep("[\"cycle\", \"path\"]", "[10, 20, 30]",
                          "exclude = { family = \"path\", from = 20 }"))
                .rows(),
            4u);
  EXPECT_EQ(plan_of(sweep("[\"cycle\", \"path\"]", "[10, 20, 30]",
                          "include = [{ family = \"path\", to = 10 }, { from = 30 }]"))
                .rows(),
            3u);
  EXPECT_EQ(plan_of("max_n = { diamond = 20 }\n" + sweep("\"cycle\"", "[10, 20, 30]")).rows(), 2u);
  EXPECT_THROW(plan_of("max_n = { diamond = 2 }\n" + sweep("\"cycle\"", "10")), InputError);
}

TEST(Plan, LeavesOutFamiliesOfTooLargeDegree) {
  const StudyPlan plan = plan_of("[[sweep]]\nfamilies = \"all\"\nsizes = 60\nalgorithms = \"all\"");
  for (const PlannedInstance& instance : plan.instances) {
    const FamilyChoice& choice = instance.choice;
    const Graph graph =
        generate(*choice.family, instance.requested_n, instance.seed, choice.parameters);
    for (const PlannedRun& run : instance.runs) {
      EXPECT_LE(graph.max_degree(), run.choice.algorithm->guarantee.max_degree)
          << choice.family->name;
    }
  }
}

TEST(Plan, BatchesAndTimedRowsArePlanned) {
  const StudyPlan plan =
      plan_of(sweep("\"cycle\"", "10",
                    "timed_repetitions = { precision = 0.1, min = 6, max = 8 }\n"
                    "strong = { threads = [1, 3], drawings = 2, repetitions = 2 }\n"
                    "weak = { threads = [1, 3], drawings = 2 }\n"
                    "weak_ranks = { ranks = [1, 2], drawings = 3 }"));
  std::map<std::pair<RunPhase, std::int64_t>, std::vector<std::uint32_t>> batches;
  std::size_t optional = 0;
  for (const PlannedRun& run : plan.instances[0].runs) {
    batches[{run.phase, run.workers}].push_back(run.batch);
    if (run.optional) ++optional;
  }
  EXPECT_EQ(plan.rows(), 1u + 8 + 4 + 4 + 2 + 6 + 3 + 6);
  EXPECT_EQ(optional, 2u);
  EXPECT_EQ((batches[{RunPhase::strong, 3}]), (std::vector<std::uint32_t>{0, 0, 1, 1}));
  EXPECT_EQ((batches[{RunPhase::weak, 3}]), std::vector<std::uint32_t>(6, 0));
  EXPECT_EQ((batches[{RunPhase::weak_ranks, 2}]), std::vector<std::uint32_t>(6, 0));
}

TEST(Plan, RefusesTooManyRows) {
  EXPECT_THROW(plan_of(sweep("\"cycle\"", "10",
                             "weak = { threads = [1, 1000], drawings = 1000000, repetitions = "
                             "1000000 }")),
               InputError);
  EXPECT_THROW(
      plan_of(sweep("\"random-regular\"", "[10, 20]", "instances = 10\nrepetitions = 1000000")),
      InputError);
}

}  // namespace
}  // namespace ar3d::testing
