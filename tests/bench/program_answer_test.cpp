// What the answers of programs that draw mean.
#include <fmt/format.h>

#include <cmath>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/bench/external/external_drawer.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/model/real_points.h"
#include "ar3d/verify/assessment/real_assessment.h"
#include "ar3d/verify/certificate.h"
#include "ar3d/verify/examination.h"
#include "support/graphs.h"
#include "support/problem.h"

namespace ar3d::testing {
namespace {

TEST(Decimals, AreExact) {
  const auto text = [](const std::string& number) {
    const Decimal decimal = parse_decimal(number);
    return fmt::format("{}e{}", decimal.digits, decimal.exponent);
  };
  EXPECT_EQ(text("0"), "0e0");
  EXPECT_EQ(text("-0.000"), "0e0");
  EXPECT_EQ(text("120"), "12e1");
  EXPECT_EQ(text("-0.0125"), "-125e-4");
  EXPECT_EQ(text("1.50e3"), "15e2");
  EXPECT_EQ(text("1E-3"), "1e-3");
  EXPECT_EQ(text("123456789012345678"), "123456789012345678e0");
  EXPECT_THAT(problem([] { parse_decimal("1234567890123456789"); }), HasSubstr("18 significant"));
  EXPECT_THAT(problem([] { parse_decimal("1e2000"); }), HasSubstr("exponent beyond 1000"));
  EXPECT_EQ(scaled(parse_decimal("1.5"), -3), 1500);
  EXPECT_EQ(scaled(parse_decimal("-2"), -1), -20);
  EXPECT_THAT(problem([] { scaled(parse_decimal("1000"), -17); }), HasSubstr("passes 2^61"));
}

const Graph kPath(3, {{0, 1}, {1, 2}});

TEST(Answers, PositionsAreScaledByOnePowerOfTen) {
  const ProgramAnswer answer =
      parse_answer("p", kPath, R"({"vertices":[[0,0,0],[1.5,0,-0.25],[2,1]],"seconds":0.5})");
  ASSERT_TRUE(answer.drawing);
  EXPECT_EQ(answer.own_s, 0.5);
  EXPECT_EQ(answer.drawing->vertex(1), (Point{150, 0, -25}));
  EXPECT_EQ(answer.drawing->vertex(2), (Point{200, 100, 0}));
  EXPECT_EQ(answer.drawing->counters[0], (Counter{"decimals", 2}));
}

TEST(Answers, BendsFollowTheEdgeHoweverItIsListed) {
  const ProgramAnswer answer = parse_answer(
      "p", kPath,
      R"({"vertices":[[0,0,0],[3,0,0],[5,0,0]],"edges":[[2,1,[[4,1,0],[4,2,0]]],[0,1]]})");
  ASSERT_TRUE(answer.drawing);
  std::vector<Point> points;
  answer.drawing->polyline(1, points);
  EXPECT_EQ(points, (std::vector<Point>{{3, 0, 0}, {4, 2, 0}, {4, 1, 0}, {5, 0, 0}}));
  answer.drawing->polyline(0, points);
  EXPECT_EQ(points.size(), 2u);
}

TEST(Answers, OurOwnLinesAreRead) {
  const Graph graph = petersen();
  std::string line;
  append_drawing_line(line, draw(find_algorithm("grid"), graph));
  const ProgramAnswer answer = parse_answer("p", graph, line.substr(0, line.size() - 1));
  ASSERT_TRUE(answer.drawing);
  EXPECT_EQ(drawing_hash(*answer.drawing), drawing_hash(draw(find_algorithm("grid"), graph)));
  EXPECT_THAT(problem([&] { parse_answer("p", kPath, line); }),
              HasSubstr("10 vertices are drawn, the graph has 3"));
  EXPECT_EQ(parse_answer("p", kPath, R"({"error":"no"})").refusal, "no");
}

TEST(Answers, NothingBehindAByteZeroIsRead) {
  const std::string line = std::string("{\"error\":\"no\"}") + '\0' + "junk";
  EXPECT_THAT(problem([&] { parse_answer("p", kPath, line); }), HasSubstr("column 15: a byte 0"));
}

TEST(Answers, NonsenseIsNamed) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "no JSON"},
      {"hello", "no JSON"},
      {R"({"vertices":[[0,0,NaN],[1,0,0],[2,0,0]]})", "no JSON"},
      {R"({"vertices":[[0,0,0],[1,0,0]]})", "2 vertices are drawn, the graph has 3"},
      {R"({"vertices":[[0,0,0],[1,0,0],[2,0,0],[3,0,0]]})", "4 vertices are drawn"},
      {R"({"vertices":[[0,0,0],[1,0,0],[2,0,0,0]]})", "vertices[2][3]: unexpected fourth number"},
      {R"({"vertices":[[0,0,0],[1,0,0],[2]]})", "vertices[2]: 1 numbers instead of 2 or 3"},
      {R"({"vertices":[[0,0,0],[1,0,0],[[2],0,0]]})", "unexpected array"},
      {R"({"vertices":[[0,0,0],[1,0,0],"x"]})", "unexpected text"},
      {R"({"vertices":[[0,0,0],[1,0,0],[2,0,1e999]]})", "no JSON"},
      {R"({"vertices":[[0,0,0],[1,0,0],[2,0,0]],"edges":[[0,1]]})", "not those of the graph"},
      {R"({"vertices":[[0,0,0],[1,0,0],[2,0,0]],"edges":[[0,1],[0,1]]})", "not those of the graph"},
      {R"({"vertices":[[0,0,0],[1,0,0],[2,0,0]],"edges":[[0,1],[1,7]]})", "has the end 7"},
      {R"({"vertices":[[0,0,0],[1,0,0],[2,0,0]],"edges":[[0,1],[1]]})",
       "an edge is [u, v, [bends]]"},
      {R"({"vertices":[[0,0,0],[1,0,0],[2,0,0]],"edges":[[0,1],[1,-2]]})", "-2 is no vertex id"},
      {R"({"vertices":[[0,0,0],[1,0,0],[2,0,0]],"size":3})", "unknown key 'size'"},
      {R"({"seconds":3})", "neither 'vertices' nor 'error'"},
      {R"({"seconds":-3,"error":"x"})", "-3 is no time"},
      {R"([])", "expected an object, found an array"},
      {R"(null)", "unexpected null"},
      {R"({"vertices":[[0,0,0.0000000000000000001],[1,0,0],[1000000,0,0]]})", "passes 2^61"},
  };
  for (const auto& [answer, message] : cases) {
    const char* line = answer;
    EXPECT_THAT(problem([&] { parse_answer("p", kPath, line); }), HasSubstr(message)) << line;
  }
}

