// Graphs of no or few vertices, coordinates at the ends of 64 bits, and what is no number, through
// the program: certified, or refused in one line.
#include <cmath>
#include <fstream>
#include <set>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/model/real_points.h"
#include "ar3d/store/columns/run_columns.h"
#include "ar3d/store/rows.h"
#include "support/program.h"

namespace ar3d::testing {
namespace {

Outcome verified(const std::string& line) {
  return run("printf '%s\\n' '" + line + "' | {} verify -");
}

/// A refusal is one line on standard error, and nothing else.
void expect_refused(const std::string& line, const std::string& reason) {
  expect_one_line(verified(line), reason);
}

TEST(Extremes, TheStudyIsAllRightAndHasNoNaNWhereANumberIsDue) {
  const ScratchDirectory scratch;
  const std::string results = scratch.path("extremes.h5");
  expect_exit(0, run("{} study run extremes -q --threads 1 -o " + results));
  std::size_t tiny = 0;
  std::set<std::string> drew_nothing;
  const Rows rows(results);
  ASSERT_GT(rows.size(), 100u);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const RunRecord& row = rows.run(i);
    SCOPED_TRACE(row.family + " n=" + std::to_string(row.n) + " " + row.algorithm);
    EXPECT_EQ(row.status, RunStatus::ok) << row.message;
    tiny += row.n <= 3;
    if (row.n == 0) drew_nothing.insert(row.algorithm);
    EXPECT_TRUE(std::isfinite(row.log2_volume));
    EXPECT_TRUE(std::isfinite(row.total_edge_length));
    EXPECT_TRUE(std::isfinite(row.longest_edge_length));
    const bool has_distance = row.n >= 2 && row.algorithm != "two-bend-paper";  // not in real types
    EXPECT_EQ(std::isfinite(row.smallest_vertex_distance), has_distance);
    for (const std::int64_t extent : row.extents) EXPECT_GE(extent, 0);
    EXPECT_GT(row.peak_bytes, 0);
    EXPECT_EQ(row.peak_scope, "worker");
  }
  EXPECT_GE(tiny, 20u);
  EXPECT_EQ(drew_nothing.size(), algorithms().size()) << "the graph of no vertices";
}

// With 2.6 bytes of stack a vertex nothing can descend vertex by vertex.
TEST(Extremes, NoRecursionProportionalToN) {
  const ScratchDirectory scratch;
  const std::string toml = scratch.path("deep.toml");
  std::ofstream(toml) << "study = \"deep\"\nmax_n = { two-bend-109 = 1000 }\n[[sweep]]\nfamilies = "
                         "[\"path\", \"cycle\", "
                         "\"caterpillar\", \"binary-tree\", \"nested-triangles\", "
                         "\"iterated-truncation\"]\nsizes = 100000\nalgorithms = \"all\"\n";
  expect_output(run("ulimit -s 256 && OMP_STACKSIZE=256k {} study run " + toml +
                    " -q --threads 1 -o " + scratch.path("deep.h5")),
                "PASS: 27 rows, 27 proved");
}

TEST(Extremes, CoordinatesAtTheEndsOf64Bits) {
  const auto line = [](const std::string& a, const std::string& b) {
    return R"({"n":2,"algorithm":"diamond","gram":[[1,0,0],[0,1,0],[0,0,1]],"gram_denominator":1,)"
           R"("vertices":[[)" +
           a + "],[" + b + R"(]],"edges":[]})";
  };
  expect_output(
      verified(line("-2305843009213693952,0,0", "2305843009213693952,0,0")),
      {"size: the extent in x is 4611686018427387904, more than 16/3 n", "0 certified, 1 violated"},
      4);
  expect_refused(
      line("0,0,0", "2305843009213693953,0,0"),
      "coordinate 2305843009213693953 is out of range, the limit is 2305843009213693952");
  expect_refused(line("0,0,0", "0,-2305843009213693953,0"), "is out of range");
  expect_refused(line("0,0,0", "9223372036854775807,0,0"), "is out of range");
  expect_refused(line("0,0,0", "9223372036854775808,0,0"), "does not fit 64 bits with sign");
  expect_refused(line("0,0,0", "18446744073709551616,0,0"), "expected an integer of 64 bits");
  for (const std::string no_number : {"NaN", "nan", "Infinity", "-Infinity", "1e400", "1.5"}) {
    expect_refused(line("0,0,0", no_number + ",0,0"), "<stdin>:1");
  }
}

// A long chain of heights at the scale of the size bound's proof: refused before anything is
// placed.
TEST(Extremes, HeightsBeyond60BitsAreRefusedWithTheVertexNamed) {
  expect_error(run("{} generate ladder -n 300000 | {} draw - --algorithm two-bend-109 --set "
                   "effort=0 --level extents"),
               "two-bend-109: a coordinate of vertex 277710 may pass 2^60, "
               "the graph is too large");
}

/// The right drawing of one straight edge in a real type, in units of 2^exponent times a factor.
std::string real_line(const std::string& exponent, const std::string& end) {
  return R"({"n":2,"algorithm":"two-bend-paper","real_type":"double","unit_exponent":)" + exponent +
         R"(,"vertices":[["0","0","0"],[")" + end + R"(","0","0"]],"edges":[[0,1,[[")" + end +
         R"(","1","0"]]]]})";
}

