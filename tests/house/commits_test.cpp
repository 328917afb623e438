// What is said of a change stays readable where logs show it: subjects of at most 72 characters.
#include <sstream>

#include "support/program.h"

namespace ar3d::testing {
namespace {

constexpr std::size_t kLongestSubject = 72;

std::size_t characters(const std::string& utf8) {
  std::size_t count = 0;
  for (const char c : utf8) count += (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  return count;
}

TEST(Commits, HaveShortSubjects) {
  const Outcome log = run("git -C " AR3D_SOURCE_DIR " log -50 --no-merges --format=%s");
  if (log.exit_code != 0) GTEST_SKIP() << "no git repository";
  std::istringstream subjects(log.out);
  for (std::string subject; std::getline(subjects, subject);) {
    EXPECT_LE(characters(subject), kLongestSubject) << subject;
  }
}

}  // namespace
}  // namespace ar3d::testing
