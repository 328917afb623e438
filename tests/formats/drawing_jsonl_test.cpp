#include "ar3d/formats/drawings/drawing_jsonl.h"

#include "ar3d/base/random.h"
#include "formats/format_helpers.h"

namespace ar3d::testing {
namespace {

Drawing drawing_of(std::vector<Point> points, std::vector<Edge> edges,
                   const std::vector<std::vector<Point>>& bends, Lattice lattice = kCubeLattice) {
  Coordinates vertices(points.size(), kMaxCoordinate);
  for (std::size_t v = 0; v < points.size(); ++v) vertices.set(v, points[v]);
  auto source = std::make_shared<StoredBends>();
  for (const auto& edge : bends) source->add_edge(edge);
  return Drawing("test", lattice, std::move(vertices),
                 std::make_shared<const std::vector<Edge>>(std::move(edges)), std::move(source));
}

std::string line_of(const Drawing& drawing) {
  std::string text;
  append_drawing_line(text, drawing);
  return text;
}

std::vector<DrawingJsonlReader::Line> read_lines(const std::string& text) {
  DrawingJsonlReader reader(TextInput("d", bytes_of(text)));
  std::vector<DrawingJsonlReader::Line> lines;
  while (auto line = reader.next()) lines.push_back(std::move(*line));
  return lines;
}

std::string refusal_of_lines(const std::string& text) {
  return problem([&] { read_lines(text); }, "accepted");
}

const Drawing kEdge = drawing_of({{0, 0, 0}, {3, -3, 1}}, {{1, 0}}, {{{3, 0, 1}, {0, 0, 1}}});
constexpr const char* kEdgeLine =
    R"({"n":2,"algorithm":"test","gram":[[1,0,0],[0,1,0],[0,0,1]],"gram_denominator":1,)"
    R"("vertices":[[0,0,0],[3,-3,1]],"edges":[[1,0,[[3,0,1],[0,0,1]]]]})"
    "\n";

TEST(DrawingJsonl, WritesTheContractsLine) {
  EXPECT_EQ(line_of(kEdge), kEdgeLine);
  std::string text;
  append_error_line(text, {7, "vertex 3 has \"degree\" 5"});
  EXPECT_EQ(text, "{\"n\":7,\"error\":\"vertex 3 has \\\"degree\\\" 5\"}\n");
}

TEST(DrawingJsonl, EmptyDrawing) {
  const std::string line = line_of(drawing_of({}, {}, {}, kScaledZLattice));
  EXPECT_EQ(
      line,
      "{\"n\":0,\"algorithm\":\"test\",\"gram\":[[3,0,0],[0,3,0],[0,0,1]],\"gram_denominator\":3,"
      "\"vertices\":[],\"edges\":[]}\n");
  const auto back = read_lines(line);
  ASSERT_EQ(back.size(), 1u);
  EXPECT_EQ(std::get<Drawing>(back[0]).lattice(), kScaledZLattice);
}

TEST(DrawingJsonl, GivesBackWhatItWrote) {
  RandomStream random(1);
  std::string text;
  for (int i = 0; i < 50; ++i) {
    std::vector<Point> points(20);
    const auto coordinate = [&] {
      const auto wide =
          static_cast<std::int64_t>(random.below64(2 * kMaxCoordinate)) - kMaxCoordinate;
      return i % 2 ? wide : wide >> 40;
    };
    for (Point& p : points) p = {coordinate(), coordinate(), coordinate()};
    std::vector<Edge> edges;
    std::vector<std::vector<Point>> bends;
    for (Vertex v = 1; v < 20; ++v) {
      edges.push_back({v, random.below(v)});
      bends.emplace_back(random.below(4), Point{coordinate(), coordinate(), coordinate()});
    }
    append_drawing_line(text, drawing_of(points, edges, bends));
  }
  std::string again;
  for (const auto& line : read_lines(text)) append_drawing_line(again, std::get<Drawing>(line));
  EXPECT_EQ(again, text);
}

TEST(DrawingJsonl, StreamsToAFile) {
  const ScratchDirectory folder = ScratchDirectory::in_memory();
  OutputFile output(folder.path("d.jsonl"));
  for (int i = 0; i < 2000; ++i) write_drawing_line(output, kEdge);
  output.commit();
  DrawingJsonlReader reader(folder.path("d.jsonl"));
  int count = 0;
  while (const auto line = reader.next()) {
    EXPECT_EQ(line_of(std::get<Drawing>(*line)), kEdgeLine);
    ++count;
  }
  EXPECT_EQ(count, 2000);
  EXPECT_EQ(reader.where(), folder.path("d.jsonl") + ":2000");
}

TEST(DrawingJsonl, ReadsErrorsBlanksAndAnyOrderOfKeys) {
  const auto lines =
      read_lines("\n{\"error\" : \"no\\nway\", \"n\" : 3}\n  \n" + std::string(kEdgeLine));
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(std::get<UndrawnGraph>(lines[0]), (UndrawnGraph{3, "no\nway"}));
}

/// The line of one edge with a part replaced.
std::string changed(const std::string& part, const std::string& by) {
  std::string line = kEdgeLine;
  const std::size_t at = line.find(part);
  EXPECT_NE(at, std::string::npos);
  return refusal_of_lines(std::string(kEdgeLine) + line.replace(at, part.size(), by));
}

TEST(DrawingJsonl, RefusesNumbersThatAreNotExact) {
  EXPECT_EQ(changed("-3", "-3.0"),
            "d:2: vertices[1][1]: expected an integer of 64 bits, found '-3.0'");
  EXPECT_EQ(changed("-3", "3e2"),
            "d:2: vertices[1][1]: expected an integer of 64 bits, found '3e2'");
  EXPECT_EQ(changed("-3", "99999999999999999999"),
            "d:2: vertices[1][1]: expected an integer of 64 bits, found '99999999999999999999'");
  EXPECT_EQ(changed("-3", "9223372036854775808"),
            "d:2: vertices[1][1]: 9223372036854775808 does not fit 64 bits with sign");
  EXPECT_EQ(changed("-3", "2305843009213693953"),
            "d:2: vertices[1][1]: coordinate 2305843009213693953 is out of range, the limit is "
            "2305843009213693952");
  EXPECT_EQ(changed("[3,0,1]", "[3,0,-9223372036854775808]"),
            "d:2: edges[0][2][0][2]: coordinate -9223372036854775808 is out of range, the limit is "
            "2305843009213693952");
  EXPECT_EQ(changed("[[1,0,0]", "[[4294967296,0,0]"),
            "d:2: gram[0][3]: 4294967296 is not in -2147483647..2147483647");
}

TEST(DrawingJsonl, RefusesWrongShapes) {
  EXPECT_EQ(changed("[3,-3,1]", "[3,-3]"), "d:2: vertices[1]: 2 numbers instead of 3");
  EXPECT_EQ(changed("[3,-3,1]", "[3,-3,1,4]"), "d:2: vertices[1][3]: unexpected fourth number 4");
  EXPECT_EQ(changed("[3,-3,1]", "7"), "d:2: vertices[1]: unexpected number 7");
  EXPECT_EQ(changed("[3,-3,1]", "null"), "d:2: vertices[1]: unexpected null");
  EXPECT_EQ(changed("[3,-3,1]", "{}"), "d:2: vertices[1]: unexpected object");
  EXPECT_EQ(changed("[3,-3,1]", "[3,[1],1]"), "d:2: vertices[1][1]: unexpected array");
  EXPECT_EQ(changed(",[[3,0,1],[0,0,1]]", ""), "d:2: edges[0]: an edge is [u, v, [bends]]");
  EXPECT_EQ(changed("[1,0,[[", "[1,[["), "d:2: edges[0][1]: unexpected array");
  EXPECT_EQ(changed("[1,0,[[", "[1,0,5,[["), "d:2: edges[0][2]: unexpected number 5");
  EXPECT_EQ(changed("[3,0,1],", "[3,0],"), "d:2: edges[0][2][0]: 2 numbers instead of 3");
  EXPECT_EQ(changed("\"test\"", "true"), "d:2: algorithm: unexpected true");
  EXPECT_EQ(changed("\"gram\":[", "\"gram\":[[1,1,1],"), "d:2: gram[3]: unexpected fourth row");
  EXPECT_EQ(changed("[1,0,0],", ""), "d:2: gram: 2 rows instead of 3");
  EXPECT_EQ(changed("[[3,0,1],[0,0,1]]", ""),
            "d:2:125: syntax error while parsing value - unexpected ']'; expected '[', '{', or a "
            "literal");
}

TEST(DrawingJsonl, RefusesWhatDoesNotFitTogether) {
  EXPECT_EQ(changed("\"n\":2", "\"n\":3"), "d:2: n is 3, but there are 2 vertices");
  EXPECT_EQ(changed("\"n\":2", "\"n\":-2"), "d:2: n: -2 is no number of vertices");
  EXPECT_EQ(changed("[1,0,[[", "[1,2,[["),
            "d:2: edge 0 (1, 2) of the drawing: vertex out of range, it has 2 vertices");
  EXPECT_EQ(changed("[1,0,0]", "[1,2,0]"), "d:2: the Gram matrix is not symmetric");
  EXPECT_EQ(changed("[1,0,0]", "[-1,0,0]"), "d:2: the Gram matrix is not positive definite");
  EXPECT_EQ(changed("\"gram_denominator\":1", "\"gram_denominator\":0"),
            "d:2: gram_denominator: 0 is not in 1..2147483647");
  EXPECT_EQ(changed("\"n\":2,", ""), "d:2: key 'n' is missing");
  EXPECT_EQ(changed("\"gram_denominator\":1,", ""), "d:2: key 'gram_denominator' is missing");
  EXPECT_EQ(changed("\"n\":2,", "\"n\":2,\"n\":2,"), "d:2: key 'n' stands twice");
  EXPECT_EQ(changed("\"n\":2,", "\"n\":2,\"m\":1,"), "d:2: unknown key 'm'");
  EXPECT_EQ(changed("\"n\":2,", "\"n\":2,\"error\":\"x\","),
            "d:2: a line with 'error' has no other key than 'n'");
}

TEST(DrawingJsonl, RefusesWhatIsNotJson) {
  EXPECT_EQ(refusal_of_lines(""), "d: empty file: no drawing in it");
  EXPECT_EQ(refusal_of_lines("[]\n"), "d:1: expected an object, found an array");
  EXPECT_EQ(refusal_of_lines("5\n"), "d:1: unexpected number 5");
  EXPECT_EQ(refusal_of_lines("{\"n\":2\n").substr(0, 4), "d:1:");
  EXPECT_EQ(refusal_of_lines(std::string(kEdgeLine).substr(0, 60)).substr(0, 4), "d:1:");
  EXPECT_EQ(refusal_of_lines("DQc\n").substr(0, 4), "d:1:");
  EXPECT_EQ(refusal_of_lines("{\"n\":\"\xff\"}\n").find('\n'), std::string::npos);
}

}  // namespace
}  // namespace ar3d::testing