TEST(Answers, DecimalsBecomeTheNearestValuesOfAType) {
  const Graph claw(4, {{0, 1}, {0, 2}, {0, 3}});
  const std::string line =
      R"({"vertices":[[0,0,0],[1,0,0],[-0.5,0.8660254037844386,0],)"
      R"([-0.5,-0.8660254037844386,0]],"edges":[[0,1],[2,0,[[0.1,0.2]]],[0,3]]})";
  const auto miss = [&](const std::string& coordinates) {
    const Drawing drawing = *parse_answer("p", claw, line, coordinates).drawing;
    EXPECT_EQ(drawing.real->type, coordinates);
    require_values_of_type(*drawing.real);
    EXPECT_EQ(drawing.real->bends_of(1).size(), 1U);
    const std::string straight = line.substr(0, line.find(",\"edges\"")) + "}";
    return assess(claw, *parse_answer("p", claw, straight, coordinates).drawing->real).largest_miss;
  };
  EXPECT_NEAR(std::log10(miss("float")), -6, 1);
  EXPECT_NEAR(std::log10(miss("double")), -14.5, 1.5);
  const auto read = [](const std::string& x) {
    const std::string one = R"({"vertices":[[)" + x + ",0,0]]}";
    return parse_answer("p", Graph(1, {}), one, "float").drawing->real->vertices[0].x;
  };
  EXPECT_EQ(read("16777217"), BigInteger(1));  // a tie goes to the even 2^24, in units of itself
  EXPECT_EQ(read("-0.0"), BigInteger(0));
  EXPECT_THAT(problem([&] { read("1e39"); }), HasSubstr("1e39 is beyond the numbers of float"));
  EXPECT_THAT(problem([&] { read("1e-99"); }), HasSubstr("1e-99 is beyond the numbers of float"));
  std::string own;
  append_drawing_line(own, draw(find_algorithm("grid"), kPath));
  EXPECT_THAT(problem([&] { parse_answer("p", kPath, own, "double"); }),
              HasSubstr("no coordinates of double"));
}

