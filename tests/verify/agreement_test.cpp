// The crossing tests against the oracle on thousands of random valid and broken drawings: not only
// the verdict but every violation, word for word.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "ar3d/verify/certificate.h"
#include "verify/random_drafts.h"

namespace ar3d::testing {
namespace {

std::vector<std::string> findings(const Draft& draft, CrossingTest test) {
  const CertifyOptions options{
      .crossing_test = test, .max_violations = 1000000, .check_size = false};
  // Drafts may have loops and repeated edges, which no graph has: judge them as drawings of no
  // edges.
  const Graph graph(draft.vertices.size(), {});
  std::vector<std::string> lines;
  for (const Violation& violation :
       certify(graph, draft.drawing(), no_promise(), options).violations) {
    if (violation.kind == ViolationKind::edge_set) continue;
    lines.push_back(std::string(to_string(violation.kind)) + ": " + violation.message);
  }
  return lines;
}

/// What the comparisons covered.
struct Coverage {
  std::size_t drawings = 0;
  std::size_t valid = 0;
  std::map<std::string, std::size_t> violations;
};

void compare(const Draft& draft, Coverage& tally) {
  const auto expected = findings(draft, CrossingTest::all_pairs);
  ++tally.drawings;
  tally.valid += expected.empty();
  for (const std::string& line : expected) ++tally.violations[line.substr(0, line.find(':'))];
  ASSERT_EQ(findings(draft, CrossingTest::halving), expected);
  ASSERT_EQ(findings(draft, CrossingTest::automatic), expected);
}

void expect_every_kind(Coverage& tally, std::size_t valid) {
  EXPECT_GE(tally.valid, valid);
  for (const char* kind : {"crossing", "vertex_on_edge", "same_point"}) {
    EXPECT_GT(tally.violations[kind], 20u) << kind;
  }
}

/// Compares so many drafts, each as it is and far away; at least so many of them are valid.
template <class Make>
void expect_agreement(std::uint64_t seed, std::size_t count, std::size_t valid, Make make) {
  Coverage tally;
  RandomDrafts drafts(seed, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const Draft draft = make(drafts, i);
    ASSERT_NO_FATAL_FAILURE(compare(draft, tally)) << i;
    ASSERT_NO_FATAL_FAILURE(compare(RandomDrafts::far_away(draft), tally)) << i;
  }
  expect_every_kind(tally, valid);
}

TEST(CrossingTests, AgreeOnRandomWalks) {
  expect_agreement(1, 1500 * direction_sets().size(), 1001,
                   [](RandomDrafts& drafts, std::size_t i) {
                     const std::size_t edges = 1 + drafts.random().below(12);
                     const std::uint32_t side = 2 + drafts.random().below(20);
                     return drafts.walks(direction_sets()[i / 1500], edges, side);
                   });
}

/// A valid drawing of up to `edges` edges: only walks that keep it valid are taken.
Draft valid_draft(RandomDrafts& drafts, const std::vector<Vector>& directions, std::size_t edges) {
  Draft draft;
  draft.vertices.push_back({0, 0, 0});
  for (std::size_t i = 0; i < edges; ++i) {
    Draft larger = drafts.with_walk(draft, directions, 8);
    if (findings(larger, CrossingTest::all_pairs).empty()) draft = std::move(larger);
  }
  return draft;
}

TEST(CrossingTests, AgreeOnValidAndThenDamagedDrawings) {
  Coverage tally;
  RandomDrafts drafts(2, 0);
  for (const auto& directions : direction_sets()) {
    for (int i = 0; i < 300; ++i) {
      Draft draft = valid_draft(drafts, directions, 20);
      if (draft.edges.empty()) continue;
      ASSERT_NO_FATAL_FAILURE(compare(draft, tally)) << i;
      for (int step = 0; step < 6; ++step) {
        drafts.damage(draft);
        ASSERT_NO_FATAL_FAILURE(compare(draft, tally)) << i << " damaged " << step;
      }
      ASSERT_NO_FATAL_FAILURE(compare(RandomDrafts::far_away(draft), tally)) << i;
    }
  }
  expect_every_kind(tally, 1001);
}

/// Long segments in few planes, so that single planes hold many.
TEST(CrossingTests, AgreeOnCrowdedPlanes) {
  expect_agreement(3, 60, 0, [](RandomDrafts& drafts, std::size_t i) {
    Draft draft;
    const std::uint32_t side = 20 + 40 * static_cast<std::uint32_t>(i);
    auto& random = drafts.random();
    for (Vertex v = 0; v < 240; v += 2) {
      const Point a{random.below(side), random.below(side), random.below(3)};
      const std::int64_t length = 1 + random.below(30);
      const bool along_x = random.chance(1, 2);
      draft.vertices.insert(draft.vertices.end(),
                            {a, a + (along_x ? Vector{length, 0, 0} : Vector{0, length, 0})});
      draft.edges.push_back({{v, v + 1}, {}});
    }
    return draft;
  });
}

/// Vertical segments, most of them long, and slanted ones in any direction, in one slab or several.
Draft tall_draft(RandomStream& random) {
  Draft draft;
  const std::uint32_t side = 2 + random.below(12);
  const std::uint32_t height = 2 + random.below(60);
  const std::uint32_t slabs = 1 + random.below(3);
  const auto place = [&](std::int64_t slab) {
    return Point{random.below(side), random.below(side), slab * 2 * height + random.below(height)};
  };
  const std::uint32_t edges = 1 + random.below(25);
  for (std::uint32_t e = 0; e < edges; ++e) {
    const std::int64_t slab = random.below(slabs);
    const Point a = place(slab);
    const Point b = place(slab);
    Draft::DraftEdge edge{{2 * e, 2 * e + 1}, {}};
    if (random.chance(2, 3)) edge.bends = {{b.x, b.y, a.z}, {b.x, b.y, place(slab).z}};
    if (random.chance(1, 3)) edge.bends = {{a.x, a.y, b.z}};
    draft.vertices.push_back(a);
    draft.vertices.push_back(b);
    draft.edges.push_back(std::move(edge));
  }
  return draft;
}

TEST(CrossingTests, AgreeOnTallDrawings) {
  expect_agreement(4, 3000, 201,
                   [](RandomDrafts& drafts, std::size_t) { return tall_draft(drafts.random()); });
}

}  // namespace
}  // namespace ar3d::testing
