// What the one who starts the program may leave it: closed descriptors, full disks, small stacks,
// ignored signals, missing packages; folders of which a part cannot be read.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "ar3d/bench/replay/replay_row.h"
#include "ar3d/store/run_storage.h"
#include "support/program.h"
#include "support/results.h"

namespace ar3d::testing {
namespace {

class Start : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return scratch_.path(name); }
  /// Five stars of degree 3, about each of which `draw` says something.
  std::string stars() const { return scratch_.write("g.g6", "Ct\nCt\nCt\nCt\nCt\n"); }

  /// A study of one program that takes half a second for a drawing.
  std::string slow_study() const {
    scratch_.write("slow.py", R"(import sys, time
while True:
    n, m = map(int, sys.stdin.readline().split())
    for _ in range(m): sys.stdin.readline()
    time.sleep(0.5)
    print('{"vertices":' + str([[i, i * i, i ** 3] for i in range(n)]) + '}', flush=True)
)");
    return scratch_.write("slow.toml",
                          "study = \"s\"\n[[algorithm]]\nname = \"slow\"\ncommand = "
                          "[\"/usr/bin/python3\", \"" +
                              path("slow.py") +
                              "\"]\n[[sweep]]\nfamilies = \"cycle\"\nsizes = [5, 6, 7, 8]\n"
                              "algorithms = \"slow\"\n");
  }

  ScratchDirectory scratch_;
};

TEST_F(Start, ClosedDescriptorsPutNoMessageIntoFiles) {
  const std::string graphs = stars();
  must("{} draw " + graphs + " -o " + path("good.jsonl"));
  must("{} study run smoke -q -o " + path("good.h5"));
  for (const std::string closed : {"1>&- 2>&-", "0<&- 2>&-", "0<&- 1>&- 2>&-", "2>&-"}) {
    expect_exit(0, run("{} draw " + graphs + " -o " + path("a.jsonl") + " --force " + closed));
    EXPECT_EQ(read_file(path("a.jsonl")), read_file(path("good.jsonl"))) << closed;
    const bool is_silent = closed.find("1>") != std::string::npos;  // its verdict cannot be said
    expect_exit(is_silent ? 2 : 0, run("{} study run smoke --force -o " + path("r.h5 ") + closed));
    expect_same_rows(path("r.h5"), path("good.h5"));
  }
  expect_error(run("{} draw - 0<&-"), "cannot read");
  expect_error(run("{} list families 1>&-"), "cannot write to standard output");
}

TEST_F(Start, StandardErrorThatIsFullChangesNoExitCode) {
  const std::string graphs = stars();
  must("{} draw " + graphs + " -o " + path("good.jsonl"));
  expect_exit(0, run("{} draw " + graphs + " -o " + path("a.jsonl") + " 2>/dev/full"));
  EXPECT_EQ(read_file(path("a.jsonl")), read_file(path("good.jsonl")));
  std::istringstream verbs(run(R"(verbs() { {} $1 --help |
      sed -n '/^Subcommands:/,/^[A-Z].*:$/s/^  \([a-z]*\)  .*/\1/p'; }
      verbs; for v in study history; do verbs $v | sed "s/^/$v /"; done)")
                               .out);
  std::size_t tried = 0;
  for (std::string verb; std::getline(verbs, verb); ++tried) {
    for (const std::string how : {" nofile 2>/dev/full", " nofile 2>&-", " --nosuch 2>/dev/full"}) {
      expect_exit(2, run("{} " + verb + how));
    }
  }
  EXPECT_GE(tried, 23u) << "verbs";
}