DrawingSummary angles_of(const Drawing& drawing) {
  DrawingSummary summary;
  set_angles(drawing, summary);
  return summary;
}

TEST(Angles, AreMeasuredAndComparedExactly) {
  // A right angle at vertex 1, and a bend of 45 degrees.
  const ProgramAnswer answer = parse_answer(
      "p", kPath,
      R"({"vertices":[[0,0,0],[1,0,0],[1,1,0]],"edges":[[0,1],[1,2,[[1,2,0],[2,1,0]]]]})");
  const DrawingSummary angles = angles_of(*answer.drawing);
  EXPECT_NEAR(angles.smallest_vertex_angle, 90, 1e-12);
  EXPECT_NEAR(angles.smallest_bend_angle, 45, 1e-12);
  EXPECT_EQ(angles.optimal_edges, 0);
  for (const char* name : {"diamond", "grid", "two-bend"}) {
    const Graph graph = name == std::string("diamond") ? complete(5) : petersen();
    const Drawing drawing = draw(find_algorithm(name), graph);
    const DrawingSummary optimal = angles_of(drawing);
    EXPECT_EQ(optimal.optimal_edges, graph.num_edges()) << name;
    EXPECT_NEAR(optimal.smallest_vertex_angle, name == std::string("diamond") ? 109.4712206 : 120,
                1e-7);
  }
  for (const char* name : {"diamond", "grid", "two-bend"}) {  // what is proved is what is measured
    for (const Graph& graph : {complete(4), petersen(), Graph(2, {{0, 1}}), Graph(3, {})}) {
      const Algorithm& algorithm = find_algorithm(name);
      const Drawing drawing = draw(algorithm, graph);
      Examination examination = examine(graph, drawing, algorithm.guarantee);
      set_angles_and_crossings(graph, drawing, algorithm.guarantee, examination.certificate,
                               examination.summary);
      const DrawingSummary measured = angles_of(drawing);
      EXPECT_EQ(examination.summary.crossings, 0);
      EXPECT_EQ(examination.summary.optimal_edges, measured.optimal_edges) << name;
      const auto same = [](double a, double b) {
        return (std::isnan(a) && std::isnan(b)) || std::abs(a - b) < 1e-9;
      };
      EXPECT_TRUE(same(examination.summary.smallest_vertex_angle, measured.smallest_vertex_angle));
      EXPECT_TRUE(same(examination.summary.smallest_bend_angle, measured.smallest_bend_angle));
    }
  }
  const DrawingSummary none = angles_of(draw(find_algorithm("grid"), Graph(2, {})));
  EXPECT_TRUE(std::isnan(none.smallest_vertex_angle));
  EXPECT_TRUE(std::isnan(none.smallest_bend_angle));
  EXPECT_EQ(none.optimal_edges, 0);
  std::string star = R"({"vertices":[[0,0,0],[1,0,0],[-1,0,0],[0,1,0],[0,-1,0],[0,0,1]]})";
  const Graph five(6, {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}});
  EXPECT_EQ(angles_of(*parse_answer("p", five, star).drawing).optimal_edges, -1);
}

}  // namespace
}  // namespace ar3d::testing
