// How much of a drawing the program writes.
#include <nlohmann/json.hpp>

#include "ar3d/verify/metrics/metrics.h"
#include "support/program.h"

namespace ar3d::testing {
namespace {

std::string drawn_at(const std::string& level, const std::string& family,
                     const std::string& algorithm) {
  const Outcome outcome = run("{} generate " + family + " -n 20 | {} draw - --algorithm " +
                              algorithm + " --level " + level);
  EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 5) << outcome.err;
  return outcome.out;
}

TEST(DrawLevels, ExtentsTellOfTheDrawingInsteadOfWritingIt) {
  for (const std::string algorithm :
       {"diamond", "grid", "two-bend", "compact", "compact-120", "two-bend-109", "grid-paper"}) {
    const nlohmann::json line =
        nlohmann::json::parse(drawn_at("extents", "random-cubic", algorithm));
    EXPECT_EQ(line["level"], "extents");
    EXPECT_EQ(line["verdict"], "proved");
    EXPECT_EQ(line["violations"], 0);
    EXPECT_FALSE(line.contains("vertices"));
    EXPECT_FALSE(line.contains("edges"));
    for (const Metric& metric : metrics()) EXPECT_TRUE(line.contains(metric.name)) << metric.name;
    std::int64_t edges = 0;
    for (int bends = 0; bends < 8; ++bends)
      edges += line["bends_" + std::to_string(bends)].get<int>();
    EXPECT_EQ(edges, 30);
    const auto low = line["box"][0];
    const auto high = line["box"][1];
    const std::string axes = "xyz";
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(high[axis].get<int>() - low[axis].get<int>(),
                line[std::string("extent_") + axes[axis]].get<int>());
    }
  }
}

TEST(DrawLevels, PositionsAreThoseOfTheDrawing) {
  for (const std::string algorithm : {"diamond", "two-bend", "two-bend-paper"}) {
    const auto line = nlohmann::json::parse(drawn_at("positions", "random-cubic", algorithm));
    const auto extents = nlohmann::json::parse(drawn_at("extents", "random-cubic", algorithm));
    const auto full = nlohmann::json::parse(drawn_at("full", "random-cubic", algorithm));
    EXPECT_EQ(line["vertices"], full["vertices"]);
    EXPECT_FALSE(line.contains("edges"));
    EXPECT_EQ(line.contains("unit_exponent"), full.contains("unit_exponent"));
    for (const auto& [key, value] : extents.items()) {
      if (key == "level") continue;
      EXPECT_EQ(line[key], value) << key;
    }
  }
}

TEST(DrawLevels, WhatIsNotProvedIsNoPass) {
  expect_output(
      run("{} generate cycle -n 5 | {} draw - --algorithm two-bend-paper --level extents"),
      "\"verdict\":\"measured\"", 5);
  expect_output(
      run("{} generate random-4-regular -n 10 | {} draw - --algorithm grid --level extents"),
      "\"error\"", 2);
}

TEST(DrawLevels, OtherFormatsAreOfWholeDrawings) {
  const ScratchDirectory scratch;
  const Outcome outcome = expect_exit(
      2, run("{} generate cycle -n 5 | {} draw - --algorithm diamond --level extents -o " +
             scratch.path("c.svg")));
  EXPECT_EQ(outcome.err, "ar3d: --level extents is written as jsonl, not as svg\n");
  expect_exit(2, run("{} draw - --algorithm diamond --level half </dev/null"));
}

// The line of the drawing of 200,000 vertices has 30 MB; the program with the drawing takes less
// than that text would take beside it.
TEST(DrawLevels, LongLinesAreNeverHeldAsAWhole) {
  const ScratchDirectory scratch;
  const std::string graph = scratch.path("g.s6");
  const std::string file = scratch.path("d.jsonl");
  must("{} generate random-4-regular -n 200000 -o " + graph);
  const auto peak_kib = [&](const std::string& output) {
    const Outcome outcome = expect_exit(
        0, run("OMP_NUM_THREADS=1 /usr/bin/python3 -c 'import resource, subprocess, sys; "
               "subprocess.run(sys.argv[1:], check=True); "
               "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)' {} draw " +
               graph + " --algorithm diamond --force -o " + output));
    return std::stol(outcome.out);
  };
  const long peak = peak_kib(file);
  EXPECT_GT(std::stol(run("wc -c < " + file).out), 25L << 20);
#ifndef __SANITIZE_ADDRESS__  // which keeps what is freed
  EXPECT_LT(peak, 70L << 10);
#endif
}

}  // namespace
}  // namespace ar3d::testing
