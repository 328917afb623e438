// Drawings that a study keeps: which ones, and that nothing else is replaced.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "support/program.h"

namespace ar3d::testing {
namespace {

using ::testing::HasSubstr;

class KeptDrawings : public ::testing::Test {
 protected:
  // 2 algorithms, 2 families, 3 sizes, 2 instances of the random one: 18 drawings, 4 curves.
  std::string study(const std::string& keep) {
    const std::string path = scratch_.path("study.toml");
    std::ofstream(path) << "study = \"k\"\nkeep_drawings = \"" << keep << "\"\n[[sweep]]\n"
                        << "families = [\"cycle\", \"random-cubic\"]\nsizes = [6, 10, 30]\n"
                        << "algorithms = [\"diamond\", \"two-bend\"]\ninstances = 2\n"
                        << "repetitions = 2\nlevel = [\"extents\", \"full\"]\n";
    return path;
  }
  Outcome make(const std::string& keep, const std::string& more = "") {
    return run(kProgram + " study run " + study(keep) + " -q --threads 2 -o " + results_ + more);
  }
  std::string text() const {
    std::ifstream in(drawings_);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  long lines() const {
    const std::string all = text();
    return std::count(all.begin(), all.end(), '\n');
  }

  ScratchDirectory scratch_;
  std::string results_ = scratch_.path("k.h5");
  std::string drawings_ = scratch_.path("k.drawings.jsonl");
};

TEST_F(KeptDrawings, NoneUnlessAskedFor) {
  EXPECT_EQ(make("none").exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(drawings_));
}

TEST_F(KeptDrawings, AllAreThereOnceAndCertified) {
  const Outcome outcome = expect_exit(0, make("all"));
  EXPECT_THAT(outcome.out, HasSubstr("drawings " + drawings_ + ": 18 kept (all)"));
  const Outcome verified = expect_exit(0, run(kProgram + " verify " + drawings_));
  EXPECT_THAT(verified.out, HasSubstr("18 certified, 0 violated"));
  EXPECT_EQ(run(kProgram + " view " + drawings_ + " -o " + scratch_.path("k-view.html")).exit_code,
            0);
}

TEST_F(KeptDrawings, TheWorstOfEachCurve) {
  EXPECT_EQ(make("worst").exit_code, 0);
  EXPECT_EQ(lines(), 4);
  const std::string once = text();
  const Outcome again = expect_exit(0, run(kProgram + " study drawings " + results_ + " -o -"));
  EXPECT_EQ(again.out, once);
}

TEST_F(KeptDrawings, OfRightStudiesNoneIsViolated) {
  EXPECT_EQ(make("violated").exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(drawings_));
  EXPECT_EQ(text(), "");
}

TEST_F(KeptDrawings, NothingIsReplacedUnasked) {
  std::ofstream(drawings_) << "notes\n";
  EXPECT_EQ(make("all").exit_code, 2);
  EXPECT_EQ(text(), "notes\n");
  EXPECT_FALSE(std::filesystem::exists(results_));
  EXPECT_EQ(make("none").exit_code, 0);
  expect_error(run(kProgram + " study drawings " + results_),
               "k.drawings.jsonl exists; --force replaces it");
  EXPECT_EQ(run(kProgram + " study drawings " + results_ + " --force").exit_code, 0);
  EXPECT_EQ(lines(), 4);
  std::ofstream(drawings_) << "notes\n";
  EXPECT_EQ(make("all", " --force").exit_code, 0);
  EXPECT_EQ(lines(), 18);
  std::ofstream(drawings_) << "notes\n";
  expect_error(run(kProgram + " study resume " + results_ + " -q"),
               "is no file of drawings and stays as it is", 3);
  EXPECT_EQ(text(), "notes\n");
}

TEST_F(KeptDrawings, AResumedStudyKeepsThemToo) {
  EXPECT_EQ(make("all").exit_code, 0);
  const std::string whole = text();
  std::filesystem::remove(drawings_);
  EXPECT_EQ(run(kProgram + " study resume " + results_ + " -q").exit_code, 0);
  EXPECT_EQ(text(), whole);
}

TEST_F(KeptDrawings, AStudyThatWasWholeLeavesThemAsTheyAre) {
  EXPECT_EQ(make("worst").exit_code, 0);
  EXPECT_EQ(run(kProgram + " study drawings " + results_ + " --keep all --force").exit_code, 0);
  const Outcome resumed = expect_exit(0, run(kProgram + " study resume " + results_ + " -q"));
  EXPECT_THAT(resumed.out, HasSubstr("k.drawings.jsonl: as it was, no row is new"));
  EXPECT_EQ(lines(), 18) << "somebody asked for these";
}

TEST_F(KeptDrawings, AreJsonLines) {
  EXPECT_EQ(make("none").exit_code, 0);
  const std::string page = scratch_.path("page.html");
  expect_error(run(kProgram + " study drawings " + results_ + " -o " + page),
               "page.html: JSON lines are written, not html");
  EXPECT_FALSE(std::filesystem::exists(page));
}

TEST_F(KeptDrawings, OfShardsWhenTheyAreMerged) {
  const std::string toml = study("all");
  for (const std::string i : {"1", "2"}) {
    const Outcome part = expect_exit(0, run(kProgram + " study run " + toml + " -q --shard " + i +
                                            "/2 -o " + scratch_.path("part" + i + ".h5")));
    EXPECT_THAT(part.out, ::testing::Not(HasSubstr("drawings")));
  }
  expect_exit(0, run(kProgram + " study merge " + scratch_.path("part1.h5") + " " +
                     scratch_.path("part2.h5") + " -o " + results_));
  EXPECT_EQ(run(kProgram + " study drawings " + results_ + " --keep all").exit_code, 0);
  EXPECT_EQ(lines(), 18);
}

TEST_F(KeptDrawings, UnknownChoicesAreRefusedByLine) {
  const Outcome outcome = expect_exit(2, make("best"));
  EXPECT_THAT(
      outcome.err,
      HasSubstr("study.toml:2: keep_drawings 'best' is none of none, worst, violated and all"));
}

}  // namespace
}  // namespace ar3d::testing
