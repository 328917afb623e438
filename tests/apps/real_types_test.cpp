// two-bend-paper through the program: draw, verify, study, replay, check, report.
#include "support/program.h"

namespace ar3d::testing {
namespace {

TEST(RealTypes, DrawnExactlyAndJudgedWithoutTolerance) {
  const ScratchDirectory scratch;
  const std::string file = scratch.path("d.jsonl");
  int type = 0;
  for (const std::string name : {"float", "double", "binary80", "binary128", "reference"}) {
    const Outcome drawn = expect_exit(
        0, run("{} generate random-cubic -n 20 | {} draw - --algorithm two-bend-paper --set type=" +
               std::to_string(type++) + " --force -o " + file));
    EXPECT_THAT(read_file(file), HasSubstr("\"real_type\":\"" + name + "\""));
    expect_output(
        run("{} verify " + file),
        {"0 certified, 0 violated, 0 not drawn, 1 measured", "0 crossings, 0 collapsed segments"},
        5);
  }
  EXPECT_THAT(run("{} verify " + file).out, HasSubstr("in reference: "));
}

TEST(RealTypes, ADamagedLineIsMeasuredOrViolated) {
  const std::string line =
      R"({"n":2,"algorithm":"two-bend-paper","real_type":"float","unit_exponent":-1,)"
      R"("vertices":[["0","0","0"],["-6","0","0"]],"edges":[[0,1,[BENDS]]]})";
  const auto judged = [&](const std::string& bends) {
    std::string text = line;
    text.replace(text.find("BENDS"), 5, bends);
    return run("printf '%s\\n' '" + text + "' | {} verify -");
  };
  EXPECT_THAT(judged("").out, HasSubstr("in float: angles miss by at most 0 degrees"));
  expect_output(judged(R"(["0","3","0"])"), "angles miss by at most 56.5651 degrees", 5);
  EXPECT_THAT(judged(R"(["0","0","0"])").out, HasSubstr("1 collapsed segments"));
  expect_output(judged(R"(["0","3","0"],["0","9","9"],["7","9","9"])"),
                "bends: edge 0 has 3 bends, at most 2 are promised", 4);
  expect_exit(4, run("printf '%s\\n' '" + std::string(line).replace(line.find("BENDS"), 5, "") +
                     "' | {} verify - --algorithm two-bend"));
}

TEST(RealTypes, HostileLinesAreRefusedByName) {
  const auto refusal = [&](const std::string& text) {
    const Outcome outcome = expect_exit(2, run("printf '%s\\n' '" + text + "' | {} verify -"));
    return outcome.err;
  };
  const std::string head = R"({"n":1,"algorithm":"two-bend-paper","real_type":"float",)";
  const auto with = [&](const std::string& exponent, const std::string& point) {
    return head + "\"unit_exponent\":" + exponent + ",\"vertices\":[[" + point + "]],\"edges\":[]}";
  };
  EXPECT_THAT(refusal(with("5000", R"("0","0","0")")), HasSubstr("5000 is not in -4000..4000"));
  EXPECT_THAT(refusal(with("0", R"("0","0x1","0")")), HasSubstr("is no decimal integer"));
  EXPECT_THAT(refusal(with("0", R"("0","nan","0")")), HasSubstr("is no decimal integer"));
  EXPECT_THAT(refusal(with("0", R"("0","-","0")")), HasSubstr("is no decimal integer"));
  EXPECT_THAT(refusal(with("0", R"("0","16777217","0")")),
              HasSubstr("vertex 0 has a coordinate of 25 significant bits, float holds 24"));
  for (const char* type : {"", "NaN", "half", "Double"}) {
    const std::string other = std::string(R"({"n":1,"algorithm":"two-bend-paper","real_type":")") +
                              type +
                              R"(","unit_exponent":0,"vertices":[["0","0","0"]],"edges":[]})";
    EXPECT_THAT(refusal(other), HasSubstr("is none of float, double, binary80,")) << type;
  }
  EXPECT_THAT(refusal(with("0", "0,0,0")), HasSubstr("are texts of decimal integers"));
  EXPECT_THAT(refusal(with("0", R"("0","0")")), HasSubstr("2 numbers instead of 3"));
  EXPECT_THAT(refusal(with("0", "\"" + std::string(1001, '7') + "\",\"0\",\"0\"")),
              HasSubstr("more than 1000 characters"));
  EXPECT_THAT(refusal(head + R"("vertices":[["0","0","0"]],"edges":[]})"),
              HasSubstr("key 'unit_exponent' is missing"));
  EXPECT_THAT(refusal(R"({"n":1,"algorithm":"grid","gram":[[1,0,0],[0,1,0],[0,0,1]],)"
                      R"("gram_denominator":1,"vertices":[["0","0","0"]],"edges":[]})"),
              HasSubstr("coordinates are integers"));
}

TEST(RealTypes, RowsSayThatTheyAreMeasuredAndCheckDoesNotPassThemUnasked) {
  const ScratchDirectory scratch;
  const std::string spec =
      "[[sweep]]\nfamilies = [\"random-cubic\", \"union-k4\"]\nsizes = [12, 40]\n"
      "algorithms = [\"two-bend\", { algorithm = \"two-bend-paper\", type = [0, 1, 4] }]\n";
  scratch.write("s.toml", "study = \"real\"\n" + spec);
  const std::string results = scratch.path("r.h5");
  const Outcome study = expect_exit(5, run("{} study run " + scratch.path("s.toml") + " -q -o " +
                                           results));  // twelve rows are not proved
  expect_output(
      run("{} check " + results),
      {"12 not proved", "16 rows, 4 proved, 0 violated, 0 incomplete, 0 refused, 12 not proved"},
      5);
  const Outcome accepted = expect_exit(0, run("{} check --accept-unproved " + results));
  EXPECT_THAT(accepted.out, HasSubstr("12 not proved (accepted)"));
  scratch.write("a.toml", "study = \"real\"\naccept_unproved = true\n" + spec);
  expect_output(run("{} study run " + scratch.path("a.toml") + " -q -o " + scratch.path("a.h5")),
                "12 not proved (accepted)");
  expect_exit(0, run("{} check " + scratch.path("a.h5")));
  for (const char* row : {"0", "1", "2", "3"}) {
    expect_exit(0, run("{} replay " + results + " " + row));
  }
  expect_exit(0, run("{} replay --all " + results));
  expect_exit(0, run("{} report " + scratch.path("a.h5") + " -o " + scratch.path("a.html")));
}

TEST(RealTypes, OutputsThatWouldRoundAreRefusedOrPictures) {
  const ScratchDirectory scratch;
  const std::string draw = "{} generate union-k4 -n 8 | {} draw - --algorithm two-bend-paper -o ";
  expect_exit(0, run(draw + scratch.path("d.svg")));
  expect_exit(2, run("{} hunt --algorithm two-bend-paper -n 20 --evaluations 1"));
}

TEST(RealTypes, TheListSaysWhatIsPromised) {
  const Outcome list = run("{} list algorithms");
  EXPECT_THAT(list.out, HasSubstr("two-bend-paper: "));
  EXPECT_THAT(list.out, HasSubstr("what rounding makes of it is measured; no box"));
  EXPECT_THAT(list.out, HasSubstr("option type = 0..4 (default 1)"));
}

}  // namespace
}  // namespace ar3d::testing
