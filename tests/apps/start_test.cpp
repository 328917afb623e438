// What the one who starts the program may leave it: closed descriptors, full disks, small stacks,
// ignored signals, missing packages; folders of which a part cannot be read.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "ar3d/store/rows.h"
#include "support/program.h"
#include "support/results.h"

namespace ar3d::testing {
namespace {

class Start : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return scratch_.path(name); }
  /// Five stars of degree 3, about each of which `draw` says something.
  std::string stars() const { return scratch_.write("g.g6", "Ct\nCt\nCt\nCt\nCt\n"); }

  /// A study of two rows.
  std::string tiny() const {
    return scratch_.write("tiny.toml",
                          "study = 't'\n[[sweep]]\nfamilies = 'cycle'\nsizes = [5, 6]\n"
                          "algorithms = 'grid'\n");
  }
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

/// Seven ways of closing or filling standard streams; only what standard output had to take counts.
TEST_F(Start, StreamsThatCannotBeWrittenEndNoVerb) {
  stars();
  const std::string cd = "cd " + path("") + " && ";
  must(cd + "{} study run " + tiny() + " -q -o r.h5 && {} draw g.g6 -o d.jsonl && " +
       "{} generate cycle -n 9 -o one.s6 && {} history add r.h5 --folder h --place 1 --name a");
  expect_exit(0, run(cd + "{} figures r.h5 -o f 2>/dev/full"));
  expect_one_line(run(cd + "{} figures r.h5 --force -o f >/dev/full"), "standard output: No space");
  for (const std::string call : {"list families",
                                 "help draw",
                                 "--version",
                                 "generate cycle -n 9",
                                 "draw g.g6",
                                 "draw g.g6 --force -o a.jsonl",
                                 "view d.jsonl --force -o v.html",
                                 "verify d.jsonl",
                                 "study plan tiny.toml",
                                 "study run tiny.toml --force -o s.h5",
                                 "study resume s.h5",
                                 "study status r.h5",
                                 "study merge r.h5 --force -o m.h5",
                                 "check r.h5",
                                 "report r.h5 --force -o p.html",
                                 "compare r.h5 r.h5",
                                 "history add r.h5 --folder h --place 1 --name a --force",
                                 "history report --folder h --force -o h.html",
                                 "replay r.h5 1",
                                 "replay r.h5 --all",
                                 "hunt --algorithm grid -n 6 --evaluations 9 --force -o w",
                                 "shrink one.s6 --algorithm grid --ratio 0.0001 --force -o w"}) {
    const Outcome plain = run(cd + "{} " + call);
    EXPECT_TRUE(plain.exit_code == 0 || call.starts_with("history report")) << plain.err;
    for (const std::string how : {"2>/dev/full", "2>&-", ">/dev/full", ">&-", "<&- 2>&-",
                                  ">&- 2>&-", ">/dev/full 2>/dev/full"}) {
      const bool is_lost = how.find(">&- 2") == 0 || how.find(">/") == 0 || how == ">&-";
      expect_exit(is_lost && !plain.out.empty() ? 2 : plain.exit_code,
                  run(cd + "{} " + call + " " + how));
    }
  }
}

TEST_F(Start, StandardErrorThatIsFullChangesNoExitCode) {
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
  const std::string cd = "cd " + path("") + " && ";
  for (const std::string call :
       {"draw g.g6 -o d.jsonl", "draw g.g6 -o v.html", "view d.jsonl -o w.html", "verify d.jsonl",
        "study run smoke -q -o r.h5", "study run smoke -q --isolate -o i.h5", "check r.h5",
        "report r.h5 -o s.html --csv s.csv", "compare r.h5 r.h5", "study merge r.h5 -o m.h5",
        "replay r.h5 --sample 20", "hunt --algorithm grid -n 8 --evaluations 20"}) {
    expect_exit(0, run(cd + "ulimit -s 64; export OMP_STACKSIZE=64k; {} " + call));
  }
  for (const std::string call :
       {"generate cycle -n 10000 -o large", "draw g.g6 --force -o large", "view d.jsonl -o large",
        "report r.h5 -o large", "study merge r.h5 -o large", "replay r.h5 --keep all -o large",
        "study run smoke -q -o large", "history add r.h5 --folder h --place 1 --name n"}) {
    expect_error(run(cd + "ulimit -f 1; {} " + call), "File too large");
    EXPECT_FALSE(fs::exists(path("large"))) << call;
    EXPECT_EQ(run("ls -R " + path("") + " | grep partial").out, "") << call;
  }
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
  expect_error(run("timeout 10 {} shrink --algorithm grid -o " + path("w ") + fifo),
               "it is a FIFO");
  must("mkfifo " + path("r.h5.journal"));
  for (const std::string verb : {"study status ", "study resume ", "study run smoke -o "}) {
    expect_error(run("timeout 10 {} " + verb + path("r.h5")), "r.h5.journal");
  }
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
  must("{} study run " + tiny() + " -q -o " + path("r.h5"));
  const std::string without = "cd " + path("") +
                              "; unshare --map-root-user --mount bash -c '"
                              "mount -t tmpfs none /proc";
  if (run(without + "'").exit_code != 0) GTEST_SKIP() << "the system does not let /proc be hidden";
  for (const std::string call :
       {"check r.h5", "report r.h5", "compare r.h5 r.h5", "study merge r.h5 -o m.h5",
        "replay r.h5 1", "study resume -q r.h5", "study run tiny.toml -q --isolate -o n.h5"}) {
    expect_exit(0, run(without + " && {} " + call + "'"));
  }
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
  must(
      "mkdir -p " + folder + "/" + std::string(60, 'd') + "; ln -s y " + folder + "/x; ln -s x " +
      folder + "/y; {} generate cycle -n 9 -o " + folder + "/a.s6; cp " + folder + "/a.s6 " +
      folder + "/" + std::string(60, 'd') + "; cd " + folder +
      "; python3 -c 'import os\nfor _ in range(30): os.mkdir(\"e\" * 200); os.chdir(\"e\" * 200)'");
  const std::string study = "{} study run -q --graphs " + folder +
                            " --name c --algorithm grid -o " + scratch.path("r.h5");
  expect_error(run(study), "c/");
  expect_output(run(study + " --skip"), "files    1 of 5 were read");
  EXPECT_EQ(read_results(scratch.path("r.h5")).runs.size(), 1u);
}

TEST_F(Start, NoPartialFileStaysBehindAStudyThatWasStoppedAtAnyCall) {
  const std::string study = "study run -q " + tiny() + " -o ", file = path("q.h5");
  for (const std::string options : {"", " --isolate"}) {
    for (const std::string kind : {"after", "errno"}) {
      int calls = 0;
      for (bool is_hit = true; is_hit; ++calls) {
        const std::string fault = fmt::format("{}:{} AR3D_FAULT_IN={}", kind, calls + 1, path(""));
        const Outcome stopped = run(with_fault(fault) + "{} " + study + file + options);
        is_hit = stopped.exit_code == 137 || stopped.err.find("fault of") != std::string::npos;
        const bool begun = fs::exists(file + ".journal") || fs::exists(file);
        expect_exit(0, run("{} " + (begun ? "study resume -q " : study) + file));
        EXPECT_EQ(run("ls " + path("") + " | grep 'partial\\|journal'").out, "") << fault;
        run("rm -f " + path("q*"));
      }
      EXPECT_GT(calls, 20) << kind;
    }
  }
}

/// How many calls on the collection's folder and files a command makes: the last that can fail.
int calls_on(const std::string& folder, const std::string& command) {
  const auto meets = [&](int call) {
    return run(with_fault(fmt::format("errno:{} AR3D_FAULT_IN={}", call, folder)) + command)
               .err.find("fault of call") != std::string::npos;
  };
  int calls = 0;
  while (calls < 100 && meets(calls + 1)) ++calls;
  return calls;
}

TEST(Collections, AreReadOnceOrNotAtAllForRowsThatAreReplayed) {
  const ScratchDirectory scratch;
  const std::string folder = scratch.path("c"), file = scratch.path("r.h5");
  must("mkdir " + folder + "; for n in 5 6 7; do {} generate cycle -n $n -o " + folder +
       "/$n.s6; done");
  for (const char* limit : {"graphs_bytes = 1\n", ""}) {
    const std::string spec = scratch.write(
        "s.toml", fmt::format("study = 's'\n{}[[sweep]]\ngraphs = {{ files = 'c', name = 'c' }}\n"
                              "algorithms = 'grid'\n",
                              limit));
    must("{} study run -q --force " + spec + " -o " + file);
    expect_output(run("{} replay " + file + " --all"), "3 of 3 rows made again: 3 equal");
    const int calls = calls_on(folder, "{} replay " + file + " 0");
    EXPECT_EQ(calls_on(folder, "{} replay " + file + " --all"), calls) << "not once for each row";
    EXPECT_EQ(calls > 0, *limit != 0) << calls << ": the results hold the graphs, or do not";
  }
}

// One thread does where more are not needed; what needs them says so before there is a journal.
TEST(Threads, ThatCannotBeStartedAreAnErrorOrAreNotNeeded) {
  const ScratchDirectory scratch;
  must("cd " + scratch.path("") + "; {} generate random-cubic -n 100000 -o g.s6; " +
       "{} draw g.s6 --algorithm grid -o all.jsonl; {} study run smoke -q -o r.h5");
  const std::string none = "cd " + scratch.path("") + "; " + with_fault("thread:1") + "{} ";
  expect_exit(0, run(none + "draw g.s6 --algorithm grid -o one.jsonl"));
  expect_exit(0, run("cmp " + scratch.path("all.jsonl") + " " + scratch.path("one.jsonl")));
  expect_exit(0, run(none + "verify one.jsonl"));
  const std::string bytes = read_file(scratch.path("r.h5"));
  for (const std::string verb : {"study run smoke -q -o n.h5", "study resume -q r.h5"}) {
    expect_one_line(run(none + verb + " --threads 2"), "cannot start 2 threads: the system allows");
    EXPECT_EQ(fs::exists(scratch.path("n.h5.journal")), verb.starts_with("study resume"));
    expect_one_line(run(none + verb + " --threads 1"), "cannot start a thread: Resource");
    EXPECT_EQ(run("ls " + scratch.path("") + " | grep r.h5.").out, "") << verb;
    EXPECT_EQ(read_file(scratch.path("r.h5")), bytes);
  }
  expect_exit(0, run("{} study resume -q " + scratch.path("n.h5")));
  expect_same_rows(scratch.path("n.h5"), scratch.path("r.h5"));
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
