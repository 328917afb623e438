#include "ar3d/bench/spec/study_spec.h"

#include <fmt/ranges.h>

#include <fstream>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/generators/catalog.h"
#include "support/parts.h"
#include "support/problem.h"
#include "support/test.h"

namespace ar3d::testing {
namespace {

// A study with one sweep, complete except for what the test puts in.
std::string study_with(const std::string& line) {
  return "study = \"t\"\n[[sweep]]\nfamilies = \"cycle\"\nsizes = 10\nalgorithms = \"diamond\"\n" +
         line + "\n";
}

std::string error_of(const std::string& toml) {
  return problem([&] { parse_study(toml, "t.toml"); }, "no error");
}

TEST(StudySpec, ReadsEveryKey) {
  const StudySpec spec = parse_study(R"(
study = "all-keys"
description = "d"
seed = 7
[max_n]
diamond = 500
[timing]
warm_up = 2
concurrency = 3
write = true
[budget]
study_s = 600
row_time_s = 2
row_time_s_per_vertex = 20e-6
row_memory_bytes = 67108864
[[sweep]]
families = ["cycle", { family = "generalised-petersen", k = [2, 3] }]
sizes = [1000, { from = 10, to = 100, per_decade = 3 }]
algorithms = { algorithm = "diamond", effort = [0, 2] }
instances = 3
repetitions = 4
include = [{ family = "cycle" }]
exclude = [{ algorithm = "diamond", from = 20, to = 30 }]
timed_repetitions = { precision = 0.02, min = 7, max = 9 }
strong = { threads = [1, 2, 4], drawings = 8, repetitions = 3 }
weak = { threads = 1 }
strong_ranks = { ranks = [1, 3], drawings = 9 }
weak_ranks = { ranks = [1, 2], repetitions = 5 }
)",
                                     "t.toml");
  EXPECT_EQ(spec.name, "all-keys");
  EXPECT_EQ(spec.seed, 7u);
  EXPECT_EQ(spec.max_n.at("diamond"), 500u);
  ASSERT_EQ(spec.sweeps.size(), 1u);
  const Sweep& sweep = spec.sweeps[0];
  ASSERT_EQ(sweep.families.size(), 3u);
  EXPECT_EQ(sweep.families[1].parameters, (Settings{{"k", 2}}));
  EXPECT_EQ(sweep.families[2].parameters, (Settings{{"k", 3}}));
  EXPECT_THAT(sweep.sizes, ElementsAre(10, 22, 46, 100, 1000));
  ASSERT_EQ(sweep.algorithms.size(), 2u);
  EXPECT_EQ(value_of(sweep.algorithms[1].options, "effort"), 2);
  EXPECT_EQ(sweep.instances, 3u);
  EXPECT_EQ(sweep.repetitions, 4u);
  EXPECT_TRUE(sweep.include.at(0).matches("cycle", "diamond", 5));
  EXPECT_FALSE(sweep.include.at(0).matches("path", "diamond", 5));
  EXPECT_TRUE(sweep.exclude.at(0).matches("path", "diamond", 30));
  EXPECT_FALSE(sweep.exclude.at(0).matches("path", "diamond", 31));
  EXPECT_EQ(sweep.least_timed, 7u);
  EXPECT_EQ(sweep.most_timed, 9u);
  EXPECT_EQ(sweep.timed_precision, 0.02);
  std::vector<std::string> batches;
  for (const auto& [phase, rules] : sweep.batches) {
    batches.push_back(fmt::format("{} {} {} {}", to_string(phase), fmt::join(rules.workers, ","),
                                  rules.drawings, rules.repetitions));
  }
  EXPECT_THAT(batches,
              ElementsAre("strong 1,2,4 8 3", "weak 1 1 1", "strong_r 1,3 9 1", "weak_r 1,2 1 5"));
  EXPECT_EQ(spec.timing.warm_up, 2u);
  EXPECT_EQ(spec.timing.concurrency, 3u);
  EXPECT_TRUE(spec.timing.write);
  EXPECT_DOUBLE_EQ(spec.budget.study_s.value(), 600);
  EXPECT_DOUBLE_EQ(spec.budget.row_time_s.value()(100000), 4);
  EXPECT_DOUBLE_EQ(spec.budget.row_memory_bytes.value()(1), 67108864);
}

TEST(StudySpec, LaddersGoByDecadesOrByAFactor) {
  const auto sizes = [](const std::string& ladder) {
    return parse_study(
               "study = \"t\"\n[[sweep]]\nfamilies = \"cycle\"\nalgorithms = \"grid\"\nsizes = " +
                   ladder,
               "t.toml")
        .sweeps[0]
        .sizes;
  };
  EXPECT_THAT(sizes("{ from = 3, to = 3000, per_decade = 1 }"), ElementsAre(3, 30, 300, 3000));
  EXPECT_THAT(sizes("{ from = 16, to = 128, factor = 2 }"), ElementsAre(16, 32, 64, 128));
  EXPECT_THAT(sizes("{ from = 10, to = 25, factor = 1.5 }"), ElementsAre(10, 15, 23));
}

TEST(StudySpec, MeasuresAreCheckedWithTheirLine) {
  const auto top = [](const std::string& line) {
    return error_of(line +
                    "\nstudy = \"t\"\n[[sweep]]\nfamilies = \"cycle\"\nsizes = 10\n"
                    "algorithms = \"grid\"\n");
  };
  expect_parts({{top("budget = { study_s = 1 }"), "no error"},
                {top("budget = { study_s_per_vertex = 1 }"), "unknown key 'study_s_per_v"},
                {top("budget = { row_time_s = -1 }"), "t.toml:1: row_time_s = -1 is outside"},
                {top("budget = { row_memory_bytes_per_vertex = \"3\" }"),
                 "t.toml:1: row_memory_bytes_per_vertex is not a number"},
                {top("budget = { time = 1 }"), "unknown key 'time' in budget"},
                {top("timing = { warm_up = -1 }"), "t.toml:1: warm_up = -1 is outside"},
                {top("timing = { write = 1 }"), "write is neither true nor false"},
                {error_of(study_with("timed_repetitions = { precision = 0 }")),
                 "t.toml:6: precision = 0 is outside"},
                {error_of(study_with("timed_repetitions = { precision = 0.1, min = 5 }")),
                 "t.toml:6: min = 5 is outside 6.."},
                {error_of(study_with("timed_repetitions = { precision = 0.1, min = 9, max = 8 }")),
                 "max = 8 is outside 9.."},
                {error_of(study_with("timed_repetitions = { min = 9 }")),
                 "timed_repetitions lacks 'precision'"},
                {error_of(study_with("strong = { threads = [2, 4] }")),
                 "t.toml:6: threads do not begin with 1 and increase"},
                {error_of(study_with("weak = { threads = [1, 2, 2] }")),
                 "threads do not begin with 1 and increase"},
                {error_of(study_with("weak = { drawings = 2 }")), "weak lacks 'threads'"},
                {error_of(study_with("weak_ranks = { ranks = [1, 1] }")),
                 "t.toml:6: ranks do not begin with 1 and increase"},
                {error_of(study_with("strong_ranks = { threads = [1, 2] }")),
                 "unknown key 'threads' in strong_ranks (known: drawings, ranks, "},
                {error_of("study = \"t\"\n[[sweep]]\nfamilies = \"cycle\"\nsizes = "
                          "{ from = 1, to = 5, factor = 1 }\nalgorithms = \"grid\""),
                 "t.toml:4: factor = 1 is outside"}});
}

TEST(StudySpec, AllMeansTheCatalogue) {
  const StudySpec spec = parse_study(
      "study = \"t\"\n[[sweep]]\nfamilies = \"all\"\nsizes = 10\nalgorithms = \"all\"", "t.toml");
  EXPECT_EQ(spec.sweeps[0].families.size(), families().size());
  EXPECT_EQ(spec.sweeps[0].algorithms.size(), proved_algorithms().size());
  const StudySpec shuffled = parse_study(
      "study = \"t\"\n[[sweep]]\nfamilies = { family = \"all\", shuffle = 1 }\nsizes = 10\n"
      "algorithms = \"all\"",
      "t.toml");
  ASSERT_EQ(shuffled.sweeps[0].families.size(), families().size());
  for (const FamilyChoice& family : shuffled.sweeps[0].families) {
    EXPECT_TRUE(is_shuffled(family.parameters));
  }
}

TEST(StudySpec, ErrorsNameFileLineAndValue) {
  EXPECT_THAT(error_of(study_with("")), "no error");
  EXPECT_THAT(error_of("study = \"t\"\nx ="), HasSubstr("t.toml:2: "));
  EXPECT_THAT(error_of(study_with("repetition = 3")),
              HasSubstr("t.toml:6: unknown key 'repetition' in sweep; did you mean 'repetitions'? "
                        "(known: algorithms,"));
  EXPECT_THAT(error_of(study_with("include = []")), HasSubstr("t.toml:6: include is empty"));
  EXPECT_THAT(error_of(study_with("exclude = []")), "no error");
  expect_parts(
      {{error_of("colour = 1\n" + study_with("")), "t.toml:1: unknown key 'colour' in the study"},
       {error_of("study = \"t\""), "the study lacks 'sweep'"},
       {error_of("sede = 1\nzeal = 2"),
        "t.toml:1: unknown key 'sede' in the study; did you mean 'seed'?"},
       {error_of("study = \"t\"\n[[sweep]]\nsizes = 5\ncolour = 3"),
        "t.toml:4: unknown key 'colour' in sweep"},
       {error_of(study_with("strong = { drawing = 2 }")),
        "t.toml:6: unknown key 'drawing' in strong; did you mean 'drawings'?"},
       {error_of(study_with("timed_repetitions = { most = 9 }")),
        "t.toml:6: unknown key 'most' in timed_repetitions"}});
  EXPECT_EQ(error_of(study_with("graphs = { files = \"a\", sampel = 1 }")).substr(0, 54),
            "t.toml:6: unknown key 'sampel' in graphs; did you mean");
  expect_parts(
      {{error_of("study = \"../t\""), "t.toml:1: study name '../t' is not"},
       {error_of("study = 5"), "t.toml:1: study is not a string"},
       {error_of("seed = -1\n" + study_with("")), "t.toml:1: seed = -1 is outside 0.."},
       {error_of(study_with("instances = 0")), "t.toml:6: instances = 0 is outside 1..1000000"},
       {error_of(study_with("instances = \"a\"")), "t.toml:6: instances is not an integer"}});
  EXPECT_THAT(error_of("study = \"t\"\nsweep = []"), HasSubstr("t.toml:2: sweep is empty"));
  EXPECT_THAT(error_of(study_with("exclude = [{ family = \"cycel\" }]")),
              HasSubstr("t.toml:6: unknown family 'cycel'"));
  EXPECT_THAT(error_of(study_with("exclude = [{ size = 3 }]")),
              HasSubstr("t.toml:6: unknown key 'size'"));
  EXPECT_EQ(error_of("certificate = 3\n" + study_with("")),
            "t.toml:1: certificate is not a string");
  EXPECT_EQ(error_of("budget = { row_time_s = \"3\" }\n" + study_with("")),
            "t.toml:1: row_time_s is not a number");
  expect_parts(
      {{error_of("keep_drawings = \"wrost\"\n" + study_with("")),
        "t.toml:1: keep_drawings 'wrost' is none of none, worst, violated and all; "
        "did you mean 'worst'?"},
       {error_of(study_with("level = \"extend\"")), "did you mean 'extents'?"},
       {error_of("max_n = { no = 3 }\n" + study_with("")), "t.toml:1: unknown algorithm 'no'"}});
}

std::string sweep_error(const std::string& families, const std::string& sizes,
                        const std::string& algorithms) {
  return error_of("study = \"t\"\n[[sweep]]\nfamilies = " + families + "\nsizes = " + sizes +
                  "\nalgorithms = " + algorithms);
}

TEST(StudySpec, RefusesBadAxes) {
  const std::string good = "\"diamond\"";
  EXPECT_EQ(sweep_error("\"cycle\"", "10", good), "no error");
  EXPECT_THAT(sweep_error("\"cycel\"", "10", good), HasSubstr("t.toml:3: unknown family 'cycel'"));
  EXPECT_THAT(sweep_error("[]", "10", good), HasSubstr("t.toml:3: families is empty"));
  expect_parts({{sweep_error("{ family = \"cycle\", k = 2 }", "10", good), "t.toml:3: "},
                {sweep_error("{ family = \"generalised-petersen\", k = -5 }", "10", good), "-5"},
                {sweep_error("\"cycle\"", "-3", good), "t.toml:4: size = -3 is outside 0.."},
                {sweep_error("\"cycle\"", "1.5", good), "t.toml:4: size is not an integer"},
                {sweep_error("\"cycle\"", "{ from = 10, to = 5, per_decade = 1 }", good),
                 "to = 5 is outside 10.."},
                {sweep_error("\"cycle\"", "{ from = 10, to = 50, step = 1, per_decade = 1 }", good),
                 "unknown key 'step'"},
                {sweep_error("\"cycle\"", "10", "\"dimond\""),
                 "t.toml:5: unknown algorithm 'dimond'; did you mean 'diamond'?"},
                {sweep_error("\"cycle\"", "10", "{ algorithm = \"diamond\", efort = 1 }"),
                 "t.toml:5: algorithm diamond has no option 'efort'"},
                {sweep_error("\"cycle\"", "10", "{ algorithm = \"diamond\", effort = 99 }"),
                 "t.toml:5: algorithm diamond: option effort = 99 is outside"},
                {sweep_error("\"cycle\"", "10", "{ effort = 1 }"), "algorithm lacks 'algorithm'"}});
}

TEST(StudySpec, NamedStudiesParse) {
  for (const NamedStudy& study : named_studies()) {
    const StudySpec spec = load_study(std::string(study.name)).spec;
    EXPECT_EQ(spec.name, study.name);
    EXPECT_EQ(spec.description, study.summary);
  }
  EXPECT_EQ(find_named_study("none"), nullptr);
}

TEST(StudySpec, LoadsFiles) {
  const auto path = fs::path(::testing::TempDir()) / "ar3d_spec.toml";
  std::ofstream(path) << study_with("repetitions = 2");
  const StudySpec spec = load_study(path.string()).spec;
  EXPECT_EQ(spec.sweeps[0].repetitions, 2u);
  EXPECT_EQ(spec.text, study_with("repetitions = 2"));
  EXPECT_EQ(default_results_path(spec), "ar3d-t.h5");
  fs::remove(path);
  EXPECT_THROW(load_study(path.string()), InputError);
  EXPECT_THROW(load_study(::testing::TempDir()), InputError);
}

}  // namespace
}  // namespace ar3d::testing
