// What the command line understands and says of itself: help, defaults, choices, wrong verbs.
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/generators/catalog.h"
#include "support/program.h"

namespace ar3d::testing {
namespace {

/// @return the path of a study of `grid` on cycles of those sizes.
std::string cycles(const ScratchDirectory& scratch, const std::string& sizes) {
  return scratch.write("s.toml", "study = 's'\n[[sweep]]\nfamilies = 'cycle'\nsizes = " + sizes +
                                     "\nalgorithms = 'grid'\n");
}

TEST(CommandLine, HelpTellsWhatItsFlagTells) {
  EXPECT_EQ(run("{} help").out, run("{} --help").out);
  for (const char* verb : {"draw", "study run", "history report", "help"}) {
    EXPECT_EQ(expect_exit(0, run(std::string("{} help ") + verb)).out,
              run(std::string("{} ") + verb + " --help").out);
  }
  EXPECT_EQ(run("{} -V").out, run("{} --version").out);
  expect_error(run("{} help darw"), "unknown verb 'darw'; did you mean 'draw'?");
  expect_error(run("{} help study rum"), "unknown verb 'rum'; did you mean 'run'?");
}

TEST(CommandLine, HelpShowsDefaultsAndNoInnerNames) {
  EXPECT_THAT(run("{} help generate").out, HasSubstr("--count UINT:NUMBER=1 "));
  EXPECT_THAT(run("{} help draw").out, HasSubstr("-o,--output TEXT=- "));
  EXPECT_THAT(run("{} help compare").out, HasSubstr("ar3d compare [OPTIONS] [FILE...]"));
  for (const char* verb : {"draw", "study plan", "study run", "study resume", "verify", "compare",
                           "history report", "hunt", "shrink", "replay"}) {
    const std::string help = run(std::string("{} help ") + verb).out;
    for (const char* wrong : {"0x)", "=[]", "=-1", "threads INT:NUMBER=", "default "}) {
      EXPECT_THAT(help, Not(HasSubstr(wrong))) << verb;
    }
  }
}

TEST(CommandLine, AnOptionOfAnAlgorithmOrFamilyIsASetting) {
  const std::string draw = "{} draw - --algorithm diamond --effort";
  expect_error(run(draw + " 2"), "not expected: '--effort'; did you mean '--set effort=2'?");
  expect_error(run(draw + "=2"), "did you mean '--set effort=2'?");
  expect_error(run("{} generate torus -n 9 --rows 3"), "did you mean '--set rows=3'?");
  EXPECT_EQ(run("{} generate torus -n 9 --set rows=3").out,
            run("{} generate torus -n 9 --parameter rows=3").out);
  expect_error(run("{} hunt --algorithm grid --rows=3"), "did you mean '--set rows=3'?");
  const std::string hunt = "{} hunt --algorithm grid --family random-regular -n 8 --evaluations 2 ";
  EXPECT_EQ(expect_exit(0, run(hunt + "--set degree=3 --set effort=0")).out,
            run(hunt + "--parameter degree=3 --set effort=0").out);
  expect_error(run(hunt + "--set rows=3"), "algorithm grid has no option 'rows'");
  expect_error(run("{} generate torus -n 9 --effort 2"), "not expected: '--effort' (see ");
}

TEST(CommandLine, WithoutAVerbItShowsTheVerbs) {
  expect_error(run("{}"), {"study ", "draw ", "Exit codes:"});
}

TEST(CommandLine, AFileIsNotWrittenUnderAnothersEnding) {
  const ScratchDirectory scratch;
  const std::string line = scratch.path("k4.jsonl");
  must("{} generate k4 | {} draw - -o " + line + " 2>&1");
  expect_one_line(run("{} view " + line + " -o " + scratch.path("d.svg")),
                  "this file is written as .html, not as .svg");
  expect_one_line(run("{} report r.h5 -o r.pdf"), "this file is written as .html, not as .pdf");
  expect_one_line(run("{} study run smoke -o out.csv"), "written as .h5, not as .csv");
  expect_exit(0, run("{} view " + line + " -o " + scratch.path("page")));
}

TEST(CommandLine, TheDegreeDecidesWhatDraws) {
  const ScratchDirectory scratch;
  const std::string graphs = scratch.path("g.g6");
  must("{} generate petersen -o " + graphs + " && {} generate k5 --format graph6 >>" + graphs +
       " && {} generate k4 --format graph6 >>" + graphs);
  const Outcome drawn = expect_exit(0, run("{} draw " + graphs + " -o " + scratch.path("d.jsonl")));
  EXPECT_EQ(drawn.err,
            "ar3d: " + graphs +
                ":1: degree 3, drawn with grid; --algorithm says otherwise\nar3d: " + graphs +
                ":2: degree 4, drawn with diamond; --algorithm says otherwise\n");
  expect_output(run("{} verify " + scratch.path("d.jsonl") + " --graphs " + graphs),
                "3 certified, 0 violated");
  EXPECT_EQ(run("{} generate petersen | {} draw - --set effort=2").out,
            run("{} generate petersen | {} draw - --algorithm grid --set effort=2").out);
  EXPECT_EQ(run("{} generate petersen | {} draw - --format svg").err,
            "ar3d: <stdin>:1: degree 3, drawn with grid; --algorithm says otherwise\n");
  expect_error(run("{} draw " + graphs + " --set width=2"), "algorithm grid has no option 'width'");
  EXPECT_EQ(run("{} draw " + graphs + " --algorithm diamond").err, "");
  expect_one_line(run("printf '0 1\\n0 2\\n0 3\\n0 4\\n0 5\\n' | {} draw -"), "degree 5");
}

TEST(CommandLine, DrawingsAndGraphsAreToldApart) {
  const ScratchDirectory scratch;
  const std::string graph = scratch.path("g.s6"), drawing = scratch.path("d.jsonl");
  must("{} generate petersen -o " + graph + " && {} draw " + graph + " --algorithm grid -o " +
       drawing);
  EXPECT_EQ(expect_exit(2, run("{} draw " + drawing)).err,
            "ar3d: " + drawing + ":1: these are drawings, no graphs; `ar3d verify` judges them\n");
  for (const char* verb : {"verify ", "view "}) {
    EXPECT_EQ(
        expect_exit(2, run("{} " + (verb + graph))).err,
        "ar3d: " + graph + ":1: this is a graph (sparse6), no drawing; `ar3d draw` draws it\n");
  }
  expect_error(run("{} verify - <" + graph), "<stdin>:1: this is a graph (sparse6)");
  expect_error(run("echo '[]' | {} verify -"), "<stdin>:1");
}

TEST(CommandLine, PlansNameCellsAsTheOtherVerbsDoAndSizesInUnits) {
  const ScratchDirectory scratch;
  const std::string spec = scratch.write("s.toml", R"(study = "s"
[[sweep]]
families = { family = "random-regular", degree = 3 }
sizes = 16
algorithms = "grid"
)");
  const Outcome plan = run("{} study plan " + spec);
  EXPECT_THAT(plan.out,
              HasSubstr("grid (effort=1) on random-regular (degree=3) n=16: 1 instances"));
  EXPECT_THAT(plan.out, Not(HasSubstr("e+")));
  EXPECT_THAT(plan.err, HasSubstr("ar3d: 1 graphs planned; small ones are drawn to estimate"));
  EXPECT_THAT(plan.out, ::testing::ContainsRegex(" [0-9.]+ (bytes|kB|MB) per row"));
}

/// The one JSON object that a command prints, all of it.
nlohmann::json json_of(const std::string& command, int exit_code = 0) {
  const Outcome outcome = expect_exit(exit_code, run(command));
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 1) << outcome.out;
  return nlohmann::json::parse(outcome.out, nullptr, false);
}

TEST(CommandLine, CataloguesAndPlansAreJsonIfAsked) {
  const nlohmann::json all = json_of("{} list --json");
  EXPECT_EQ(all.at("algorithms").size(), algorithms().size());
  EXPECT_EQ(all.at("algorithms")[0].at("box").size(), 3u);
  EXPECT_EQ(all.at("families").size(), families().size());
  const nlohmann::json one = json_of("{} list metrics --json");
  EXPECT_EQ(one.size(), 1u);
  EXPECT_EQ(one.at("metrics"), all.at("metrics"));
  const nlohmann::json plan = json_of("{} study plan smoke --json");
  std::size_t rows = 0;
  for (const nlohmann::json& cell : plan.at("cells")) rows += cell.at("rows").get<std::size_t>();
  EXPECT_EQ(plan.at("rows"), rows);
  EXPECT_EQ(plan.at("cells")[0].at("cell"), "diamond (effort=1) on edgeless n=4");
  EXPECT_GT(plan.at("largest_row_bytes"), 0);
}

TEST(CommandLine, FamiliesBeyondADegreeAreLinesOfThePlan) {
  const ScratchDirectory scratch;
  const std::string spec = scratch.write("s.toml", R"(study = "s"
[[sweep]]
families = ["cycle", "torus", "hypercube"]
sizes = 16
algorithms = ["grid", "diamond"]
)");
  expect_output(run("{} study plan " + spec),
                "left out: grid draws degree 3 at most, not hypercube, torus\n");
  EXPECT_EQ(json_of("{} study plan -q --json " + spec).at("left_out").at("grid").size(), 2u);
}

/// What stands for the verbs below `above` in its help, sub-verbs for those that have some.
std::vector<std::string> verbs_below(const std::string& above) {
  std::istringstream help(run("{} help" + above).out);
  std::vector<std::string> verbs;
  std::string line;
  while (std::getline(help, line) && line != "Subcommands:") continue;
  while (std::getline(help, line) && line.starts_with("  ")) {
    if (line[2] == ' ') continue;
    const std::string verb = above + " " + line.substr(2, line.find(' ', 2) - 2);
    const std::vector<std::string> below = verbs_below(verb);
    verbs.insert(verbs.end(), below.begin(), below.end());
    if (below.empty()) verbs.push_back(verb);
  }
  return verbs;
}

TEST(CommandLine, EveryVerbIsQuietIfAskedAndTellsItsResultAsJson) {
  const std::set<std::string> to_a_file = {" report", " compare", " history report"};
  // What these make is a file, or stands on standard output in a format of its own.
  const std::set<std::string> has_none = {" generate", " draw", " view", " play", " figures"};
  const std::vector<std::string> verbs = verbs_below("");
  EXPECT_EQ(verbs.size(), 23u);
  for (const std::string& verb : verbs) {
    const std::string help = run("{} help" + verb).out;
    const bool is_help = verb == " help";
    EXPECT_EQ(help.find("-q,--quiet") != std::string::npos, !is_help) << verb;
    EXPECT_EQ(help.find("--json TEXT") != std::string::npos, to_a_file.contains(verb)) << verb;
    EXPECT_EQ(help.find("--json ") == std::string::npos, is_help || has_none.contains(verb))
        << verb;
  }
}

TEST(CommandLine, ResultsAreJsonIfAsked) {
  const ScratchDirectory scratch;
  const std::string at = "cd " + scratch.path("") + "; {} ";
  cycles(scratch, "[5, 6]");
  EXPECT_EQ(json_of(at + "study run --json -q s.toml -o r.h5").at("proved"), 2);
  EXPECT_EQ(json_of(at + "study resume --json r.h5").at("results"), "r.h5");
  EXPECT_EQ(json_of(at + "study merge --json r.h5 -o m.h5").at("rows"), 2);
  EXPECT_EQ(json_of(at + "study count --json r.h5").at("drawings").size(), 2u);
  EXPECT_EQ(json_of(at + "replay --json r.h5 1").at("differing_columns").size(), 0u);
  EXPECT_EQ(json_of(at + "replay --json --all r.h5").at("replayed"), 2);
  EXPECT_EQ(json_of(at + "hunt r.h5 1 --evaluations 3 --json -o w").at("evaluations"), 3);
  EXPECT_EQ(json_of(at + "shrink r.h5 1 --ratio 1e-9 --json -o v").at("minimal"), true);
  EXPECT_EQ(json_of(at + "history add --json --name a --place 1 r.h5").size(), 1u);
  for (const char* verb : {"report r.h5 --json -", "compare --time-always r.h5 r.h5 --json -",
                           "history report --json -"}) {
    const Outcome told = run(at + verb);
    EXPECT_TRUE(nlohmann::json::parse(told.out, nullptr, false).is_object()) << verb << told.out;
  }
  expect_error(run(at + "compare r.h5 r.h5 --json - --markdown -"), "takes one of them");
  expect_error(run(at + "replay r.h5 0 --json -o -"), "takes one of them");
  for (const char* verb :
       {"study resume r.h5", "study plan s.toml", "hunt r.h5 1 --evaluations 3"}) {
    EXPECT_EQ(run(at + verb + " -q").err, "") << verb;
    EXPECT_NE(run(at + verb + " -q").out, "") << verb;
  }
}

TEST(CommandLine, VerdictsAreJsonIfAsked) {
  const ScratchDirectory scratch;
  const std::string results = scratch.path("r.h5"), drawing = scratch.path("d.jsonl");
  const std::string spec = cycles(scratch, "[5, 6]");
  must("{} study run -q " + spec + " -o " + results);
  const nlohmann::json check = json_of("{} check --json " + results);
  EXPECT_EQ(check.at("verdict"), "PASS");
  EXPECT_EQ(check.at("proved"), 2);
  EXPECT_EQ(check.at("findings").size(), 0u);
  const nlohmann::json status = json_of("{} study status --json " + results);
  EXPECT_EQ(status.at("planned_rows"), 2);
  EXPECT_EQ(status.at("complete"), true);
  EXPECT_EQ(status.at("check"), check);
  must("{} generate k4 | {} draw - --algorithm grid -o " + drawing);
  EXPECT_EQ(json_of("{} verify --json " + drawing).at("certified"), 1);
  const nlohmann::json broken =
      json_of("sed 's/\\[\\[-\\?[0-9]*,/[[9,/' " + drawing + " | {} verify - --json", 4);
  EXPECT_EQ(broken.at("violated"), 1);
  EXPECT_EQ(broken.at("messages")[0].at("verdict"), "violated");
  EXPECT_THAT(broken.at("messages")[0].at("text"), HasSubstr("<stdin>:1: "));
}

}  // namespace
}  // namespace ar3d::testing
