// Files of a few kilobytes that claim millions of vertices, in bounded memory.
#include "support/program.h"

namespace ar3d::testing {
namespace {

constexpr const char* kInOneGigabyte = "ulimit -v 1000000; export OMP_NUM_THREADS=1; timeout 100 ";

struct Claim {
  const char* format;
  std::string text;
};

/// What is 2^24 vertices, or nearly so, in every format.
std::vector<Claim> claims() {
  const std::string lines(40000, '\n');
  const std::string n = "16777216", mtx = "%%MatrixMarket matrix coordinate pattern symmetric\n";
  return {{"graph6", "~~????~???\n"},
          {"sparse6", ":~~???}???" + std::string(40000, '?') + "\n"},
          {"isparse6", ":~~???}???\n;~~???}???\n"},
          {"edgelist", "# vertices " + n + "\n0 1\n"},
          {"edgelist", "0 16777215\n"},
          {"adjlist", "# vertices " + n + "\n0: 1\n"},
          {"adjlist", "0: 16777215\n"},
          {"matrixmarket", mtx + n + " " + n + " 1\n2 1\n"},
          {"metis", n + " 0\n" + lines},
          {"dimacs", "p edge " + n + " 1\ne 1 2\n"}};
}

void expect_refused_in_one_line(const Outcome& outcome, const std::string& what) {
  EXPECT_EQ(outcome.exit_code, 2) << what << outcome.err.substr(0, 300);
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << what << outcome.err;
  EXPECT_EQ(outcome.out, "") << what;
}

TEST(HostileSizes, AreRefusedInEveryFormatByEveryVerb) {
  const ScratchDirectory scratch;
  must("{} generate k4 | {} draw - --algorithm grid -o " + scratch.path("d.jsonl"));
  for (const Claim& claim : claims()) {
    const std::string file = scratch.write("claim", claim.text);
    const std::string from = " --from " + std::string(claim.format);
    for (const std::string algorithm : {"diamond", "two-bend"}) {
      expect_refused_in_one_line(run(kInOneGigabyte + ("{} draw " + file + from) + " --algorithm " +
                                     algorithm + " -o " + scratch.path("out.jsonl")),
                                 claim.format);
    }
    expect_refused_in_one_line(
        run(kInOneGigabyte + ("{} verify " + scratch.path("d.jsonl")) + " --graphs " + file + from),
        claim.format);
    expect_refused_in_one_line(run(kInOneGigabyte + ("{} shrink " + file + from) +
                                   " --algorithm grid --ratio 1 -o " + scratch.path("s")),
                               claim.format);
  }
}

TEST(HostileSizes, WhatIsJustBelievedFitsTheMemoryToo) {
  const ScratchDirectory scratch;
  const std::string file = scratch.write("many", "# vertices 1048576\n0 1\n");
  for (const std::string algorithm : {"diamond", "grid", "compact"}) {
    expect_exit(0, run(kInOneGigabyte + ("{} draw " + file) + " --algorithm " + algorithm +
                       " -o /dev/null"));
  }
}

TEST(HostileSizes, AreBelievedOnDemand) {
  const ScratchDirectory scratch;
  const std::string file = scratch.write("many", "# vertices 1200000\n0 1\n");
  const Outcome outcome = run("{} draw " + file + " --algorithm grid -o /dev/null");
  EXPECT_THAT(outcome.err,
              HasSubstr("1200000 vertices claimed by a graph of 4 bytes, which accounts "
                        "for at most 1048640; --trust-sizes believes it"));
  expect_exit(0, run("{} draw " + file + " --algorithm grid --trust-sizes -o /dev/null"));
}

TEST(HostileSizes, APackedFileDoesNotUnpackWithoutEnd) {
  const ScratchDirectory scratch;
  const std::string script =
      scratch.write("pack.py",
                    "import gzip, lzma, sys\n"
                    "text = b'<graphml><graph edgedefault=\"undirected\">' + b'<a/>' * 50_000_000\n"
                    "open(sys.argv[1] + '.gz', 'wb').write(gzip.compress(text, 9))\n"
                    "open(sys.argv[1] + '.xz', 'wb').write(lzma.compress(text, preset=1))\n"
                    "text = b'# a comment that goes on\\n' * 8_000_000\n"
                    "open(sys.argv[1] + '.el.gz', 'wb').write(gzip.compress(text, 9))\n");
  const std::string bomb = scratch.path("bomb");
  must("/usr/bin/python3 " + script + " " + bomb);
  for (const char* ending : {".gz", ".xz", ".el.gz"}) {
    const Outcome outcome =
        run(kInOneGigabyte + ("{} draw " + bomb) + ending + " --algorithm grid -o /dev/null");
    expect_refused_in_one_line(outcome, ending);
    EXPECT_THAT(outcome.err, HasSubstr("unpack it first if that is meant")) << ending;
  }
  for (const std::string text :
       {"{\"n\":16777216,\"error\":\"x\"}\n",
        "{\"n\":4294967294,\"algorithm\":\"grid\",\"gram\":[[1,0,0],[0,1,0],[0,0,1]],"
        "\"gram_denominator\":1,\"vertices\":[],\"edges\":[]}\n"}) {
    const Outcome outcome = run(kInOneGigabyte + ("{} verify " + scratch.write("d.jsonl", text)));
    EXPECT_THAT(outcome.exit_code, AnyOf(2, 5)) << text << outcome.err;
  }
}

}  // namespace
}  // namespace ar3d::testing
