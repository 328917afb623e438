#include "ar3d/bench/study_spec.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "ar3d/bench/named_studies.h"
#include "ar3d/model/error.h"

namespace ar3d {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// A study with one sweep, complete but for what the test puts in.
std::string study_with(const std::string& line) {
  return "study = \"t\"\n[[sweep]]\nfamilies = \"cycle\"\nsizes = 10\nalgorithms = \"diamond\"\n" +
         line + "\n";
}

std::string error_of(const std::string& toml) {
  try {
    parse_study(toml, "t.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(StudySpec, ReadsEveryKey) {
  const StudySpec spec = parse_study(R"(
study = "all-keys"
description = "d"
seed = 7
[max_n]
diamond = 500
[[sweep]]
families = ["cycle", { family = "generalised-petersen", k = [2, 3] }]
sizes = [1000, { from = 10, to = 100, per_decade = 3 }]
algorithms = { algorithm = "diamond", effort = [0, 2] }
instances = 3
repetitions = 4
include = [{ family = "cycle" }]
exclude = [{ algorithm = "diamond", from = 20, to = 30 }]
)",
                                     "t.toml");
  EXPECT_EQ(spec.name, "all-keys");
  EXPECT_EQ(spec.seed, 7u);
  EXPECT_EQ(spec.max_n.at("diamond"), 500u);
  ASSERT_EQ(spec.sweeps.size(), 1u);
  const Sweep& sweep = spec.sweeps[0];
  ASSERT_EQ(sweep.families.size(), 3u);
  EXPECT_EQ(sweep.families[1].parameters, (ParameterValues{{"k", 2}}));
  EXPECT_EQ(sweep.families[2].parameters, (ParameterValues{{"k", 3}}));
  EXPECT_THAT(sweep.sizes, ElementsAre(10, 22, 46, 100, 1000));
  ASSERT_EQ(sweep.algorithms.size(), 2u);
  EXPECT_EQ(option(sweep.algorithms[1].options, "effort"), 2);
  EXPECT_EQ(sweep.instances, 3u);
  EXPECT_EQ(sweep.repetitions, 4u);
  EXPECT_TRUE(sweep.include.at(0).matches("cycle", "diamond", 5));
  EXPECT_FALSE(sweep.include.at(0).matches("path", "diamond", 5));
  EXPECT_TRUE(sweep.exclude.at(0).matches("path", "diamond", 30));
  EXPECT_FALSE(sweep.exclude.at(0).matches("path", "diamond", 31));
}

TEST(StudySpec, AllMeansTheCatalogue) {
  const StudySpec spec = parse_study(
      "study = \"t\"\n[[sweep]]\nfamilies = \"all\"\nsizes = 10\nalgorithms = \"all\"", "t.toml");
  EXPECT_EQ(spec.sweeps[0].families.size(), families().size());
  EXPECT_EQ(spec.sweeps[0].algorithms.size(), algorithms().size());
}

TEST(StudySpec, ErrorsNameFileLineAndValue) {
  EXPECT_THAT(error_of(study_with("")), "no error");
  EXPECT_THAT(error_of("study = \"t\"\nx ="), HasSubstr("t.toml:2: "));
  EXPECT_THAT(error_of(study_with("repetition = 3")),
              HasSubstr("t.toml:6: unknown key 'repetition' in sweep (known: algorithms,"));
  EXPECT_THAT(error_of("colour = 1\n" + study_with("")),
              HasSubstr("t.toml:1: unknown key 'colour' in the study"));
  EXPECT_THAT(error_of("study = \"t\""), HasSubstr("the study lacks 'sweep'"));
  EXPECT_THAT(error_of("study = \"../t\""), HasSubstr("t.toml:1: study name '../t' is not"));
  EXPECT_THAT(error_of("study = 5"), HasSubstr("t.toml:1: study is not a string"));
  EXPECT_THAT(error_of("seed = -1\n" + study_with("")),
              HasSubstr("t.toml:1: seed = -1 is outside 0.."));
  EXPECT_THAT(error_of(study_with("instances = 0")),
              HasSubstr("t.toml:6: instances = 0 is outside 1..1000000"));
  EXPECT_THAT(error_of(study_with("instances = \"a\"")),
              HasSubstr("t.toml:6: instances is not an integer"));
  EXPECT_THAT(error_of("study = \"t\"\nsweep = []"), HasSubstr("t.toml:2: sweep is empty"));
  EXPECT_THAT(error_of(study_with("exclude = [{ family = \"cycel\" }]")),
              HasSubstr("t.toml:6: unknown family 'cycel'"));
  EXPECT_THAT(error_of(study_with("exclude = [{ size = 3 }]")),
              HasSubstr("t.toml:6: unknown key 'size'"));
  EXPECT_THAT(error_of("max_n = { no = 3 }\n" + study_with("")),
              HasSubstr("t.toml:1: unknown algorithm 'no'"));
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
  EXPECT_THAT(sweep_error("{ family = \"cycle\", k = 2 }", "10", good), HasSubstr("t.toml:3: "));
  EXPECT_THAT(sweep_error("{ family = \"generalised-petersen\", k = -5 }", "10", good),
              HasSubstr("-5"));
  EXPECT_THAT(sweep_error("\"cycle\"", "-3", good),
              HasSubstr("t.toml:4: size = -3 is outside 0.."));
  EXPECT_THAT(sweep_error("\"cycle\"", "1.5", good), HasSubstr("t.toml:4: size is not an integer"));
  EXPECT_THAT(sweep_error("\"cycle\"", "{ from = 10, to = 5, per_decade = 1 }", good),
              HasSubstr("to = 5 is outside 10.."));
  EXPECT_THAT(sweep_error("\"cycle\"", "{ from = 10, to = 50, step = 1, per_decade = 1 }", good),
              HasSubstr("unknown key 'step'"));
  EXPECT_THAT(sweep_error("\"cycle\"", "10", "\"dimond\""),
              HasSubstr("t.toml:5: unknown algorithm 'dimond' (known: diamond"));
  EXPECT_THAT(sweep_error("\"cycle\"", "10", "{ algorithm = \"diamond\", efort = 1 }"),
              HasSubstr("t.toml:5: algorithm diamond has no option 'efort'"));
  EXPECT_THAT(sweep_error("\"cycle\"", "10", "{ algorithm = \"diamond\", effort = 99 }"),
              HasSubstr("t.toml:5: option effort = 99 is outside"));
  EXPECT_THAT(sweep_error("\"cycle\"", "10", "{ effort = 1 }"),
              HasSubstr("algorithm lacks 'algorithm'"));
}

TEST(StudySpec, NamedStudiesParse) {
  for (const NamedStudy& study : named_studies()) {
    const StudySpec spec = load_study(std::string(study.name));
    EXPECT_EQ(spec.name, study.name);
    EXPECT_EQ(spec.description, study.description);
  }
  EXPECT_EQ(find_named_study("none"), nullptr);
}

TEST(StudySpec, LoadsFiles) {
  const auto path = std::filesystem::path(::testing::TempDir()) / "ar3d_spec.toml";
  std::ofstream(path) << study_with("repetitions = 2");
  const StudySpec spec = load_study(path.string());
  EXPECT_EQ(spec.sweeps[0].repetitions, 2u);
  EXPECT_EQ(spec.text, study_with("repetitions = 2"));
  EXPECT_EQ(default_results_path(spec), "ar3d-t.h5");
  std::filesystem::remove(path);
  EXPECT_THROW(load_study(path.string()), InputError);
  EXPECT_THROW(load_study(::testing::TempDir()), InputError);
}

}  // namespace
}  // namespace ar3d
