// Many files as one family: names, groups, files that are none, and what their rows' keys depend
// on.
#include <fmt/format.h>

#include <set>

#include "ar3d/base/error.h"
#include "ar3d/bench/corpus/corpus.h"
#include "ar3d/bench/run/row_maker.h"
#include "bench/graph_files.h"

namespace ar3d::testing {
namespace {

class Collections : public GraphFiles {
 protected:
  void SetUp() override {
    for (const char* folder : {"c", "c/a", "c/b", "c/b/.hidden"}) {
      fs::create_directory(scratch_.path(folder));
    }
    write("c/a/one.graphml", {petersen()});
    write("c/b/two.s6", {complete(4), complete(5), generate(find_family("cycle"), 7, 0)});
    write("c/b/.hidden/x.s6", {complete(3)});
    write("c/top.edges", {petersen()});  // the same graph as in a/one.graphml
  }
  // "group graph_name n key" of each instance.
  std::vector<std::string> rows(const std::string& entry) const {
    std::vector<std::string> rows;
    for (const PlannedInstance& instance :
         plan_study(study("graphs = " + entry + "\n")).instances) {
      const RunRecord row = planned_row(instance, instance.runs.front());
      EXPECT_EQ(row.family, "mine");
      keys.insert(row.row_key);
      rows.push_back(fmt::format("{} {} {}", row.group, row.graph_name, instance.n));
    }
    return rows;
  }
  mutable std::set<std::string> keys;
};

TEST_F(Collections, AFolderIsOneFamilyWithGroupsAndNames) {
  const auto all = ElementsAre("b two.s6#0 4", "b two.s6#1 5", "b two.s6#2 7", "a one.graphml 10",
                               ". top.edges 10");
  EXPECT_THAT(rows("{ files = \"c\", name = \"mine\" }"), all);
  EXPECT_EQ(keys.size(), 5u) << "two files with the same graphs have rows of their own";
  EXPECT_THAT(rows("{ files = \"c/*\", name = \"mine\" }"), all);
  EXPECT_EQ(keys.size(), 5u);
  EXPECT_THAT(rows("{ files = \"c/*/*.graphml\", name = \"mine\" }"),
              ElementsAre("a one.graphml 10"));
  EXPECT_THAT(rows("{ files = \"c/top.edges\", name = \"mine\" }"), ElementsAre(" top.edges 10"));
  EXPECT_EQ(keys.size(), 5u) << "files that come to a collection change no key";
  EXPECT_EQ(rows("{ files = \"c\", name = \"mine\", sample = 2 }").size(), 2u);
  EXPECT_EQ(keys.size(), 5u);
}

TEST_F(Collections, ATableMayNameTheGroups) {
  scratch_.write("groups.csv", "# file, group\na/one.graphml, sparse\ntwo.s6,dense ones\n\nno,x\n");
  EXPECT_THAT(rows("{ files = \"c\", name = \"mine\", groups = \"groups.csv\" }"),
              ElementsAre("dense ones b/two.s6#0 4", "dense ones b/two.s6#1 5",
                          "dense ones b/two.s6#2 7", "sparse a/one.graphml 10", " top.edges 10"));
}

TEST_F(Collections, FilesThatAreNoGraphsAreRefusedOrListed) {
  scratch_.write("c/README.md", "# Graphs\n\nof mine\n");
  scratch_.write("c/b/half.s6", ":An\n:!\n");
  must("mkfifo " + scratch_.path("c/pipe"));
  EXPECT_THAT(problem([&] { rows("{ files = \"c\", name = \"mine\" }"); }),
              HasSubstr("README.md:3:"));
  EXPECT_EQ(rows("{ files = \"c\", name = \"mine\", skip = true }").size(), 6u);
  const Study spec = study("graphs = { files = \"c\", name = \"mine\", skip = true }\n");
  const std::vector<StudyCorpus> corpora = corpora_of(spec);
  std::vector<std::string> skipped;
  for (const SkippedFile& file : corpora.front().corpus->skipped()) {
    skipped.push_back(file.file + ": " + file.reason.substr(file.reason.rfind('/') + 1));
  }
  ASSERT_EQ(skipped.size(), 3u);
  EXPECT_THAT(skipped[0], HasSubstr("README.md: README.md:3:"));
  EXPECT_THAT(skipped[1],
              AllOf(HasSubstr("half.s6: half.s6:2:"), HasSubstr("the 1 graphs before")));
  EXPECT_EQ(skipped[2], "pipe: pipe: it is no regular file");
}

TEST_F(Collections, WhatCannotBeIsRefusedInOneLine) {
  scratch_.write("none.csv", "x,1\n");
  scratch_.write("page.json", "{\"nodes\": []}\n");
  scratch_.write("more.json", "[]\n");
  scratch_.write("twice.csv", "top.edges,1\ntop.edges,2\n");
  scratch_.write("broken.csv", "top.edges\n");
  scratch_.write("long.csv", "top.edges," + std::string(49, 'g') + "\n");
  fs::create_directory(scratch_.path("empty"));
  const std::pair<const char*, const char*> cases[] = {
      {"{ files = \"c\" }", "lacks 'name'"},
      {"{ files = \"c\", name = \"cycle\" }", "is the name of a family"},
      {"{ files = \"empty\", name = \"mine\" }", "no file matches 'empty'"},
      {"{ files = \"pa*\", name = \"mine\" }", "page.json:1"},
      {"{ files = \"gone\", name = \"mine\" }", "gone: it is no regular file"},
      {"{ files = \"*.json\", name = \"mine\", skip = true }", "none of 2 files holds a graph"},
      {"{ file = \"c/top.edges\", name = \"x\", groups = \"none.csv\" }", "unknown key 'groups'"},
      {"{ files = \"c\", name = \"mine\", groups = \"none.csv\" }", "names no file of mine"},
      {"{ files = \"c\", name = \"mine\", groups = \"twice.csv\" }",
       "twice.csv:2: 'top.edges' is of"},
      {"{ files = \"c\", name = \"mine\", groups = \"broken.csv\" }",
       "broken.csv:1: 'top.edges' is no line"},
      {"{ files = \"c\", name = \"mine\", groups = \"long.csv\" }",
       "is not 48 bytes of printable text"},
      {"[{ files = \"c\", name = \"mine\" }, \"c/top.edges\"]",
       "a file of top.edges holds the same graphs as one of mine"},
  };
  for (const auto& [entry, message] : cases) {
    const std::string told = problem([&, entry = entry] { rows(entry); });
    EXPECT_THAT(told, HasSubstr(message)) << entry;
    EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 0) << told;
  }
}

TEST_F(Collections, AStudyThatBeganNoticesAChangeOfFilesAndGroups) {
  const std::string entry = "graphs = { files = \"c\", name = \"mine\" }\n";
  std::vector<GraphFileRecord> files;
  for (const StudyCorpus& corpus : corpora_of(study(entry))) files.push_back(corpus.record);
  ASSERT_EQ(files.size(), 1u);
  EXPECT_EQ(files[0].graphs, 5);
  const auto later = [&] {
    Study spec = study(entry);
    spec.begun_with = files;
    return problem([&] { plan_study(spec); });
  };
  EXPECT_EQ(later(), "");
  fs::rename(scratch_.path("c/top.edges"), scratch_.path("c/b/top.edges"));
  EXPECT_THAT(later(), HasSubstr("its graphs are not those that the study began with"));
}

}  // namespace
}  // namespace ar3d::testing
