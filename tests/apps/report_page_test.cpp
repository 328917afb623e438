// `ar3d report`: the reference that it compares with and the drawings that it stores.
#include <set>

#include "ar3d/store/rows.h"
#include "support/program.h"
#include "support/tables.h"

namespace ar3d::testing {
namespace {

const std::string kReferences = AR3D_SOURCE_DIR "/results/reference/";

nlohmann::json first_row(const std::string& page, const char* name) {
  return tables_in(read_file(page))[name].at(0);
}

std::string study_of(const ScratchDirectory& scratch, const std::string& name) {
  const std::string spec = scratch.write(
      name + ".toml", "study = \"" + name +
                          "\"\nseed = 1\n[[sweep]]\nfamilies = [\"prism\", \"random-cubic\"]\n"
                          "sizes = [8, 20, 3000]\nalgorithms = [\"grid\"]\ninstances = 1\n");
  const std::string results = scratch.path(name + ".h5");
  expect_exit(0, run("{} study run " + spec + " -q -o " + results));
  return results;
}

TEST(ReportPage, ComparesWithTheCommittedReferenceOfItsStudy) {
  const ScratchDirectory scratch;
  const std::string page = scratch.path("page.html");
  expect_exit(
      0, run("cd " AR3D_SOURCE_DIR " && {} report " + kReferences + "0.2.0-volume.h5 -o " + page));
  const nlohmann::json since = first_row(page, "since");
  EXPECT_EQ(since["file"], "0.2.0-volume.h5");
  EXPECT_EQ(since["is_copy"], true);
  EXPECT_LT(fs::file_size(page), 6'500'000u);
}

TEST(ReportPage, ComparesWithTheGivenReferenceAndKeepsItsExitCode) {
  const ScratchDirectory scratch;
  const std::string base = study_of(scratch, "tiny"), now = scratch.path("now.h5");
  Results results = read_results(base);
  for (RunRecord& row : results.runs) {
    if (row.n > 8) continue;
    row.extents[0] += 1;  // still inside its bound
    row.drawing_hash = std::string(32, '0');
  }
  write_results(results, now);
  const std::string page = scratch.path("page.html"), report = "{} report " + now + " -o " + page;
  expect_exit(0, run(report + " --reference " + base));
  EXPECT_EQ(first_row(page, "since")["word"], "REGRESSED");
  EXPECT_EQ(first_row(page, "since")["file"], "tiny.h5");

  expect_exit(0, run("cd " + scratch.path("") + " && " + report));
  EXPECT_TRUE(first_row(page, "since")["why_none"].is_string());
  const std::string before = read_file(page);
  expect_error(run(report + " --reference " + study_of(scratch, "other")),
               "results of different studies");
  expect_error(run(report + " --reference " + scratch.path("none.h5")), "none.h5");
  EXPECT_EQ(read_file(page), before);
}

/// The rows of which the page holds drawings.
std::set<std::size_t> drawings_of(const std::string& page) {
  std::set<std::size_t> rows;
  const nlohmann::json tables = tables_in(read_file(page));
  for (const nlohmann::json& row : tables["graphs"]) {
    if (!row["drawing"].is_null()) rows.insert(row["row"].get<std::size_t>());
  }
  return rows;
}

TEST(ReportPage, StoresDrawingsThatComeOutAsRecordedAndNoLargeOnes) {
  const ScratchDirectory scratch;
  const std::string results = study_of(scratch, "tiny");
  // Rows 0, 1, 2 are prisms of 8, 20, 3000 vertices, 3, 4, 5 the others.
  EXPECT_EQ(drawings_of(scratch.path("tiny.html")), (std::set<std::size_t>{0, 1, 3, 4}));

  Results changed = read_results(results);
  changed.runs[0].drawing_hash = std::string(32, '0');  // drawn by another version
  changed.runs[1].n = changed.runs[1].requested_n = std::int64_t{1} << 40;
  changed.runs[3].family = "no-such-family";
  write_results(changed, scratch.path("changed.h5"));
  ASSERT_NE(run("{} report " + scratch.path("changed.h5")).exit_code, 2);
  EXPECT_EQ(drawings_of(scratch.path("changed.html")), std::set<std::size_t>{4});
}

}  // namespace
}  // namespace ar3d::testing
