// Drawings that a study keeps: which ones, and that nothing else is replaced.
#include <fstream>

#include "support/program.h"

namespace ar3d::testing {
namespace {

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
    return run("{} study run " + study(keep) + " -q --threads 2 -o " + results_ + more);
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
  expect_exit(0, make("none"));
  EXPECT_FALSE(fs::exists(drawings_));
}

TEST_F(KeptDrawings, AllAreThereOnceAndCertified) {
  expect_output(make("all"),
                "drawings " + drawings_ + ": 18 kept (all; 54 more rows have one of these)");
  expect_output(run("{} verify " + drawings_), "18 certified, 0 violated");
  expect_exit(0, run("{} view " + drawings_ + " -o " + scratch_.path("k-view.html")));
}

TEST_F(KeptDrawings, TheWorstOfEachCurve) {
  expect_exit(0, make("worst"));
  EXPECT_EQ(lines(), 4);
  const std::string once = text();
  const Outcome again = expect_exit(0, run("{} replay " + results_ + " --keep worst -o -"));
  EXPECT_EQ(again.out, once);
}

TEST_F(KeptDrawings, OfRightStudiesNoneIsViolated) {
  expect_exit(0, make("violated"));
  EXPECT_TRUE(fs::exists(drawings_));
  EXPECT_EQ(text(), "");
}

TEST_F(KeptDrawings, NothingIsReplacedUnasked) {
  std::ofstream(drawings_) << "notes\n";
  expect_exit(2, make("all"));
  EXPECT_EQ(text(), "notes\n");
  EXPECT_FALSE(fs::exists(results_));
  expect_exit(0, make("none"));
  expect_error(run("{} replay " + results_ + " --keep worst"),
               "k.drawings.jsonl exists; --force replaces it");
  expect_exit(0, run("{} replay " + results_ + " --keep worst --force"));
  EXPECT_EQ(lines(), 4);
  std::ofstream(drawings_) << "notes\n";
  expect_exit(0, make("all", " --force"));
  EXPECT_EQ(lines(), 18);
  std::ofstream(drawings_) << "notes\n";
  expect_error(run("{} study resume " + results_ + " -q"),
               "is no file of drawings and stays as it is", 3);
  EXPECT_EQ(text(), "notes\n");
}

TEST_F(KeptDrawings, AResumedStudyKeepsThemToo) {
  expect_exit(0, make("all"));
  const std::string whole = text();
  fs::remove(drawings_);
  expect_exit(0, run("{} study resume " + results_ + " -q"));
  EXPECT_EQ(text(), whole);
}

TEST_F(KeptDrawings, AStudyThatWasWholeLeavesThemAsTheyAre) {
  expect_exit(0, make("worst"));
  expect_exit(0, run("{} replay " + results_ + " --keep all --force"));
  expect_output(run("{} study resume " + results_ + " -q"),
                "k.drawings.jsonl: as it was, no row is new");
  EXPECT_EQ(lines(), 18) << "the study asks for these";
}

TEST_F(KeptDrawings, AreJsonLines) {
  expect_exit(0, make("none"));
  const std::string page = scratch_.path("page.html");
  expect_error(run("{} replay " + results_ + " --keep worst -o " + page),
               "page.html: JSON lines are written, not html");
  EXPECT_FALSE(fs::exists(page));
}

TEST_F(KeptDrawings, OfShardsWhenTheyAreMerged) {
  const std::string toml = study("all");
  for (const std::string i : {"1", "2"}) {
    const Outcome part = expect_exit(0, run("{} study run " + toml + " -q --shard " + i + "/2 -o " +
                                            scratch_.path("part" + i + ".h5")));
    EXPECT_THAT(part.out, Not(HasSubstr("drawings")));
  }
  expect_exit(0, run("{} study merge " + scratch_.path("part1.h5") + " " +
                     scratch_.path("part2.h5") + " -o " + results_));
  expect_exit(0, run("{} replay " + results_ + " --keep all"));
  EXPECT_EQ(lines(), 18);
}

TEST_F(KeptDrawings, UnknownChoicesAreRefusedByLine) {
  expect_error(make("best"),
               "study.toml:2: keep_drawings 'best' is none of none, worst, violated and all");
}

}  // namespace
}  // namespace ar3d::testing