TEST_F(Start, SmallStacksFilesAndIgnoredChildrenAreNoCrash) {
  const std::string graphs = stars();
  const std::string small = "ulimit -s 64; export OMP_STACKSIZE=64k; {} ";
  expect_exit(0, run(small + "draw " + graphs + " -o " + path("v.html")));
  expect_exit(0, run(small + "study run smoke -q -o " + path("r.h5")));
  expect_exit(0, run(small + "report " + path("r.h5") + " -o " + path("s.html")));
  expect_error(run("ulimit -f 1; {} generate cycle -n 10000 -o " + path("large.s6")),
               "File too large");
  EXPECT_FALSE(fs::exists(path("large.s6")));
  scratch_.write("valgrind", "#!/bin/sh\n[ $1 = --version ] || exit 3\n");
  must("chmod +x " + path("valgrind"));
  expect_error(
      run("PATH=" + path("") +
          ":$PATH python3 -c 'import os, signal, sys; "
          "signal.signal(signal.SIGCHLD, signal.SIG_IGN); os.execv(sys.argv[1], sys.argv[1:])' "
          "{} study count " +
          path("r.h5")),
      "callgrind ended with code 3");
}

TEST_F(Start, AFifoIsRefusedAndAPipeIsRead) {
  must("mkfifo " + path("f.g6"));
  const std::string graphs = stars(), fifo = path("f.g6");
  for (const std::string verb : {"draw ", "study run ", "study plan ", "study run --graphs ",
                                 "hunt --algorithm grid --graphs ", "verify "}) {
    expect_error(run("timeout 10 {} " + verb + fifo), "f.g6");
  }
  expect_error(run("timeout 10 {} draw " + fifo), "it is a FIFO");
  expect_exit(0, run("cat " + graphs + " | {} draw -"));
  expect_exit(0, run("cat " + graphs + " | {} draw /dev/stdin"));
  expect_exit(0, run("{} draw <(cat " + graphs + ")"));
}

TEST_F(Start, ValgrindThatHangsEndsWithTheProgram) {
  must("{} study run smoke -q -o " + path("r.h5"));
  scratch_.write("valgrind", "#!/bin/sh\n[ $1 = --version ] || sleep 7777\n");
  fs::create_directory(path("tmp"));
  must("chmod +x " + path("valgrind"));
  const Outcome outcome =
      run("export PATH=" + path("") + ":$PATH TMPDIR=" + path("tmp") + "; {} study count " +
          path("r.h5") + " & p=$!; until ls " + path("tmp") +
          " | grep -q callgrind; do sleep 0.05; done; sleep 0.5; "
          "kill -TERM $p; wait $p; echo $?; ls " +
          path("tmp"));
  EXPECT_EQ(outcome.out, "130\n") << "and no folder is left";
}

TEST_F(Start, AHangupEndsAStudyAsTermDoesUnlessItIsIgnored) {
  const std::string file = path("r.h5");
  const std::string begun = "{} study run -q " + slow_study() + " --threads 1 -o " + file +
                            " > /dev/null 2>&1 & p=$!; until {} study status " + file +
                            " 2>/dev/null | grep -q ': [1-9]'; do sleep 0.05; done; kill -HUP $p; "
                            "wait $p; echo $?";
  EXPECT_EQ(run(begun).out, "130\n");
  expect_exit(0, run("{} study resume -q " + file));
  fs::remove(file);
  EXPECT_EQ(run("trap '' HUP; " + begun).out, "0\n") << "nohup holds";
}

// A process from before leaves one behind while the study's program draws.
TEST_F(Start, ProcessesOfOthersLiveOn) {
  const std::string script = scratch_.write(
      "script.sh", "(sleep 777 & echo $! > " + path("pid") + "; exec sleep 1) &\nexec " +
                       run("echo -n {}").out + " study run -q " + slow_study() +
                       " --threads 1 -o " + path("r.h5") + " > /dev/null\n");
  expect_exit(0, run("bash " + script));
  EXPECT_EQ(run("kill $(cat " + path("pid") + ")").exit_code, 0) << "it was there";
}

