#include "ar3d/formats/drawings/drawing_jsonl.h"

#include "ar3d/base/random.h"
#include "formats/format_helpers.h"
#include "verify/draft.h"

namespace ar3d::testing {
namespace {

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

const Drawing kEdge = Draft{{{0, 0, 0}, {3, -3, 1}}, {{{1, 0}, {{3, 0, 1}, {0, 0, 1}}}}}.drawing();
constexpr const char* kEdgeLine =
    R"({"n":2,"algorithm":"draft","gram":[[1,0,0],[0,1,0],[0,0,1]],"gram_denominator":1,)"
    R"("vertices":[[0,0,0],[3,-3,1]],"edges":[[1,0,[[3,0,1],[0,0,1]]]]})"
    "\n";

TEST(DrawingJsonl, WritesTheContractsLine) {
  EXPECT_EQ(line_of(kEdge), kEdgeLine);
  std::string text;
  append_error_line(text, {7, "vertex 3 has \"degree\" 5"});
  EXPECT_EQ(text, "{\"n\":7,\"error\":\"vertex 3 has \\\"degree\\\" 5\"}\n");
}

TEST(DrawingJsonl, EmptyDrawing) {
  const std::string line = line_of(Draft{{}, {}, kScaledZLattice}.drawing());
  EXPECT_EQ(
      line,
      "{\"n\":0,\"algorithm\":\"draft\",\"gram\":[[3,0,0],[0,3,0],[0,0,1]],\"gram_denominator\":3,"
      "\"vertices\":[],\"edges\":[]}\n");
  const auto back = read_lines(line);
  ASSERT_EQ(back.size(), 1u);
  EXPECT_EQ(std::get<Drawing>(back[0]).lattice(), kScaledZLattice);
}

TEST(DrawingJsonl, GivesBackWhatItWrote) {
  RandomStream random(1);
  std::string text;
  for (int i = 0; i < 50; ++i) {
    Draft draft{std::vector<Point>(20), {}};
    const auto coordinate = [&] {
      const auto wide =
          static_cast<std::int64_t>(random.below64(2 * kMaxCoordinate)) - kMaxCoordinate;
      return i % 2 ? wide : wide >> 40;
    };
    const auto point = [&] { return Point{coordinate(), coordinate(), coordinate()}; };
    for (Point& p : draft.vertices) p = point();
    for (Vertex v = 1; v < 20; ++v) {
      draft.edges.push_back({{v, random.below(v)}, std::vector(random.below(4), point())});
    }
    append_drawing_line(text, draft.drawing());
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

/// Expects that the line of one edge with a part replaced is refused with that message.
void expect_refused(const std::vector<std::array<std::string, 3>>& cases) {
  for (const auto& [part, by, message] : cases) {
    std::string line = kEdgeLine;
    const std::size_t at = line.find(part);
    ASSERT_NE(at, std::string::npos) << part;
    EXPECT_EQ(refusal_of_lines(kEdgeLine + line.replace(at, part.size(), by)), "d:2:" + message);
  }
}

TEST(DrawingJsonl, RefusesNumbersThatAreNotExact) {
  expect_refused(
      {{"-3", "-3.0", " vertices[1][1]: expected an integer of 64 bits, found '-3.0'"},
       {"-3", "3e2", " vertices[1][1]: expected an integer of 64 bits, found '3e2'"},
       {"-3", "99999999999999999999",
        " vertices[1][1]: expected an integer of 64 bits, found '99999999999999999999'"},
       {"-3", "9223372036854775808",
        " vertices[1][1]: 9223372036854775808 does not fit 64 bits with sign"},
       {"-3", "2305843009213693953",
        " vertices[1][1]: coordinate 2305843009213693953 is out of range, the limit is "
        "2305843009213693952"},
       {"[3,0,1]", "[3,0,-9223372036854775808]",
        " edges[0][2][0][2]: coordinate -9223372036854775808 is out of range, the limit is "
        "2305843009213693952"},
       {"[[1,0,0]", "[[4294967296,0,0]",
        " gram[0][3]: 4294967296 is not in -2147483647..2147483647"}});
}

TEST(DrawingJsonl, RefusesWrongShapes) {
  expect_refused(
      {{"[3,-3,1]", "[3,-3]", " vertices[1]: 2 numbers instead of 3"},
       {"[3,-3,1]", "[3,-3,1,4]", " vertices[1][3]: unexpected fourth number 4"},
       {"[3,-3,1]", "7", " vertices[1]: unexpected number 7"},
       {"[3,-3,1]", "null", " vertices[1]: unexpected null"},
       {"[3,-3,1]", "{}", " vertices[1]: unexpected object"},
       {"[3,-3,1]", "[3,[1],1]", " vertices[1][1]: unexpected array"},
       {",[[3,0,1],[0,0,1]]", "", " edges[0]: an edge is [u, v, [bends]]"},
       {"[1,0,[[", "[1,[[", " edges[0][1]: unexpected array"},
       {"[1,0,[[", "[1,0,5,[[", " edges[0][2]: unexpected number 5"},
       {"[3,0,1],", "[3,0],", " edges[0][2][0]: 2 numbers instead of 3"},
       {"\"draft\"", "true", " algorithm: unexpected true"},
       {"\"gram\":[", "\"gram\":[[1,1,1],", " gram[3]: unexpected fourth row"},
       {"[1,0,0],", "", " gram: 2 rows instead of 3"},
       {"[[3,0,1],[0,0,1]]", "",
        "126: syntax error while parsing value - unexpected ']'; expected '[', '{', or a "
        "literal"}});
}

TEST(DrawingJsonl, RefusesWhatDoesNotFitTogether) {
  expect_refused(
      {{"\"n\":2", "\"n\":3", " n is 3, but there are 2 vertices"},
       {"\"n\":2", "\"n\":-2", " n: -2 is no number of vertices"},
       {"[1,0,[[", "[1,2,[[",
        " edge 0 (1, 2) of the drawing: vertex out of range, it has 2 vertices"},
       {"[1,0,0]", "[1,2,0]", " the Gram matrix is not symmetric"},
       {"[1,0,0]", "[-1,0,0]", " the Gram matrix is not positive definite"},
       {"\"gram_denominator\":1", "\"gram_denominator\":0",
        " gram_denominator: 0 is not in 1..2147483647"},
       {"\"n\":2,", "", " key 'n' is missing"},
       {"\"gram_denominator\":1,", "", " key 'gram_denominator' is missing"},
       {"\"n\":2,", "\"n\":2,\"n\":2,", " key 'n' stands twice"},
       {"\"n\":2,", "\"n\":2,\"m\":1,", " unknown key 'm'"},
       {"\"n\":2,", "\"n\":2,\"error\":\"x\",", " a line with 'error' has no other key than 'n'"}});
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
