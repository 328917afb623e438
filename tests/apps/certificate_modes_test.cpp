// Certificates and drawings that are not judged, through the program: draw, verify, study, check,
// replay.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "support/program.h"

namespace ar3d::testing {
namespace {

using ::testing::HasSubstr;

TEST(CertificateModes, VerifySaysWhatIsNotProved) {
  const ScratchDirectory scratch;
  const std::string file = scratch.path("d.jsonl");
  must(kProgram + " generate random-cubic -n 20 | " + kProgram +
       " draw - --algorithm two-bend -o " + file);
  const auto verify = [&](const std::string& mode) {
    return run(kProgram + " verify " + file + " --certificate " + mode);
  };
  EXPECT_EQ(verify("exact").exit_code, 0);
  EXPECT_THAT(expect_exit(5, verify("none")).out,
              HasSubstr("0 certified, 0 violated, 0 not drawn, 1 not proved (certificate none)"));
  expect_error(verify("double"), "certificate 'double' is none of exact and none");
  EXPECT_THAT(verify("exakt").err, HasSubstr("did you mean 'exact'?"));
  EXPECT_EQ(
      run(kProgram + " verify " + file + " --certificate none --crossing-test slabs").exit_code, 2);
}

TEST(CertificateModes, WhatIsWrongIsNamedIfItIsJudged) {
  const ScratchDirectory scratch;
  scratch.write("d.jsonl", R"({"n":4,"algorithm":"grid","gram":[[1,0,0],[0,1,0],[0,0,1]],)"
                           R"("gram_denominator":1,"vertices":[[0,0,0],[8,8,0],[8,0,0],[0,8,0]],)"
                           R"("edges":[[0,1,[]],[2,3,[]]]})"
                           "\n");
  const Outcome outcome = expect_exit(4, run(kProgram + " verify " + scratch.path("d.jsonl")));
  EXPECT_THAT(outcome.out, HasSubstr("crossing: "));
  EXPECT_EQ(run(kProgram + " verify " + scratch.path("d.jsonl") + " --certificate none").exit_code,
            5);
}

/// Drawings of programs are kept by studies, too.
TEST(CertificateModes, DrawingsOfUnknownAlgorithmsAreNotJudgedAndTheOthersAre) {
  const ScratchDirectory scratch;
  const std::string file = scratch.path("d.jsonl");
  must(kProgram + " generate petersen | " + kProgram + " draw - --algorithm grid > " + file +
       " && sed 's/\"grid\"/\"gird\"/' " + file + " >> " + file + "2; cat " + file + " >> " + file +
       "2");
  const Outcome outcome = expect_exit(5, run(kProgram + " verify " + file + "2"));
  EXPECT_THAT(outcome.out, HasSubstr("d.jsonl2:1: not judged: no algorithm here is called 'gird'; "
                                     "did you mean 'grid'? (--algorithm judges it"));
  EXPECT_THAT(outcome.out, HasSubstr("1 certified, 0 violated, 0 not drawn, 1 not judged\n"));
  EXPECT_EQ(run(kProgram + " verify " + file + "2 --algorithm grid").exit_code, 0);
  expect_exit(2, run(kProgram + " verify " + file + " --algorithm gird"));
}

TEST(CertificateModes, VerifyCountsGraphsAndDrawings) {
  const ScratchDirectory scratch;
  const std::string graphs = scratch.path("g.s6"), drawings = scratch.path("d.jsonl");
  must(kProgram + " generate random-cubic -n 8 --count 3 -o " + graphs + " && " + kProgram +
       " draw " + graphs + " --algorithm grid -o " + drawings + " && head -2 " + graphs + " > " +
       graphs + "2 && head -1 " + drawings + " > " + drawings + "1");
  EXPECT_THAT(run(kProgram + " verify " + drawings + " --graphs " + graphs + "2").err,
              HasSubstr("g.s62 has 2 graphs, but " + drawings + " has more drawings"));
  EXPECT_THAT(run(kProgram + " verify " + drawings + "1 --graphs " + graphs).err,
              HasSubstr("g.s6 has more graphs than " + drawings + "1 has drawings: 1"));
}

TEST(CertificateModes, DrawJudgesIfAsked) {
  for (const std::string mode : {"exact", "none"}) {
    const Outcome outcome = run(kProgram + " generate petersen | " + kProgram +
                                " draw - --algorithm two-bend --certificate " + mode);
    EXPECT_EQ(outcome.exit_code, 0) << mode << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("\"algorithm\":\"two-bend\""));
  }
  EXPECT_EQ(run(kProgram + " generate petersen | " + kProgram +
                " draw - --algorithm two-bend --certificate ''")
                .exit_code,
            2)
      << "verify refuses an empty mode, too";
  EXPECT_EQ(run(kProgram + " generate petersen | " + kProgram +
                " draw - --algorithm two-bend-paper --certificate exact")
                .exit_code,
            5)
      << "nothing proves a real type";
  EXPECT_EQ(run(kProgram + " generate petersen | " + kProgram +
                " draw - --algorithm two-bend --certificate maybe")
                .exit_code,
            2);
}

TEST(CertificateModes, RowsOfAStudySayThemAndCheckDoesNotPassThemUnasked) {
  const ScratchDirectory scratch;
  const std::string sweep =
      "[[sweep]]\nfamilies = [\"random-cubic\", \"cycle\"]\nsizes = [12, 40]\n"
      "algorithms = [\"two-bend\", \"grid\"]\n";
  for (const std::string mode : {"none"}) {
    const std::string spec = "study = \"modes\"\ncertificate = \"" + mode + "\"\n";
    scratch.write("s.toml", spec + sweep);
    scratch.write("a.toml", spec + "accept_unproved = true\n" + sweep);
    const std::string results = scratch.path("r.h5");
    const Outcome study =
        run(kProgram + " study run " + scratch.path("s.toml") + " -q --force -o " + results);
    ASSERT_EQ(study.exit_code, 5) << mode << study.err;
    const Outcome checked = expect_exit(5, run(kProgram + " check " + results));
    EXPECT_THAT(checked.out,
                HasSubstr("8 rows, 0 proved, 0 violated, 0 incomplete, 0 refused, 8 not proved"));
    EXPECT_EQ(run(kProgram + " check --accept-unproved " + results).exit_code, 0) << mode;
    ASSERT_EQ(
        run(kProgram + " report --rows " + scratch.path("r.csv") + " --force " + results).exit_code,
        5);
    EXPECT_THAT(testing::read_file(scratch.path("r.csv")), HasSubstr("," + mode + ","));
    EXPECT_EQ(run(kProgram + " replay " + results + " 1").exit_code, 0) << mode;
    EXPECT_EQ(run(kProgram + " study selfcheck " + results).exit_code, 0) << mode;
    EXPECT_EQ(run(kProgram + " study run " + scratch.path("a.toml") + " -q --force -o " +
                  scratch.path("a.h5"))
                  .exit_code,
              0)
        << mode;
  }
  scratch.write("s.toml", "study = \"modes\"\ncertificate = \"perhaps\"\n" + sweep);
  const Outcome refused = expect_exit(2, run(kProgram + " study plan " + scratch.path("s.toml")));
  EXPECT_THAT(refused.err, HasSubstr("s.toml:2: certificate 'perhaps' is none of exact"));
}

// One drawing, several certificates: each is a row of its own, which says which, and can be
// replayed.
TEST(CertificateModes, OneSweepMayAskForSeveral) {
  const ScratchDirectory scratch;
  const std::string results = scratch.path("r.h5");
  scratch.write("s.toml",
                "study = \"modes\"\n"
                "[[sweep]]\nfamilies = \"random-cubic\"\nsizes = 40\n"
                "algorithms = [\"two-bend\", \"two-bend-paper\"]\n"
                "certificate = [\"exact\", \"none\"]\n");
  const Outcome study =
      run(kProgram + " study run " + scratch.path("s.toml") + " -q -o " + results);
  ASSERT_EQ(study.exit_code, 5) << study.err;
  const Outcome checked = expect_exit(5, run(kProgram + " check " + results));
  EXPECT_THAT(checked.out,
              HasSubstr("3 rows, 1 proved, 0 violated, 0 incomplete, 0 refused, 2 not proved"));
  EXPECT_EQ(run(kProgram + " check --accept-unproved " + results).exit_code, 0);
  const std::string csv = scratch.path("r.csv"), page = scratch.path("r.html");
  ASSERT_EQ(run(kProgram + " report --rows " + csv + " --force " + results).exit_code, 5);
  for (const char* mode : {"none"}) {
    EXPECT_THAT(testing::read_file(csv), HasSubstr(std::string(",") + mode + ","));
    EXPECT_THAT(testing::read_file(page), HasSubstr(std::string("<td>") + mode + "</td>"));
  }
  EXPECT_EQ(run(kProgram + " study selfcheck " + results).exit_code, 0);
  for (int row = 0; row < 3; ++row) {
    expect_exit(0, run(kProgram + " replay " + results + " " + std::to_string(row)));
  }
}

TEST(CertificateModes, ASweepNamesThemOrIsRefused) {
  const ScratchDirectory scratch;
  const auto error_of = [&](const std::string& lines) {
    scratch.write("s.toml",
                  "study = \"modes\"\n[[sweep]]\nfamilies = \"cycle\"\nsizes = 12\n"
                  "algorithms = \"grid\"\n" +
                      lines);
    return run(kProgram + " study plan " + scratch.path("s.toml")).err;
  };
  EXPECT_THAT(error_of("certificate = [\"exact\", \"perhaps\"]\n"),
              HasSubstr("s.toml:6: certificate 'perhaps' is none of exact"));
  EXPECT_THAT(error_of("certificate = []\n"), HasSubstr("s.toml:6: certificate is empty"));
  EXPECT_THAT(error_of("certificate = [\"exact\", \"none\"]\nstrong = { threads = 1 }\n"),
              HasSubstr("strong and weak batches are judged by one certificate"));
}

}  // namespace
}  // namespace ar3d::testing