TEST_F(Start, ResultsAreReadWithoutProc) {
  must("{} study run smoke -q -o " + path("r.h5"));
  const std::string without = "unshare --map-root-user --mount bash -c 'mount -t tmpfs none /proc";
  if (run(without + "'").exit_code != 0) GTEST_SKIP() << "the system lets nobody hide /proc";
  expect_exit(0, run(without + " && {} check " + path("r.h5") + "'"));
}

TEST_F(Start, EveryToolNamesThePackagesThatItNeeds) {
  const fs::path tools = fs::path(AR3D_SOURCE_DIR) / "tools";
  must("cp " + tools.string() + "/*.mjs " + path(""));  // where no playwright-core is installed
  std::map<std::string, std::string> said;
  for (const fs::directory_entry& file : fs::directory_iterator(tools)) {
    const std::string name = file.path().filename(), kind = file.path().extension();
    const std::string start = read_file(file.path()).substr(0, 40);
    const bool is_module = kind == ".mjs", is_script = start.starts_with("#!");
    if (!is_module && (!is_script || name == "ar3d_results.py")) continue;
    const bool is_bash = start.find("bash") != std::string::npos;
    const Outcome refused =
        run(is_module ? "node " + path(name) + " x y"
                      : "PATH=/none " + std::string(is_bash ? "/bin/bash " : "/usr/bin/python3 ") +
                            file.path().string() + " x y");
    EXPECT_NE(refused.exit_code, 0) << name;
    EXPECT_THAT(refused.err, StartsWith("tools/" + name + ": it needs Debian's ")) << name;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    said[name] = refused.err;
  }
  EXPECT_THAT(said["try-packages"], HasSubstr("apt install lintian mmdebstrap util-linux"));
  EXPECT_THAT(said["arm64"], HasSubstr("qemu-user-static"));
  EXPECT_GE(said.size(), 12u);
}

TEST(Collections, WhatCannotBeReadIsSkippedAlone) {
  const ScratchDirectory scratch;
  const std::string folder = scratch.path("c");
  must("mkdir -p " + folder + "/" + std::string(60, 'd') + "; ln -s y " + folder + "/x; ln -s x " +
       folder + "/y; {} generate cycle -n 9 -o " + folder + "/a.s6; cp " + folder + "/a.s6 " +
       folder + "/" + std::string(60, 'd'));
  const std::string study = "{} study run -q --graphs " + folder +
                            " --name c --algorithm grid -o " + scratch.path("r.h5");
  expect_error(run(study), "c/");
  expect_output(run(study + " --skip"), "files    1 of 4 were read");
  EXPECT_EQ(read_results(scratch.path("r.h5")).runs.size(), 1u);
}

TEST(Leftovers, NoPartialFileStaysBehindAKilledStudy) {
  const ScratchDirectory scratch;
  const std::string file = scratch.path("q.h5");
  for (int call = 1; call <= 12; ++call) {
    run(with_fault(fmt::format("after:{}", call)) + "{} study run smoke -q -o " + file);
    run(fs::exists(file + ".journal") || fs::exists(file) ? "{} study resume -q " + file
                                                          : "{} study run smoke -q -o " + file);
    EXPECT_EQ(run("ls " + scratch.path("") + " | grep partial").out, "") << call;
    run("rm -f " + scratch.path("q*"));
  }
}

/// The folder is read for the first row only, however many rows are replayed.
TEST(Collections, AreListedOnceForAllRowsThatAreReplayed) {
  const ScratchDirectory scratch;
  const std::string folder = scratch.path("c"), file = scratch.path("r.h5");
  must("mkdir " + folder + "; for n in 5 6 7; do {} generate cycle -n $n -o " + folder +
       "/$n.s6; done; {} study run -q --graphs " + folder + " --name c --algorithm grid -o " +
       file);
  const Results results = read_results(file);
  const StudyOrigin origin = study_origin(results);
  EXPECT_EQ(graph_of(plan_of_row(results.runs.at(0), origin)).num_vertices(), 5u);
  fs::remove_all(folder);
  EXPECT_EQ(graph_of(plan_of_row(results.runs.at(2), origin)).num_vertices(), 7u);
}

