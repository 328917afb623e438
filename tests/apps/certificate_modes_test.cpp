// Certificates and drawings that are not judged, through the program: draw, verify, study, check,
// replay.
#include "support/program.h"
#include "support/tables.h"

namespace ar3d::testing {
namespace {

TEST(CertificateModes, VerifySaysWhatIsNotProved) {
  const ScratchDirectory scratch;
  const std::string file = scratch.path("d.jsonl");
  must("{} generate random-cubic -n 20 | {} draw - --algorithm two-bend -o " + file);
  const auto verify = [&](const std::string& mode) {
    return run("{} verify " + file + " --certificate " + mode);
  };
  expect_exit(0, verify("exact"));
  expect_output(verify("none"),
                "0 certified, 0 violated, 0 not drawn, 1 not proved (certificate none)", 5);
  expect_error(verify("double"), "certificate 'double' is none of exact and none");
  EXPECT_THAT(verify("exakt").err, HasSubstr("did you mean 'exact'?"));
  expect_exit(2, run("{} verify " + file + " --certificate none --crossing-test halving"));
}

TEST(CertificateModes, WhatIsWrongIsNamedIfItIsJudged) {
  const ScratchDirectory scratch;
  scratch.write("d.jsonl", R"({"n":4,"algorithm":"grid","gram":[[1,0,0],[0,1,0],[0,0,1]],)"
                           R"("gram_denominator":1,"vertices":[[0,0,0],[8,8,0],[8,0,0],[0,8,0]],)"
                           R"("edges":[[0,1,[]],[2,3,[]]]})"
                           "\n");
  expect_output(run("{} verify " + scratch.path("d.jsonl")), "crossing: ", 4);
  expect_exit(5, run("{} verify " + scratch.path("d.jsonl") + " --certificate none"));
}

/// Drawings of programs are kept by studies, too.
TEST(CertificateModes, DrawingsOfUnknownAlgorithmsAreNotJudgedAndTheOthersAre) {
  const ScratchDirectory scratch;
  const std::string file = scratch.path("d.jsonl");
  must("{} generate petersen | {} draw - --algorithm grid > " + file +
       " && sed 's/\"grid\"/\"gird\"/' " + file + " >> " + file + "2; cat " + file + " >> " + file +
       "2");
  expect_output(run("{} verify " + file + "2"),
                {"d.jsonl2:1: not judged: no algorithm here is called 'gird'; "
                 "did you mean 'grid'? (--algorithm judges it",
                 "1 certified, 0 violated, 0 not drawn, 1 not judged\n"},
                5);
  expect_exit(0, run("{} verify " + file + "2 --algorithm grid"));
  expect_exit(2, run("{} verify " + file + " --algorithm gird"));
}

TEST(CertificateModes, VerifyCountsGraphsAndDrawings) {
  const ScratchDirectory scratch;
  const std::string graphs = scratch.path("g.s6"), drawings = scratch.path("d.jsonl");
  must("{} generate random-cubic -n 8 --count 3 -o " + graphs + " && {} draw " + graphs +
       " --algorithm grid -o " + drawings + " && head -2 " + graphs + " > " + graphs +
       "2 && head -1 " + drawings + " > " + drawings + "1");
  EXPECT_THAT(run("{} verify " + drawings + " --graphs " + graphs + "2").err,
              HasSubstr("g.s62 has 2 graphs, but " + drawings + " has more drawings"));
  EXPECT_THAT(run("{} verify " + drawings + "1 --graphs " + graphs).err,
              HasSubstr("g.s6 has more graphs than " + drawings + "1 has drawings: 1"));
}

TEST(CertificateModes, DrawJudgesIfAsked) {
  for (const std::string mode : {"exact", "none"}) {
    expect_output(
        run("{} generate petersen | {} draw - --algorithm two-bend --certificate " + mode),
        "\"algorithm\":\"two-bend\"");
  }
  const std::string draw = "{} generate petersen | {} draw - --algorithm ";
  expect_exit(2, run(draw + "two-bend --certificate ''"));  // verify refuses an empty mode, too
  expect_exit(5, run(draw + "two-bend-paper --certificate exact"));  // nothing proves a real type
  expect_exit(2, run(draw + "two-bend --certificate maybe"));
}

TEST(CertificateModes, RowsOfAStudySayThemAndCheckDoesNotPassThemUnasked) {
  const ScratchDirectory scratch;
  const std::string sweep =
      "[[sweep]]\nfamilies = [\"random-cubic\", \"cycle\"]\nsizes = [12, 40]\n"
      "algorithms = [\"two-bend\", \"grid\"]\n";
  const std::string spec = "study = \"modes\"\ncertificate = \"none\"\n";
  scratch.write("s.toml", spec + sweep);
  scratch.write("a.toml", spec + "accept_unproved = true\n" + sweep);
  const std::string results = scratch.path("r.h5");
  expect_exit(5, run("{} study run " + scratch.path("s.toml") + " -q --force -o " + results));
  expect_output(run("{} check " + results),
                "8 rows, 0 proved, 0 violated, 0 incomplete, 0 refused, 8 not proved", 5);
  expect_exit(0, run("{} check --accept-unproved " + results));
  expect_exit(5, run("{} report --rows " + scratch.path("r.csv") + " --force " + results));
  EXPECT_THAT(read_file(scratch.path("r.csv")), HasSubstr(",none,"));
  expect_exit(0, run("{} replay --all " + results));
  expect_exit(
      0, run("{} study run " + scratch.path("a.toml") + " -q --force -o " + scratch.path("a.h5")));
  scratch.write("s.toml", "study = \"modes\"\ncertificate = \"perhaps\"\n" + sweep);
  expect_error(run("{} study plan " + scratch.path("s.toml")),
               "s.toml:2: certificate 'perhaps' is none of exact");
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
  expect_exit(5, run("{} study run " + scratch.path("s.toml") + " -q -o " + results));
  expect_output(run("{} check " + results),
                "3 rows, 1 proved, 0 violated, 0 incomplete, 0 refused, 2 not proved", 5);
  expect_exit(0, run("{} check --accept-unproved " + results));
  const std::string csv = scratch.path("r.csv"), page = scratch.path("r.html");
  expect_exit(5, run("{} report --rows " + csv + " --force " + results));
  EXPECT_THAT(read_file(csv), HasSubstr(",none,"));
  const nlohmann::json tables = tables_in(read_file(page));
  EXPECT_GT(rows_with(tables["judgements"], "certificate", "none").size(), 0u);
  expect_exit(0, run("{} replay --all " + results));
  for (int row = 0; row < 3; ++row) {
    expect_exit(0, run("{} replay " + results + " " + std::to_string(row)));
  }
}

TEST(CertificateModes, ASweepNamesThemOrIsRefused) {
  const ScratchDirectory scratch;
  const auto error_of = [&](const std::string& lines) {
    scratch.write("s.toml",
                  "study = \"modes\"\n[[sweep]]\nfamilies = \"cycle\"\nsizes = 12\n"
                  "algorithms = \"grid\"\n" +
                      lines);
    return run("{} study plan " + scratch.path("s.toml")).err;
  };
  EXPECT_THAT(error_of("certificate = [\"exact\", \"perhaps\"]\n"),
              HasSubstr("s.toml:6: certificate 'perhaps' is none of exact"));
  EXPECT_THAT(error_of("certificate = []\n"), HasSubstr("s.toml:6: certificate is empty"));
  EXPECT_THAT(error_of("certificate = [\"exact\", \"none\"]\nstrong = { threads = 1 }\n"),
              HasSubstr("strong and weak batches are judged by one certificate"));
}

}  // namespace
}  // namespace ar3d::testing