TEST(Extremes, ScalesOfRealTypes) {
  // 2^-1074 is the smallest denormal double, 2^1023 the scale of the largest ones.
  const Outcome one = verified(real_line("0", "5"));
  for (const std::string exponent : {"-1074", "-1022", "971", "1023", "-4000", "4000"}) {
    const Outcome scaled = expect_exit(5, verified(real_line(exponent, "5")));
    EXPECT_EQ(scaled.out, one.out) << "angles do not depend on the scale";
  }
  const Outcome huge = verified(real_line("4000", (BigInteger(1) << 3320).str()));  // 1000 digits
  EXPECT_EQ(huge.exit_code, 5);
  EXPECT_THAT(huge.out, Not(HasSubstr("nan")));
  EXPECT_THAT(huge.out, Not(HasSubstr("inf")));
  expect_refused(real_line("4001", "5"), "unit_exponent: 4001 is not in -4000..4000");
  expect_refused(real_line("0", "NaN"), "'NaN' is no decimal integer");
  expect_refused(real_line("0", "Infinity"), "'Infinity' is no decimal integer");
  expect_refused(real_line("0", "1e999"), "'1e999' is no decimal integer");
  expect_refused(real_line("0", std::string(1001, '9')), "more than 1000 characters");
}

/// Column of a row as a number; missing if it is not there.
double number(const RunRecord& row, const char* column) { return metric_of(row, column); }

TEST(Extremes, RealTypesOfGraphsOfNoAndFewVertices) {
  const ScratchDirectory scratch;
  const std::string toml =
      scratch.write("few.toml",
                    "study = \"few\"\naccept_unproved = true\n[[sweep]]\nfamilies = \"all\"\nsizes "
                    "= [0, 1, 2, 3]\n"
                    "algorithms = { algorithm = \"two-bend-paper\", type = [0, 1, 2, 3, 4] }\n");
  const std::string results = scratch.path("few.h5");
  expect_exit(0, run("{} study run " + toml + " -q -o " + results));
  const Rows rows(results);
  ASSERT_GT(rows.size(), 50u);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const RunRecord& row = rows.run(i);
    SCOPED_TRACE(row.family + " n=" + std::to_string(row.n) + " " + row.options);
    EXPECT_EQ(row.status, RunStatus::ok) << row.message;
    EXPECT_EQ(row.certificate, "measured");
    EXPECT_LT(number(row, "angle_miss"), 2e-3);  // the least Goldberg snark, in float
    EXPECT_EQ(number(row, "crossings"), 0);
    EXPECT_EQ(number(row, "collapsed_segments"), 0);
    EXPECT_TRUE(std::isfinite(row.log2_volume));
    EXPECT_TRUE(std::isfinite(row.total_edge_length));
  }
}

TEST(Extremes, SummariesOfGraphsWithoutPoints) {
  for (const std::string algorithm : {"diamond", "grid", "two-bend", "compact", "compact-120",
                                      "two-bend-109", "two-bend-paper", "grid-paper"}) {
    const Outcome none = run("printf '?\\n@\\nA_\\nBw\\n' | {} draw - --algorithm " + algorithm +
                             " --level extents");
    EXPECT_TRUE(none.exit_code == 0 || none.exit_code == 5) << none.err;
    EXPECT_EQ(std::count(none.out.begin(), none.out.end(), '\n'), 4) << none.out;
    EXPECT_THAT(none.out, StartsWith("{\"n\":0,\"m\":0,"));
    EXPECT_THAT(none.out, Not(HasSubstr("NaN")));
  }
}

}  // namespace
}  // namespace ar3d::testing
