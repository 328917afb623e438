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
  CertifyOptions options;
  options.crossing_test = test;
  options.check_size = false;
  options.max_violations = 1000000;
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
  ASSERT_EQ(findings(draft, CrossingTest::slabs), expected);
  ASSERT_EQ(findings(draft, CrossingTest::automatic), expected);
}

void expect_every_kind(const Coverage& tally) {
  for (const char* kind : {"crossing", "vertex_on_edge", "same_point"}) {
    EXPECT_GT(tally.violations.count(kind) ? tally.violations.at(kind) : 0, 20u) << kind;
  }
}

TEST(CrossingTests, AgreeOnRandomWalks) {
  Coverage tally;
  RandomDrafts drafts(1, 0);
  for (const auto& directions : direction_sets()) {
    for (int i = 0; i < 1500; ++i) {
      const std::size_t edges = 1 + drafts.random().below(12);
      const std::uint32_t side = 2 + drafts.random().below(20);
      const Draft draft = drafts.walks(directions, edges, side);
      ASSERT_NO_FATAL_FAILURE(compare(draft, tally)) << i;
      ASSERT_NO_FATAL_FAILURE(compare(RandomDrafts::far_away(draft), tally)) << i;
    }
  }
  EXPECT_GT(tally.valid, 1000u);
  expect_every_kind(tally);
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
  EXPECT_GT(tally.valid, 1000u);
  expect_every_kind(tally);
}

/// Long segments in few planes, so that single planes hold many.
TEST(CrossingTests, AgreeOnCrowdedPlanes) {
  Coverage tally;
  RandomDrafts drafts(3, 0);
  for (int i = 0; i < 60; ++i) {
    Draft draft;
    const std::uint32_t side = 20 + 40 * static_cast<std::uint32_t>(i);
    for (std::size_t e = 0; e < 120; ++e) {
      auto& random = drafts.random();
      const Point a{random.below(side), random.below(side), random.below(3)};
      const std::int64_t length = 1 + random.below(30);
      const bool along_x = random.chance(1, 2);
      draft.vertices.push_back(a);
      draft.vertices.push_back(along_x ? a + Vector{length, 0, 0} : a + Vector{0, length, 0});
      const auto n = static_cast<Vertex>(draft.vertices.size());
      draft.edges.push_back({{n - 2, n - 1}, {}});
    }
    ASSERT_NO_FATAL_FAILURE(compare(draft, tally)) << i;
    ASSERT_NO_FATAL_FAILURE(compare(RandomDrafts::far_away(draft), tally)) << i;
  }
  expect_every_kind(tally);
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
  Coverage tally;
  RandomDrafts drafts(4, 0);
  for (int i = 0; i < 3000; ++i) {
    const Draft draft = tall_draft(drafts.random());
    ASSERT_NO_FATAL_FAILURE(compare(draft, tally)) << i;
    ASSERT_NO_FATAL_FAILURE(compare(RandomDrafts::far_away(draft), tally)) << i;
  }
  EXPECT_GT(tally.valid, 200u);
  expect_every_kind(tally);
}

}  // namespace
}  // namespace ar3d::testing
