#include "ar3d/bench/search/hunt.h"

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/certificate.h"
#include "support/graphs.h"

namespace ar3d::testing {
namespace {

Subject subject_of(const char* algorithm, const char* fault = nullptr,
                   const Settings& options = {}) {
  const Algorithm& row = find_algorithm(algorithm);
  return {{&row, complete_options(row, options)}, fault ? &find_seeded_fault(fault) : nullptr};
}

HuntOptions small_hunt(const Subject& subject, std::uint64_t evaluations) {
  HuntOptions options;
  options.n = 24;
  options.evaluations = evaluations;
  options.families = fitting_families(*subject.choice.algorithm, options.n);
  return options;
}

std::vector<std::uint32_t> degrees(const Graph& graph) {
  std::vector<std::uint32_t> all;
  for (Vertex v = 0; v < graph.num_vertices(); ++v) all.push_back(graph.degree(v));
  return all;
}

TEST(Hunt, IsAPureFunctionOfItsSeed) {
  const Subject subject = subject_of("diamond");
  HuntOptions options = small_hunt(subject, 150);
  options.families = {{&find_family("random-4-regular"), {}}};
  const HuntResult once = hunt(subject, options);
  const HuntResult again = hunt(subject, options);
  EXPECT_EQ(graph_hash(once.best.graph), graph_hash(again.best.graph));
  EXPECT_EQ(once.best.ratio, again.best.ratio);
  EXPECT_EQ(once.evaluations, 150u);
  options.seed = 2;
  EXPECT_NE(graph_hash(hunt(subject, options).best.graph), graph_hash(once.best.graph));
}

TEST(Hunt, ClimbsAboveWhereItStarts) {
  Subject subject = subject_of("diamond");
  subject.measure = "volume";
  HuntOptions options = small_hunt(subject, 1);
  options.families = {{&find_family("random-4-regular"), {}}};
  const double start = hunt(subject, options).best.ratio;
  options.evaluations = 400;
  const HuntResult climbed = hunt(subject, options);
  EXPECT_GT(climbed.best.ratio, start);
  EXPECT_LT(climbed.best.ratio, 1) << "a proved bound";
  EXPECT_TRUE(climbed.best.failure.empty()) << climbed.best.message;
}

TEST(Hunt, RatioIsTheShareOfTheAskedBound) {
  Subject subject = subject_of("diamond", nullptr, {{"effort", 2}});
  const Graph graph = generate(find_family("random-4-regular"), 60, 1);
  const Trial side = try_graph(subject, graph);
  const auto ratio = [&](const char* measure) {
    subject.measure = measure;
    return try_graph(subject, graph).ratio;
  };
  double largest = 0, volume = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto extent = static_cast<double>(side.extents[axis]);
    const double bound = subject.choice.algorithm->guarantee.bound.axes[axis].value(60);
    EXPECT_EQ(side.bound[axis], bound);
    largest = std::max(largest, extent / bound);
    volume *= (extent + 1) / (bound + 1);
  }
  EXPECT_DOUBLE_EQ(side.ratio, largest);
  EXPECT_DOUBLE_EQ(ratio("volume"), volume);
  const double z = ratio("z");
  EXPECT_DOUBLE_EQ(z, static_cast<double>(side.extents[2]) / side.bound[2]);
  subject.against_instance = true;
  EXPECT_GE(ratio("z"), z);
  Algorithm silent = find_algorithm("diamond");
  silent.draw = [](const Graph& g, const Settings& values) {
    Drawing drawing = find_algorithm("diamond").draw(g, values);
    drawing.instance_bound.reset();
    return drawing;
  };
  subject.choice.algorithm = &silent;
  EXPECT_THROW(try_graph(subject, graph), InputError);
}

TEST(Hunt, SwitchingKeepsDegreesAndSimplicity) {
  RandomStream random(7);
  Graph graph = generate(find_family("random-subcubic"), 30, 1);
  const std::vector<std::uint32_t> before = degrees(graph);
  const std::string first_hash = graph_hash(graph);
  for (int i = 0; i < 200; ++i) graph = with_switched_edges(graph, random);  // Graph is simple
  EXPECT_EQ(degrees(graph), before);
  EXPECT_NE(graph_hash(graph), first_hash);
  const Graph complete = testing::complete(5);
  EXPECT_EQ(graph_hash(with_switched_edges(complete, random)), graph_hash(complete))
      << "nothing to switch";
}

TEST(SeededFaults, AreFoundAndShrunk) {
  for (const char* algorithm : {"diamond", "grid", "two-bend", "compact"}) {
    for (const std::string fault : {"wrong-bend", "passed-bound"}) {
      SCOPED_TRACE(algorithm + (" " + fault));
      const Subject subject = subject_of(algorithm, fault.c_str());
      HuntOptions options = small_hunt(subject, 2000);
      options.n = 60;
      const Trial found = hunt(subject, options).best;
      ASSERT_FALSE(found.failure.empty());
      if (fault == "passed-bound") {
        EXPECT_EQ(found.failure, "size");
      }
      const auto fails = [&](const Graph& g) {
        return try_graph(subject, g).failure == found.failure;
      };
      Graph least = found.graph;
      std::uint64_t left = 100000;
      EXPECT_TRUE(shrink(least, fails, left));
      EXPECT_LE(least.num_vertices(), 12u);
      EXPECT_TRUE(fails(least));
      EXPECT_TRUE(try_graph(subject_of(algorithm), least).failure.empty())
          << "without the fault the drawing is right";
    }
  }
}

TEST(Shrink, LeavesWhatThePropertyNeeds) {
  const Graph graph = generate(find_family("union-petersen"), 60, 1);
  const auto has_edges = [](std::uint32_t edges) {
    return [edges](const Graph& g) { return g.num_edges() >= edges; };
  };
  std::uint64_t left = 100000;
  Graph seven = graph, nothing = graph, all = graph;
  EXPECT_TRUE(shrink(seven, has_edges(7), left));
  EXPECT_EQ(seven.num_edges(), 7u);
  for (Vertex v = 0; v < seven.num_vertices(); ++v) EXPECT_GT(seven.degree(v), 0u);
  shrink(nothing, has_edges(0), left);
  EXPECT_EQ(nothing.num_vertices(), 0u);
  shrink(all, has_edges(graph.num_edges()), left);
  EXPECT_EQ(graph_hash(all), graph_hash(graph));
}

TEST(Shrink, StopsWhenTheEvaluationsRunOut) {
  Graph graph = generate(find_family("random-cubic"), 100, 1);
  std::uint64_t asked = 0, left = 10;
  const auto keeps = [&](const Graph& g) { return ++asked, g.num_edges() >= 40; };
  EXPECT_FALSE(shrink(graph, keeps, left));
  EXPECT_EQ(asked, 10u);
  EXPECT_EQ(left, 0u);
}

TEST(SeededFault, ShowsOnlyWhereItIsProvoked) {
  const Graph path = testing::path(6);
  for (const SeededFault& fault : seeded_faults()) {
    EXPECT_TRUE(try_graph(subject_of("grid", fault.name.c_str()), path).failure.empty());
  }
  EXPECT_THROW(find_seeded_fault("no-such-fault"), InputError);
}

}  // namespace
}  // namespace ar3d::testing
