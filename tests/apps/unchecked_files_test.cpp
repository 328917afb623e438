// Files of version 2 have no checksum: every verb that reads one says so.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "support/program.h"

namespace ar3d {
namespace {

using ::testing::HasSubstr;
using testing::Outcome;
using testing::run;

const std::string kFormer = AR3D_SOURCE_DIR "/results/reference/0.1.0-two-bend-million.h5";
const char* const kUnchecked =
    "two-bend-million.h5: a file of version 2 has no checksum: a value that was changed in it is "
    "not noticed";

TEST(UncheckedFiles, AreSaidByEveryVerb) {
  const testing::ScratchDirectory scratch;
  const std::string page = scratch.path("page.html");
  for (const std::string& verb :
       {"check " + kFormer, "study status " + kFormer, "compare " + kFormer + " " + kFormer,
        "report " + kFormer + " -o " + page,
        "study merge " + kFormer + " -o " + scratch.path("m.h5"), "replay " + kFormer + " 0"}) {
    const Outcome outcome = run("{} " + verb);
    EXPECT_THAT(outcome.err, HasSubstr(kUnchecked)) << verb;
  }
  EXPECT_THAT(testing::read_file(page), HasSubstr("none: the rows are of a file of version 2"));
}

}  // namespace
}  // namespace ar3d
