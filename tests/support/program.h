#pragma once

#include <experimental/source_location>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "support/test.h"

namespace ar3d::testing {

/// What a shell command printed and how it ended.
struct Outcome {
  std::string command;
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// Runs a command line with bash (pipefail off: the last command's exit code counts). `{}` stands
/// for the ar3d program that was built with the tests.
Outcome run(const std::string& command);

/// Runs what a test needs to go on. @throws std::runtime_error unless its exit code is 0.
void must(const std::string& command);

/// Expects that exit code. @return the outcome.
Outcome expect_exit(
    int exit_code, Outcome outcome,
    std::experimental::source_location where = std::experimental::source_location::current());

/// One text or several in braces.
struct Parts {
  Parts(const char* part) : all{part} {}
  Parts(std::string part) : all{std::move(part)} {}
  Parts(std::initializer_list<std::string> parts) : all(parts) {}
  std::vector<std::string> all;
};

/// Expects that exit code, and all parts on standard output.
void expect_output(
    const Outcome& outcome, const Parts& parts, int exit_code = 0,
    std::experimental::source_location where = std::experimental::source_location::current());

/// Expects that exit code, and all parts on standard error.
void expect_error(
    const Outcome& outcome, const Parts& parts, int exit_code = 2,
    std::experimental::source_location where = std::experimental::source_location::current());

/// Expects that exit code, and one line on standard error, which holds `part`.
void expect_one_line(
    const Outcome& outcome, const std::string& part, int exit_code = 2,
    std::experimental::source_location where = std::experimental::source_location::current());

/// What stands before a command so that it meets a fault of tests/shim/fault_shim.cpp, such as
/// "full:9000".
std::string with_fault(const std::string& fault);

/// A fresh directory of this test, removed by the destructor.
class ScratchDirectory {
 public:
  ScratchDirectory() : ScratchDirectory(fs::temp_directory_path()) {}
  explicit ScratchDirectory(const fs::path& parent);
  /// In memory where the system has such a place, since every committed file is synchronised.
  static ScratchDirectory in_memory();
  ~ScratchDirectory();
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;
  std::string path(const std::string& name) const { return root_ + "/" + name; }
  /// How many files and folders it holds.
  std::size_t entries() const;
  /// Writes a file into the directory and returns its path.
  std::string write(const std::string& name, const std::string& content) const;

 private:
  std::string root_;
};

std::string read_file(const std::string& path);

}  // namespace ar3d::testing
