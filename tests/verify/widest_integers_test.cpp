// The range check changes no verdict: certificates with it, and in the widest integers without it.

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/certificate.h"
#include "ar3d/verify/predicates/exact.h"
#include "ar3d/verify/predicates/widths.h"
#include "verify/counted_pairs.h"
#include "verify/random_drafts.h"

namespace ar3d::testing {
namespace {

using verify::WidestIntegers;

std::vector<std::string> messages(const Certificate& certificate) {
  std::vector<std::string> all{certificate.valid() ? "valid" : "not valid"};
  for (const Violation& violation : certificate.violations) all.push_back(violation.message);
  return all;
}

template <class Certify>
void expect_same_verdict(Certify&& certify_it, const std::string& what) {
  const std::vector<std::string> narrow = messages(certify_it());
  const WidestIntegers widest;
  EXPECT_EQ(messages(certify_it()), narrow) << what;
}

TEST(WidestIntegersWanted, AreTakenWhileOneLives) {
  EXPECT_EQ(verify::width_of_bits(10), verify::IntegerWidth::int64);
  EXPECT_GT(verify::AngleComparison(kCubeLattice, {-1, 3}).room(), 0);
  {
    const WidestIntegers outer;
    const WidestIntegers inner;
    EXPECT_EQ(verify::width_of_bits(10), verify::IntegerWidth::int256);
    EXPECT_LT(verify::AngleComparison(kCubeLattice, {-1, 3}).room(), 0);
  }
  EXPECT_EQ(verify::width_of_bits(10), verify::IntegerWidth::int64);
}

TEST(WidestIntegersWanted, ChangeNoVerdictOnDrawingsOfEveryFamily) {
  for (const Algorithm* algorithm : proved_algorithms()) {
    for (const Family& family : families()) {
      if (family.max_degree > algorithm->guarantee.max_degree) continue;
      const Graph graph = generate(family, 60, 3);
      const Drawing drawing = draw(*algorithm, graph);
      expect_same_verdict([&] { return certify(graph, drawing, algorithm->guarantee); },
                          algorithm->name + " " + family.name);
    }
  }
}

TEST(WidestIntegersWanted, ChangeNoVerdictOnRandomAndDamagedDrawings) {
  RandomDrafts drafts(3, 10);
  int valid = 0, broken = 0;
  for (std::uint32_t i = 0; i < 2500; ++i) {
    const auto& set = direction_sets()[i % direction_sets().size()];
    Draft draft = simple(drafts.walks(set, 1 + i % 11, 3 + i % 17));
    draft = drafts.damaged(std::move(draft), i % 3);
    if (i % 2 == 1) draft = RandomDrafts::far_away(draft);
    const auto judged = [&] {
      return certify(draft.graph(), draft.drawing(), no_promise(), {.check_size = false});
    };
    ++(judged().valid() ? valid : broken);
    expect_same_verdict(judged, "drawing " + std::to_string(i));
  }
  EXPECT_GT(valid, 300);
  EXPECT_GT(broken, 300);
}

}  // namespace
}  // namespace ar3d::testing