TEST(Keys, AreOfThePlan) {
  const ScratchDirectory scratch;
  const std::string file = scratch.path("r.h5");
  must("{} study run smoke -q -o " + file);
  Results strange = read_results(file);
  strange.runs[5].row_key = std::string(31, '0') + "1";
  write_results(strange, scratch.path("p.h5"));
  expect_error(run("{} study resume -q " + scratch.path("p.h5")), "is none of study smoke");
  EXPECT_FALSE(fs::exists(scratch.path("p.h5.journal"))) << "the study is as it was";
  strange.runs[5].row_key = std::string(32, '0');
  write_results(strange, file);
  expect_error(run("{} check " + file), "r.h5: the key of row 5 is zero");
  const std::string status = "{} study status " + file;
  expect_error(run(status), "r.h5: the key of row 5 is zero");
  strange.runs[5].row_key = strange.runs[3].row_key;
  write_results(strange, file);
  for (const std::string verb : {"check ", "report ", "study resume -q ", "study status "}) {
    expect_error(run("{} " + verb + file), "r.h5: rows 3 and 5 have one key, ");
  }
  strange.runs[5].row_key = std::string(31, '0') + "1";
  strange.runs.push_back(strange.runs[5]);
  strange.runs.back().row_key[0] = '1';
  write_results(strange, file);
  const Outcome more = run(status);
  expect_error(more, "r.h5: 1063 rows, but its study plans 1062: there is no row 1062");
  EXPECT_EQ(more.out, "") << "no word of completeness";
}

/// What the process that reads a results file says is checked: lies 1 to 10 of the fault shim.
TEST(Readers, ThatLieAreRefusedByTheNameOfTheFile) {
  const ScratchDirectory scratch;
  must("{} study run smoke -q -o " + scratch.path("r.h5"));
  const std::string bytes = read_file(scratch.path("r.h5"));
  for (int lie = 1; lie <= 10; ++lie) {
    const std::string program = "cd " + scratch.path("") + " && timeout 60 " +
                                with_fault(fmt::format("lie:{}", lie)) + "{} ";
    for (const std::string verb :
         {"check r.h5", "study status r.h5", "report r.h5", "study resume -q r.h5", "replay r.h5 0",
          "compare r.h5 r.h5", "study merge r.h5 -o m.h5", "study count r.h5 -o m.h5"}) {
      const Outcome refused = run(program + verb);
      expect_one_line(refused, "ar3d: r.h5");
      EXPECT_THAT(refused.out, Not(HasSubstr("complete"))) << lie << ' ' << verb;
    }
    EXPECT_EQ(read_file(scratch.path("r.h5")), bytes) << lie;
    EXPECT_EQ(scratch.entries(), 2u) << lie << ": rows and their page";
  }
}

TEST(Processes, ThatCannotBeForkedAreAnErrorOrAreNotNeeded) {
  const ScratchDirectory scratch;
  must("{} study run smoke -q -o " + scratch.path("r.h5"));
  const std::string none = "cd " + scratch.path("") + " && " + with_fault("fork:1") + "{} ";
  for (const std::string verb : {"check ", "study status ", "report ", "compare r.h5 "}) {
    expect_error(run(none + verb + "r.h5"), "cannot start a process: Resource temporarily");
  }
  expect_exit(0, run(none + "generate petersen | {} draw -"));
  expect_error(run(none + "study run smoke -q --isolate -o n.h5"), "cannot start a process");
  expect_exit(0, run("cd " + scratch.path("") +
                     "; {} study resume -q n.h5 || {} study run smoke "
                     "-q -o n.h5"));
  expect_same_rows(scratch.path("n.h5"), scratch.path("r.h5"));
}

}  // namespace
}  // namespace ar3d::testing
