#pragma once

#include <fstream>
#include <string>

#include "support/program.h"

namespace ar3d::testing {

/// A checkout whose build runs `command`, and then gives the program of this test.
inline std::string pretended_checkout(const ScratchDirectory& scratch, const std::string& command) {
  const std::string checkout = scratch.path("checkout");
  fs::create_directories(checkout + "/apps");
  std::ofstream(checkout + "/CMakeLists.txt")
      << "cmake_minimum_required(VERSION 3.20)\nproject(pretended NONE)\n"
         "add_custom_target(ar3d_program COMMAND "
      << command
      << " COMMAND ${CMAKE_COMMAND} -E make_directory apps COMMAND ${CMAKE_COMMAND} -E copy "
         "$ENV{AR3D_PROGRAM} apps/ar3d)\n";
  expect_exit(0,
              run("cd " + checkout +
                  " && touch apps/study.cpp && git init -q && git add -A && git -c user.name=t -c "
                  "user.email=t@t commit -qm first"));
  return checkout;
}

/// What a build may not leave behind.
inline void expect_no_worktree(const std::string& checkout) {
  const Outcome trees = run("git -C " + checkout + " worktree list");
  EXPECT_EQ(std::count(trees.out.begin(), trees.out.end(), '\n'), 1) << trees.out;
  for (const auto& entry : fs::directory_iterator(checkout + "/build/compare")) {
    EXPECT_THAT(entry.path().string(), Not(HasSubstr("sources")));
    EXPECT_THAT(entry.path().string(), Not(HasSubstr("run-")));
  }
}

}  // namespace ar3d::testing
