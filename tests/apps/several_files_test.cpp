// Verbs that take several files, and the names of vertices on their way to drawings and pages.
#include "support/program.h"

namespace ar3d::testing {
namespace {

class SeveralFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    scratch_.write("a.edges", "alice bob\nbob carol\n");
    scratch_.write("b.gml",
                   "graph [ node [ id 1 label \"<x> & y\" ] node [ id 2 ] "
                   "edge [ source 1 target 2 ] ]\n");
    must(in("{} generate petersen -n 10 -o c.g6"));
  }
  std::string in(const std::string& command) const {
    return "cd " + scratch_.path("") + " && " + command;
  }
  ScratchDirectory scratch_;
};

TEST_F(SeveralFiles, AreDrawnVerifiedShownAndHuntedInOneGo) {
  must(in("{} draw a.edges b.gml c.g6 --algorithm grid -o all.jsonl"));
  must(in(
      "{} draw a.edges --algorithm grid -o a.jsonl && {} draw c.g6 --algorithm grid -o c.jsonl"));
  expect_output(run(in("{} verify all.jsonl --graphs a.edges --graphs b.gml --graphs c.g6")),
                "3 certified, 0 violated");
  expect_output(run(in("{} verify a.jsonl c.jsonl")), "2 certified, 0 violated");
  expect_error(run(in("{} verify a.jsonl c.jsonl --graphs a.edges")),
               "a.edges has 1 graphs, but a.jsonl c.jsonl has more drawings");
  expect_exit(0, run(in("{} view a.jsonl c.jsonl -o page.html")));
  EXPECT_THAT(read_file(scratch_.path("page.html")),
              AllOf(HasSubstr("about-0"), HasSubstr("about-1")));
  expect_one_line(run(in("{} view a.jsonl c.jsonl")), "a page of several files needs a name");
  expect_one_line(run(in("{} draw a.edges c.g6 --algorithm grid -o x.svg")), "one drawing");
  expect_one_line(run(in("{} draw a.edges none.g6 --algorithm grid")), "cannot read none.g6");
  expect_one_line(run(in("{} draw a.edges c.g6 --algorithm grid -o c.g6 --format jsonl")), "c.g6");
  expect_output(run(in("{} hunt --algorithm grid --graphs c.g6 --graphs a.edges --evaluations 20")),
                "comes from 2 files (");
}

TEST_F(SeveralFiles, NamesTravelToDrawingsPagesAndExports) {
  must(in("{} draw a.edges b.gml --algorithm grid -o d.jsonl"));
  const std::string lines = read_file(scratch_.path("d.jsonl"));
  EXPECT_THAT(lines, HasSubstr(",\"names\":[\"alice\",\"bob\",\"carol\"]}\n"));
  EXPECT_THAT(lines, HasSubstr(R"("names":["<x> & y","2"]})"));
  expect_exit(0, run(in("{} verify d.jsonl")));
  must(in("{} view d.jsonl"));
  EXPECT_THAT(read_file(scratch_.path("d.html")), HasSubstr(R"("names":["alice","bob","carol"])"));
  must(
      in("{} draw a.edges --algorithm grid -o d.svg && {} draw a.edges --algorithm grid -o "
         "d.graphml"));
  EXPECT_THAT(read_file(scratch_.path("d.svg")), HasSubstr("<title>bob</title></circle>"));
  EXPECT_THAT(read_file(scratch_.path("d.graphml")),
              HasSubstr("<node id=\"n1\"><data key=\"name\">bob</data>"));
  expect_output(run(in("{} draw d.graphml --algorithm grid")),
                "\"names\":[\"alice\",\"bob\",\"carol\"]");
}

TEST_F(SeveralFiles, NamesInALineAreAsManyAsVertices) {
  must(in("{} draw a.edges --algorithm grid -o d.jsonl"));
  for (const auto& [names, message] :
       {std::pair("[\"a\"]", "n is 3, but there are 1 names"),
        std::pair("[1]", "unexpected number 1"), std::pair("[[\"a\"]]", "unexpected array"),
        std::pair("\"a\"", "unexpected text 'a'"), std::pair("{}", "unexpected object")}) {
    std::string line = read_file(scratch_.path("d.jsonl"));
    const std::string old = "[\"alice\",\"bob\",\"carol\"]";
    line.replace(line.find(old), old.size(), names);
    expect_error(run(in("{} verify " + scratch_.write("bad.jsonl", line))), message);
  }
}

}  // namespace
}  // namespace ar3d::testing
