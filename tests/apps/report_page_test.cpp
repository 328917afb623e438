// `ar3d report`: the reference that it compares with and the drawings that it stores.
#include "ar3d/store/run_storage.h"
#include "support/program.h"

namespace ar3d::testing {
namespace {

const std::string kReferences = AR3D_SOURCE_DIR "/results/reference/";

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
  EXPECT_THAT(read_file(page), HasSubstr("Since the reference <a href='#reference'>0.2.0-volume"));
  EXPECT_THAT(read_file(page), HasSubstr("The two hold the same measurements."));
  EXPECT_LT(fs::file_size(page), 8'000'000u);
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
  EXPECT_THAT(read_file(page), HasSubstr("<b>REGRESSED</b> against tiny.h5"));

  expect_exit(0, run("cd " + scratch.path("") + " && " + report));
  EXPECT_THAT(read_file(page), HasSubstr("Not compared: "));
  const std::string before = read_file(page);
  expect_error(run(report + " --reference " + study_of(scratch, "other")),
               "results of different studies");
  expect_error(run(report + " --reference " + scratch.path("none.h5")), "none.h5");
  EXPECT_EQ(read_file(page), before);
}

/// The element #drawings: {"row": place, …}.
std::string drawings_of(const std::string& page) {
  const std::string text = read_file(page), mark = "id=drawings>";
  const std::size_t at = text.find(mark) + mark.size();
  return text.substr(at, text.find("</script>", at) - at);
}

TEST(ReportPage, StoresDrawingsThatComeOutAsRecordedAndNoLargeOnes) {
  const ScratchDirectory scratch;
  const std::string results = study_of(scratch, "tiny");
  // Rows 0, 1, 2 are prisms of 8, 20, 3000 vertices, 3, 4, 5 the others.
  const std::string all = drawings_of(scratch.path("tiny.html"));
  for (const char* row : {"\"0\":", "\"1\":", "\"3\":", "\"4\":"}) EXPECT_THAT(all, HasSubstr(row));
  for (const char* row : {"\"2\":", "\"5\":"}) EXPECT_THAT(all, Not(HasSubstr(row)));

  Results changed = read_results(results);
  changed.runs[0].drawing_hash = std::string(32, '0');  // drawn by another version
  changed.runs[1].n = changed.runs[1].requested_n = std::int64_t{1} << 40;
  changed.runs[3].family = "no-such-family";
  write_results(changed, scratch.path("changed.h5"));
  ASSERT_NE(run("{} report " + scratch.path("changed.h5")).exit_code, 2);
  const std::string some = drawings_of(scratch.path("changed.html"));
  EXPECT_EQ(some, "{\"4\":0}");
}

}  // namespace
}  // namespace ar3d::testing
