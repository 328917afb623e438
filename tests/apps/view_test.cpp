// `ar3d view` and `ar3d draw --format html`; what the page does: tests/browser/viewer.test.mjs.
#include "support/program.h"

namespace ar3d::testing {
namespace {

TEST(View, WritesTheSamePageAsDraw) {
  const ScratchDirectory scratch;
  const std::string graphs = scratch.write("g.g6", "D~{\nC~\n");
  const std::string lines = scratch.path("d.jsonl");
  must("{} draw " + graphs + " --algorithm diamond -o " + lines);
  must("{} view " + lines);
  must("{} view " + lines);
  must("cd " + scratch.path("") +
       " && mv g.g6 d.jsonl-graphs && {} draw d.jsonl-graphs "
       "--algorithm diamond -o x.html && {} draw d.jsonl-graphs --algorithm diamond "
       "--format html > y.html");
  const std::string page = read_file(scratch.path("x.html"));
  EXPECT_EQ(page, read_file(scratch.path("y.html")));
  const auto size = [&](const char* name) { return fs::file_size(scratch.path(name)); };
  EXPECT_NEAR(static_cast<double>(size("d.html")), static_cast<double>(size("x.html")), 200);
  EXPECT_LT(page.size(), 1'000'000u);
  for (const char* foreign : {"src=", "href=\"http", "@import", "url("}) {
    EXPECT_THAT(page.substr(0, page.find("var THREE")), Not(HasSubstr(foreign)));
  }
}

TEST(View, SaysWhatIsWrong) {
  const ScratchDirectory scratch;
  const std::string lines = scratch.write("d.jsonl", "{\"n\":1,\"error\":\"none\"}\n");
  scratch.write("d.html", "<p>mine</p>");
  const auto expect_error = [](const std::string& command, const std::string& why) {
    expect_one_line(run(command), why);
  };
  expect_error("{} view " + lines, "d.html exists and is no page of `ar3d view`");
  EXPECT_EQ(read_file(scratch.path("d.html")), "<p>mine</p>");
  expect_error("{} view - < " + lines, "a page of standard input needs a name");
  expect_error("{} view " + lines + " -o " + scratch.path("no/x.html"), "no/x.html");
  expect_error("{} view " + lines + " -o " + lines, "would be overwritten");
  expect_error("{} view " + lines + " --algorithm hexagon -o " + scratch.path("x.html"),
               "unknown algorithm 'hexagon'");
  EXPECT_FALSE(fs::exists(scratch.path("x.html")));
  const std::string broken = scratch.write("b.jsonl", "{\"n\":1,\"error\":\"none\"}\n{\"n\":\n");
  expect_error("{} view " + broken + " -o " + scratch.path("x.html"), "b.jsonl:2:");
  EXPECT_FALSE(fs::exists(scratch.path("x.html"))) << "nothing half-written";
}

TEST(View, ShowsWhatWasNotDrawn) {
  const ScratchDirectory scratch;
  const std::string page = scratch.path("x.html");
  expect_error(run("printf 'E~~w\\nC~\\n' | {} draw - --algorithm diamond -o " + page),
               "<stdin>:1: diamond draws graphs of maximum degree 4");
  EXPECT_THAT(read_file(page), HasSubstr("\"error\":\"diamond draws graphs of maximum degree 4"));
}

}  // namespace
}  // namespace ar3d::testing
