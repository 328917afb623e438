// Certificates by other modes than exact: what they accept, what they leave open, and that nothing
// they say passes for a proof.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/certificate.h"
#include "ar3d/verify/modes/candidate_pairs.h"
#include "ar3d/verify/modes/mode_verdict.h"
#include "verify/counted_pairs.h"
#include "verify/random_drafts.h"

namespace ar3d {
namespace {

using testing::Draft;
using ::testing::HasSubstr;
using testing::RandomDrafts;
using verify::CandidatePairs;
using verify::Item;
using Kind = CertificateMode::Kind;

constexpr CertificateMode kFiltered{Kind::filtered, 0};
constexpr CertificateMode kDouble{Kind::double_precision, 0};
constexpr CertificateMode kNone{Kind::none, 0};

TEST(CertificateModes, HaveNamesThatReadBack) {
  for (const char* name : {"exact", "filtered", "double", "sample=1", "sample=999999999", "none"}) {
    EXPECT_EQ(to_string(parse_certificate_mode(name)), name);
    EXPECT_LE(std::string(name).size(), 16u) << "the column holds no more";
  }
  for (const char* name : {"", "Exact", "sample", "sample=", "sample=0", "sample=-1", "sample=1x",
                           "sample=1000000000", "sample=99999999999999999999"}) {
    EXPECT_THROW(parse_certificate_mode(name), InputError) << name;
  }
}

std::set<std::pair<std::uint32_t, std::uint32_t>> pairs_of(const CandidatePairs& pairs) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> all;
  std::uint64_t number = 0;
  pairs.for_each([&](std::uint32_t i, std::uint32_t j) {
    EXPECT_LT(i, j);
    EXPECT_EQ(pairs[number++], std::pair(i, j));
    all.emplace(i, j);
    return true;
  });
  EXPECT_EQ(number, pairs.size());
  return all;
}

TEST(CandidatePairsOfSegments, HaveAllThatMeet) {
  RandomStream random(1);
  std::size_t meetings = 0, pairs = 0, all = 0;
  for (int i = 0; i < 300; ++i) {
    const std::uint32_t side = 2 + random.below(40);
    const std::int64_t stretch = i % 2 == 0 ? 1 : kMaxCoordinate / side;
    const auto place = [&] {
      const auto c = [&] { return stretch * static_cast<std::int64_t>(random.below(side)); };
      return Point{c(), c(), c()};
    };
    std::vector<Item> items;
    for (std::uint32_t k = 1 + random.below(60); k > 0; --k) items.push_back({place(), place()});
    std::erase_if(items, [](const Item& item) { return item.from == item.to; });
    const CandidatePairs candidates(items);
    const auto found = pairs_of(candidates);
    for (std::uint32_t s = 0; s < items.size(); ++s) {
      for (std::uint32_t t = s + 1; t < items.size(); ++t) {
        ++all;
        if (verify::meet(items[s].from, items[s].to, items[t].from, items[t].to).kind ==
            verify::Meeting::Kind::nothing) {
          continue;
        }
        ++meetings;
        ASSERT_TRUE(found.contains({s, t})) << i;
      }
    }
    pairs += found.size();
  }
  EXPECT_GT(meetings, 1000u);
  EXPECT_LT(pairs, all) << "a grid of cells leaves pairs out";
}

TEST(CandidatePairsOfSegments, AreRefusedWhereTheyTakeTooMuch) {
  const std::vector<Item> items(50, Item{{0, 0, 0}, {100, 100, 100}});
  EXPECT_THROW(CandidatePairs(items, 100), InputError);
  const std::vector<Item> many(CandidatePairs::kMostItems + 1);
  EXPECT_THROW(CandidatePairs{many}, InputError);
  EXPECT_EQ(CandidatePairs({}).size(), 0u);
}

Certificate judged(const Draft& draft, const CertificateMode& mode) {
  return certify(draft.graph(), draft.drawing(), testing::no_promise(),
                 {.check_size = false, .mode = mode});
}

/// Whether the mode itself accepts, without the exact tests behind it.
bool accepts(const Draft& draft, const CertificateMode& mode, std::uint64_t seed = 0) {
  return verify::judge_by_mode(draft.graph(), draft.drawing(), testing::no_promise(), mode, seed)
      .accepts;
}

bool is_valid(const Draft& draft) {
  return certify(draft.graph(), draft.drawing(), testing::no_promise(),
                 {.crossing_test = CrossingTest::all_pairs, .check_size = false})
      .valid();
}

// A sample of all pairs and a filter decide exactly, doubles where numbers are small.
TEST(CertificateModes, AgreeWithTheOracleOnRandomAndDamagedDrawings) {
  RandomDrafts drafts(3, 9);
  int valid = 0, broken = 0;
  for (std::uint32_t i = 0; i < 2500; ++i) {
    const auto& set = testing::direction_sets()[i % testing::direction_sets().size()];
    Draft draft = testing::simple(drafts.walks(set, 1 + i % 11, 3 + i % 17));
    draft = drafts.damaged(std::move(draft), i % 3);
    if (measure(draft.drawing()).repeated_points != 0) continue;
    const bool expected = is_valid(draft);
    ++(expected ? valid : broken);
    for (const CertificateMode mode : {kFiltered, kDouble, CertificateMode{Kind::sample, 100000}}) {
      ASSERT_EQ(accepts(draft, mode), expected) << i << to_string(mode);
    }
    ASSERT_EQ(accepts(RandomDrafts::far_away(draft), kFiltered), expected) << i;
  }
  EXPECT_GT(valid, 300);
  EXPECT_GT(broken, 300);
}

TEST(CertificateModes, NeverProve) {
  const Algorithm& algorithm = find_algorithm("grid");
  const Graph graph = generate(find_family("random-cubic"), 40, 1);
  const Drawing drawing = draw(algorithm, graph);
  for (const CertificateMode mode :
       {kFiltered, kDouble, CertificateMode{Kind::sample, 10}, kNone}) {
    const Certificate certificate = certify(graph, drawing, algorithm.guarantee, {.mode = mode});
    EXPECT_EQ(certificate.mode, mode);
    EXPECT_FALSE(certificate.valid()) << to_string(mode);
    EXPECT_FALSE(certificate.violated()) << to_string(mode);
    EXPECT_EQ(certificate.box, certify(graph, drawing, algorithm.guarantee).box);
  }
}

/// Two edges that cross, far from each other's ends.
Draft crossing_edges() {
  Draft draft;
  draft.vertices = {{0, 0, 0}, {8, 8, 8}, {8, 0, 0}, {0, 8, 8}};
  draft.edges = {{{0, 1}, {}}, {{2, 3}, {}}};
  return draft;
}

TEST(CertificateModes, WhatTheyDoNotAcceptIsJudgedExactly) {
  const Certificate exact = judged(crossing_edges(), {});
  ASSERT_EQ(exact.violations.size(), 1u);
  for (const CertificateMode mode : {kFiltered, kDouble, CertificateMode{Kind::sample, 100000}}) {
    const Certificate certificate = judged(crossing_edges(), mode);
    EXPECT_TRUE(certificate.mode.is_exact()) << "it is proved wrong";
    ASSERT_EQ(certificate.violations.size(), 1u);
    EXPECT_EQ(certificate.violations[0].message, exact.violations[0].message);
  }
  EXPECT_FALSE(judged(crossing_edges(), kNone).violated()) << "nothing is judged";
}

// Two segments that miss each other by one unit, and two that meet off the lattice of doubles.
TEST(CertificateModes, DoublesOverlookWhatTheyRound) {
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
  EXPECT_FALSE(accepts(touching, kDouble)) << "a false alarm, which the exact tests undo";
  EXPECT_TRUE(judged(touching, kDouble).valid()) << "proved after all";
}

// One crossing among many pairs: seen as often as stated, or oftener where it is in several cells.
TEST(CertificateModes, ASampleMissesASingleCrossingAsOftenAsStated) {
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
    const CertificateMode mode{Kind::sample, k};
    int missed = 0;
    double stated = 0;
    for (int seed = 0; seed < kRounds; ++seed) {
      const auto verdict =
          verify::judge_by_mode(draft.graph(), draft.drawing(), testing::no_promise(), mode,
                                static_cast<std::uint64_t>(seed));
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
  const Certificate certificate = certify(draft.graph(), draft.drawing(), testing::no_promise(),
                                          {.check_size = false, .mode = {Kind::sample, 1}});
  if (!certificate.mode.is_exact()) {
    EXPECT_THAT(describe_sample(certificate), HasSubstr("1 of "));
  }
}

}  // namespace
}  // namespace ar3d
