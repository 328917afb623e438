// What `ar3d compare` says of slowdowns of known size in files, on quiet and on loaded machines.
#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/synthetic.h"
#include "ar3d/store/rows.h"
#include "support/program.h"

namespace ar3d::testing {
namespace {

/// How the machine was while one of two files was measured.
struct Machine {
  const char* name;
  double noise;             ///< spread of a time's logarithm
  const char* load_before;  ///< what the environment of the file says
  const char* load_after;
  bool is_loaded;  ///< so that times must not be judged
};
constexpr Machine kQuiet{"quiet", 0.01, "0.10", "1.05", false};
constexpr Machine kMachines[] = {
    kQuiet,
    {"loaded from the beginning", 0.15, "3.90", "4.10", true},
    {"loaded since the study began", 0.15, "0.10", "4.10", true},
};

/// The timed rows of one thread on two cores: 4 families, 5 sizes, 20 repetitions.
Results timed(std::uint64_t seed, const Machine& machine, double factor) {
  Results results = good_results({"grid"}, {"a", "b", "c", "d"}, 5, 1);
  results.environment = {{"cpu", "A", 1},
                         {"cores", "2", 1},
                         {"load_before", machine.load_before, 1},
                         {"load_after", machine.load_after, 1}};
  RandomStream random(seed);
  std::vector<RunRecord> rows;
  for (const RunRecord& row : results.runs) {
    for (std::int64_t repetition = 0; repetition < 20; ++repetition) {
      RunRecord timing = row;
      timing.phase = RunPhase::timing;
      timing.repetition = repetition;
      timing.row_key = "";
      timing.session = 1;
      timing.concurrency = 1;
      timing.wall_s *= factor * std::exp(machine.noise * normal(random));
      rows.push_back(timing);
    }
  }
  results.runs = std::move(rows);
  return results;
}

class Slowdown : public ::testing::TestWithParam<int> {};

TEST_P(Slowdown, IsNeverAPassUnlessTimesWereJudgedAndItIsBelowTheThreshold) {
  const ScratchDirectory scratch;
  const std::string base = scratch.path("base.h5"), now = scratch.path("now.h5");
  const std::string json = scratch.path("verdict.json");
  for (const Machine& before : kMachines) {
    for (const Machine& after : kMachines) {
      write_results(timed(1, before, 1), base);
      write_results(timed(2, after, 1 + GetParam() / 100.0), now);
      const Outcome outcome = run("{} compare " + base + " " + now + " --force --json " + json);
      const auto verdict = nlohmann::json::parse(read_file(json));
      const std::string where =
          std::to_string(GetParam()) + " %, " + before.name + ", then " + after.name;
      RecordProperty(where, verdict.at("verdict").get<std::string>());
      if (before.is_loaded || after.is_loaded) {
        EXPECT_EQ(outcome.exit_code, 7) << where << '\n' << outcome.out;
        EXPECT_EQ(verdict.at("verdict"), "UNJUDGED") << where;
        EXPECT_THAT(outcome.out, HasSubstr("load")) << where;
      } else if (GetParam() > 5) {  // the threshold, from which on a change matters
        EXPECT_EQ(outcome.exit_code, 3) << where << '\n' << outcome.out;
      } else {
        EXPECT_THAT(outcome.exit_code, AnyOf(0, 3, 6)) << where << '\n' << outcome.out;
        EXPECT_THAT(outcome.out, HasSubstr("5")) << where << ": the threshold is named";
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(InFiles, Slowdown, ::testing::Values(3, 5, 10, 20, 50),
                         [](const auto& info) {
                           return "By" + std::to_string(info.param) + "Percent";
                         });

}  // namespace
}  // namespace ar3d::testing
