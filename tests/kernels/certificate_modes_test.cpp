// Judging without a proof, as ar3d_precision measures it: what the modes accept, what they leave
// open, and that a sample misses no oftener than it says.
#include "ar3d/bench/kernels/precision/certificate_modes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ar3d/verify/certificate.h"
#include "verify/counted_pairs.h"
#include "verify/random_drafts.h"

namespace ar3d::testing {
namespace {

using precision::JudgingMode;
using Kind = JudgingMode::Kind;

constexpr JudgingMode kFiltered{Kind::filtered, 0};
constexpr JudgingMode kDouble{Kind::double_precision, 0};

bool accepts(const Draft& draft, const JudgingMode& mode, std::uint64_t seed = 0) {
  return precision::judge_by_mode(draft.graph(), draft.drawing(), no_promise(), mode, seed).accepts;
}

// A sample of all pairs and a filter decide exactly, doubles where numbers are small.
TEST(JudgingModes, AgreeWithTheOracleOnRandomAndDamagedDrawings) {
  RandomDrafts drafts(3, 9);
  int valid = 0, broken = 0;
  for (std::uint32_t i = 0; i < 2500; ++i) {
    const auto& set = direction_sets()[i % direction_sets().size()];
    Draft draft = simple(drafts.walks(set, 1 + i % 11, 3 + i % 17));
    draft = drafts.damaged(std::move(draft), i % 3);
    if (measure(draft.drawing()).repeated_points != 0) continue;
    const bool expected = is_valid(draft);
    ++(expected ? valid : broken);
    for (const JudgingMode mode : {kFiltered, kDouble, JudgingMode{Kind::sample, 100000}}) {
      ASSERT_EQ(accepts(draft, mode), expected) << i << to_string(mode);
    }
    ASSERT_EQ(accepts(RandomDrafts::far_away(draft), kFiltered), expected) << i;
  }
  EXPECT_GT(valid, 300);
  EXPECT_GT(broken, 300);
}

/// Two edges that cross, far from each other's ends.
Draft crossing_edges() {
  Draft draft;
  draft.vertices = {{0, 0, 0}, {8, 8, 8}, {8, 0, 0}, {0, 8, 8}};
  draft.edges = {{{0, 1}, {}}, {{2, 3}, {}}};
  return draft;
}

// Two segments that miss each other by one unit, and two that meet off the lattice of doubles.
TEST(JudgingModes, DoublesOverlookWhatTheyRound) {
  constexpr std::int64_t kLarge = std::int64_t{1} << 58;
  Draft draft;
  draft.vertices = {{-kLarge, 0, 0}, {kLarge, 1, 0}, {-kLarge + 1, 1, 1}, {kLarge, 0, -1}};
  draft.edges = {{{0, 1}, {}}, {{2, 3}, {}}};
  EXPECT_EQ(accepts(draft, kFiltered), is_valid(draft));
  Draft touching = crossing_edges();
  touching.vertices = {{0, 0, 0},
                       {kLarge + 1, kLarge + 1, 0},
                       {kLarge + 1, kLarge + 1, 1},
                       {kLarge + 1, kLarge, -1}};
  const bool valid = is_valid(touching);
  EXPECT_TRUE(valid);
  EXPECT_TRUE(accepts(touching, kFiltered));
  EXPECT_FALSE(accepts(touching, kDouble)) << "a false alarm";
}

// One crossing among many pairs: seen as often as stated, or oftener where it is in several cells.
TEST(JudgingModes, ASampleMissesASingleCrossingAsOftenAsStated) {
  RandomDrafts drafts(7, 1);
  Draft draft = crossing_edges();
  for (std::int64_t i = 0; i < 40; ++i) {  // short edges apart from everything
    const auto v = static_cast<Vertex>(draft.vertices.size());
    draft.vertices.push_back({20 + 3 * i, i % 7, 0});
    draft.vertices.push_back({22 + 3 * i, i % 7, 1});
    draft.edges.push_back({{v, v + 1}, {}});
  }
  constexpr int kRounds = 4000;
  for (const std::uint64_t k : {1u, 5u, 20u}) {
    const JudgingMode mode{Kind::sample, k};
    int missed = 0;
    double stated = 0;
    for (int seed = 0; seed < kRounds; ++seed) {
      const auto verdict = precision::judge_by_mode(draft.graph(), draft.drawing(), no_promise(),
                                                    mode, static_cast<std::uint64_t>(seed));
      missed += verdict.accepts;
      stated = verdict.miss_probability;
    }
    ASSERT_GT(stated, 0);
    ASSERT_LT(stated, 1);
    const double deviation = std::sqrt(stated * (1 - stated) / kRounds);
    EXPECT_LT(static_cast<double>(missed) / kRounds, stated + 5 * deviation) << k;
    EXPECT_GT(missed, 0) << k;
    EXPECT_LT(missed, kRounds) << k;
  }
}

}  // namespace
}  // namespace ar3d::testing
