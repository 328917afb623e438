// Numbers, names and files of generate, draw, replay, hunt and shrink.
#include "support/program.h"
#include "support/results.h"

namespace ar3d::testing {
namespace {

/// One line on stderr that holds `part`, exit code 2, nothing on stdout.
void expect_name_refused(const std::string& command, const std::string& part) {
  const Outcome outcome = run("timeout 20 " + command);
  expect_one_line(outcome, part);
  EXPECT_EQ(outcome.out, "") << command;
}

TEST(Numbers, NegativeAndOverlargeOnesAreRefused) {
  expect_name_refused("{} generate cycle -n -5", "'-5' is not a whole number");
  expect_name_refused("{} generate cycle -n 99999999999999999999", "is not a whole number");
  expect_name_refused("{} generate cycle -n 1e3", "'1e3' is not a whole number");
  expect_name_refused("{} generate cycle -n 9 --count -1", "'-1' is not a whole number");
  expect_name_refused("{} generate cycle -n 9 --count 0", "'0' is not a whole number");
  expect_name_refused("{} generate cycle -n 9 --seed -1", "'-1' is not a whole number");
  expect_name_refused("{} generate random-cubic -n 9 --seed 18446744073709551615 --count 2",
                      "pass");
  expect_name_refused("{} hunt --algorithm grid -n -5", "'-5' is not a whole number");
  expect_name_refused("{} hunt --algorithm grid --seconds nan", "'nan' is not a number");
  expect_name_refused("{} draw - --algorithm grid --turn inf", "'inf' is not a number");
  expect_name_refused("{} replay r.h5 --seed -1", "'-1' is not a whole number");
  expect_name_refused("{} replay r.h5 --sample -1", "'-1' is not a whole number");
  expect_name_refused("{} study count r.h5 --max-n -1", "'-1' is not a whole number");
  expect_name_refused("{} study run smoke --threads -1", "'-1' is not a whole number");
  expect_name_refused("{} study plan smoke --threads 1e9", "'1e9' is not a whole number");
  expect_name_refused("{} compare a.h5 b.h5 --rounds -1", "'-1' is not a whole number");
}

TEST(Numbers, SizesThatAFamilyLacksAreSaid) {
  const Outcome c20 = expect_exit(0, run("{} generate fullerene -n 60"));
  EXPECT_EQ(c20.err,
            "ar3d: fullerene has no graph with 60 vertices for these parameters: this has "
            "20\n");
  EXPECT_THAT(run("{} generate random-cubic -n 0").err, HasSubstr("this has 4"));
  EXPECT_EQ(run("{} generate random-cubic -n 4").err, "");
}

TEST(Names, GraphsWithNamesOfTheirOwn) {
  const Outcome petersen = expect_exit(0, run("{} generate petersen --format graph6"));
  EXPECT_EQ(petersen.err, "");
  EXPECT_EQ(petersen.out.front(), 'I') << "10 vertices";
  expect_name_refused("{} generate petersn", "did you mean 'petersen'?");
  expect_name_refused("{} generate cycle", "-n NUMBER");
}

TEST(Names, UnknownOnesAreAnsweredWithTheNearest) {
  expect_name_refused("{} drwa -", "unknown verb 'drwa'; did you mean 'draw'? (see ar3d --help)");
  expect_name_refused("{} study rum quick", "did you mean 'run'? (see ar3d study --help)");
  expect_name_refused("{} generate cycle -n 9 --sed 3",
                      "did you mean '--seed'? (see ar3d generate --help)");
  expect_name_refused("{} generate cycel -n 9", "did you mean 'cycle'?");
  expect_name_refused("{} generate cycle -n 9 --format grap6", "did you mean 'graph6'?");
  expect_name_refused("{} draw - --algorithm grid --format jsnl", "did you mean 'jsonl'?");
  expect_name_refused(
      "{} draw - --algorithm gird",
      "unknown algorithm 'gird'; did you mean 'grid'? (known: diamond, two-bend, grid, "
      "compact, compact-120, two-bend-109, two-bend-120, two-bend-paper, grid-paper, lattice-109, "
      "lattice-120, routed, routed-120; see: ar3d list algorithms)");
  expect_name_refused(
      "{} draw - --algorithm grid --set efort=2",
      "algorithm grid has no option 'efort'; did you mean 'effort'? (known: effort; see: "
      "ar3d list algorithms)");
  expect_name_refused(
      "{} generate torus -n 9 --parameter row=3",
      "family torus has no parameter 'row'; did you mean 'rows'? (known: rows, shuffle; "
      "see: ar3d list families)");
  expect_name_refused("{} hunt --algorithm grid --measure volum",
                      "did you mean 'volume'? (see ar3d hunt --help)");
  expect_name_refused("{} hunt --algorithm grid --bound theorm", "did you mean 'theorem'?");
  expect_name_refused("{} hunt --algorithm grid --family cycel", "did you mean 'cycle'?");
  expect_name_refused("{} hunt --algorithm grid --seeded-fault wrong-bent",
                      "did you mean 'wrong-bend'?");
  expect_name_refused("{} verify - --crossing-test halvin", "did you mean 'halving'?");
  expect_name_refused("{} list familes", "did you mean 'families'? (see ar3d list --help)");
  expect_name_refused("{} study run smok", "did you mean 'smoke'?");
}

TEST(Files, AnEndingThatIsNoFormatIsRefused) {
  const ScratchDirectory scratch;
  expect_name_refused(
      "{} generate k5 | {} draw - --algorithm diamond -o " + scratch.path("k5.step"),
      "'.step' is no drawing format's ending");
  expect_name_refused("{} generate k5 -o " + scratch.path("k5.step"),
                      "'.step' is no graph format's ending");
  expect_name_refused("{} generate k5 -o " + scratch.path("k5.s6.gz"),
                      "'.gz' is no graph format's");
  EXPECT_TRUE(fs::is_empty(scratch.path("")));
  expect_exit(0, run("{} generate k5 --format edgelist -o " + scratch.path("k5.step")));
}

/// An edge list whose first line may be a header or an edge, wherever a graph file is read.
TEST(Files, AFirstLineIsDecidedByEveryVerbThatReadsGraphs) {
  const ScratchDirectory scratch;
  const std::string graph = scratch.write("g.txt", "2 1\n0 1\n");  // a path of 3, or of 2, vertices
  const std::string drawing = scratch.path("d.jsonl");
  const std::string asks = "--first-line edge or --first-line header says which";
  expect_name_refused("{} draw " + graph + " --algorithm grid", asks);
  must("{} draw " + graph + " --algorithm grid --first-line header -o " + drawing);
  expect_error(run("{} verify " + drawing + " --graphs " + graph), asks);
  expect_exit(0, run("{} verify " + drawing + " --first-line header --graphs " + graph));
  expect_exit(4, run("{} verify " + drawing + " --first-line edge --graphs " + graph));
  const std::string shrink = "{} shrink " + graph + " --algorithm grid --ratio 1e-9 -o ";
  expect_name_refused(shrink + scratch.path("a"), asks);
  EXPECT_THAT(run(shrink + scratch.path("b") + " --first-line header --evaluations 1").out,
              HasSubstr("of 2 vertices"));
  EXPECT_THAT(run(shrink + scratch.path("c") + " --first-line edge --evaluations 1").out,
              HasSubstr("of 3 vertices"));
}

TEST(Files, AStreamIsNoPrefix) {
  expect_name_refused("{} hunt --algorithm grid --evaluations 1 -o -", "not a stream");
  expect_name_refused("{} generate k4 | {} shrink - --algorithm grid --ratio 0.01 -o -",
                      "not a stream");
}

TEST(Files, AnInterruptedGenerateLeavesNothing) {
  const ScratchDirectory scratch;
  run("timeout -s INT 0.3 {} generate random-cubic -n 1000 --count 1000000 -o " +
      scratch.path("many.s6"));
  EXPECT_TRUE(fs::is_empty(scratch.path("")));
}

// Whatever stands in names, drawings and results: of every verb that says something of it.
TEST(Files, EscapeSequencesDoNotReachTheTerminal) {
  const ScratchDirectory scratch;
  const std::string name = scratch.write("\x1b[31m.s6", "\x1b[2J");
  const auto expect_plain = [](const Outcome& outcome) {
    EXPECT_EQ((outcome.out + outcome.err).find('\x1b'), std::string::npos)
        << outcome.command << outcome.out << outcome.err;
  };
  for (const std::string verb : {"draw --algorithm grid ", "verify ", "check ", "report ",
                                 "generate ", "shrink --algorithm grid -o x "}) {
    expect_plain(expect_exit(2, run("{} " + verb + "'" + name + "'")));
  }
  const std::string refused = scratch.write("d.jsonl", "{\"n\":3,\"error\":\"\\u001b[31mred\"}\n");
  expect_plain(run("{} verify " + refused));
  expect_plain(run("{} view " + refused + " -o '" + scratch.path("\x1b[1m.html") + "'"));
  must("printf 'D~{\\n' | {} draw - --algorithm diamond -o " + scratch.path("k5.jsonl"));
  expect_output(
      run("{} view " + scratch.path("k5.jsonl") + " -o '" + scratch.path("\x1b[1m.html") + "'"),
      "\\x1b[1m.html");

  const std::string results = scratch.path("\x1b[7m.h5");
  must("{} study run smoke -q -o '" + results + "'");
  const std::string forge =
      "import h5py, sys; f = h5py.File(sys.argv[1], 'a'); r = f['runs'][:]; e = b'\\x1b[31mred'; "
      "r['family'] = e; r['options'] = e; r['message'] = e; r['status'][3] = b'violated'; "
      "f['runs'][:] = r; f.attrs['source_hash'] = '\\x1b[31mred'; f.attrs['created'] = '\\x1b[5m'; "
      "v = f['environments'][:]; v['value'] = e; f['environments'][:] = v";
  must("/usr/bin/python3 -c \"" + forge + "\" '" + results + "'");
  renew_checksum(results);
  for (const std::string& verb :
       {std::string("check R"), "report R --force -o " + scratch.path("page.html"),
        std::string("study status R"), std::string("replay R --sample 20"),
        std::string("replay R 3"), std::string("compare R R"), std::string("study resume -q R"),
        "study merge R -o " + scratch.path("m.h5"),
        "replay R --keep violated -o " + scratch.path("kept.jsonl"),
        std::string("study count R --max-n 4"), std::string("study plan R"),
        "history add R --place 1 --folder " + scratch.path("h"),
        "history report --folder " + scratch.path("h")}) {
    std::string command = "{} " + verb;
    for (std::size_t at = 0; (at = command.find(" R", at)) != std::string::npos;) {
      command.replace(at, 2, " '" + results + "'");
    }
    expect_plain(run(command));
  }
}

}  // namespace
}  // namespace ar3d::testing
