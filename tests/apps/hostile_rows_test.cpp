// Rows with keys and texts that no program of ours writes, and readers of rows that lie.
#include <fmt/format.h>

#include <tuple>

#include "ar3d/store/rows.h"
#include "support/program.h"
#include "support/results.h"

namespace ar3d::testing {
namespace {

TEST(Keys, AreOfThePlan) {
  const ScratchDirectory scratch;
  const std::string file = scratch.path("r.h5");
  must("{} study run smoke -q -o " + file);
  Results strange = read_results(file);
  strange.runs[5].row_key = std::string(31, '0') + "1";
  write_results(strange, scratch.path("p.h5"));
  expect_error(run("{} study resume -q " + scratch.path("p.h5")), "is none of study smoke");
  EXPECT_FALSE(fs::exists(scratch.path("p.h5.journal"))) << "the study is as it was";
  strange.runs[5].row_key = std::string(32, '0');
  write_results(strange, file);
  expect_error(run("{} check " + file), "r.h5: the key of row 5 is zero");
  const std::string status = "{} study status " + file;
  expect_error(run(status), "r.h5: the key of row 5 is zero");
  strange.runs[5].row_key = strange.runs[3].row_key;
  write_results(strange, file);
  for (const std::string verb : {"check ", "report ", "study resume -q ", "study status "}) {
    expect_error(run("{} " + verb + file), "r.h5: rows 3 and 5 have one key, ");
  }
  strange.runs[5].row_key = std::string(31, '0') + "1";
  strange.runs.push_back(strange.runs[5]);
  strange.runs.back().row_key[0] = '1';
  write_results(strange, file);
  const Outcome more = run(status);
  expect_error(more, "r.h5: 1081 rows, but its study plans 1080: there is no row 1080");
  EXPECT_EQ(more.out, "") << "no word of completeness";
}

// A row that no program of ours writes names its file, and nothing is begun with it.
TEST(Keys, AndTextsOfRowsThatAreNoneNameTheirFile) {
  const ScratchDirectory scratch;
  must("{} study run smoke -q -o " + scratch.path("good.h5"));
  for (const auto& [column, value, message] :
       std::vector<std::tuple<std::string, std::string, std::string>>{
           {"row_key", "1c5f", "'1c5f' is no row key"},
           {"phase", "other", "unknown phase 'other'"},
           {"status", "fine", "unknown status 'fine'"}}) {
    const std::string cd = "cd " + scratch.path("") + " && ";
    must(cd + "cp good.h5 r.h5 && /usr/bin/python3 -c 'import h5py; f = h5py.File(\"r.h5\", " +
         "\"r+\"); row = f[\"runs\"][5]; row[\"" + column + "\"] = b\"" + value +
         "\"; f[\"runs\"][5] = row'");
    renew_checksum(scratch.path("r.h5"));
    for (const std::string verb : {"check r.h5", "study status r.h5", "report r.h5",
                                   "study resume -q r.h5", "study merge r.h5 -o m.h5"}) {
      const bool is_merge = verb.starts_with("study merge") && column != "row_key";
      const Outcome refused = run(cd + "{} " + verb);
      if (!is_merge) {
        expect_one_line(refused, "ar3d: r.h5: ");
        EXPECT_THAT(refused.err, HasSubstr(message)) << verb;
      }
      EXPECT_EQ(run("ls " + scratch.path("") + " | grep r.h5.").out, "") << verb;
    }
  }
}

/// What the process that reads a results file says is checked: lies 1 to 10 of the fault shim.
TEST(Readers, ThatLieAreRefusedByTheNameOfTheFile) {
  const ScratchDirectory scratch;
  must("{} study run smoke -q -o " + scratch.path("r.h5"));
  const std::string bytes = read_file(scratch.path("r.h5"));
  for (int lie = 1; lie <= 10; ++lie) {
    const std::string program = "cd " + scratch.path("") + " && timeout 60 " +
                                with_fault(fmt::format("lie:{}", lie)) + "{} ";
    for (const std::string verb :
         {"check r.h5", "study status r.h5", "report r.h5", "study resume -q r.h5", "replay r.h5 0",
          "compare r.h5 r.h5", "study merge r.h5 -o m.h5", "study count r.h5 -o m.h5"}) {
      const Outcome refused = run(program + verb);
      expect_one_line(refused, "ar3d: r.h5");
      EXPECT_THAT(refused.out, Not(HasSubstr("complete"))) << lie << ' ' << verb;
    }
    EXPECT_EQ(read_file(scratch.path("r.h5")), bytes) << lie;
    EXPECT_EQ(scratch.entries(), 2u) << lie << ": rows and their page";
  }
}

}  // namespace
}  // namespace ar3d::testing
