// What README prints runs as it is printed. (Its library section: tests/house/consumer.cmake.)
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <sstream>
#include <string>

#include "support/program.h"

namespace ar3d {
namespace {

using testing::Outcome;
using testing::run;
using testing::ScratchDirectory;

/// The first code block of `language` after `heading`.
std::string block(const std::string& heading, const std::string& language) {
  const std::string page = testing::read_file(AR3D_SOURCE_DIR "/README.md");
  const std::string mark = "```" + language + "\n";
  const std::size_t begin = page.find(mark, page.find("\n" + heading + "\n"));
  if (begin == std::string::npos) return "echo no such block >&2; exit 99";
  const std::size_t text = begin + mark.size();
  return page.substr(text, page.find("```", text) - text);
}

/// Command lines with the program that was built; without those that build another one or run the
/// whole suite.
std::string runnable(const std::string& block) {
  std::string commands;
  std::istringstream lines(block);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("compare --base") != std::string::npos) continue;
    commands += std::regex_replace(line, std::regex(R"(\./ar3d)"), AR3D_PROGRAM) + "\n";
  }
  return commands;
}

TEST(Readme, CommandsAndPythonRunAsPrinted) {
  const ScratchDirectory folder;
  const std::string enter = "cd " + folder.path("") + " && ";
  const Outcome shell = run(enter + "set -euo pipefail; " + runnable(block("## Use it", "sh")));
  ASSERT_EQ(shell.exit_code, 0) << shell.err;
  for (const char* made : {"smoke.html", "k5.html", "drawing.html", "six.h5"}) {
    EXPECT_TRUE(std::filesystem::exists(folder.path(made))) << made;
  }
  folder.write("printed.py", block("## Use it", "python"));
  const Outcome python = run(enter + "/usr/bin/python3 -W error::FutureWarning printed.py");
  EXPECT_EQ(python.exit_code, 0) << python.err;
  EXPECT_THAT(python.out, ::testing::HasSubstr("diamond"));
}

}  // namespace
}  // namespace ar3d
