#include "support/program.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "ar3d/base/printable.h"

namespace ar3d::testing {

ScratchDirectory::ScratchDirectory(const fs::path& parent) {
  std::string pattern = (parent / "ar3d-test-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("mkdtemp failed");
  root_ = pattern;
}

ScratchDirectory ScratchDirectory::in_memory() {
  const char* const memory = "/dev/shm";
  return ScratchDirectory(access(memory, W_OK) == 0 ? memory : fs::temp_directory_path());
}

ScratchDirectory::~ScratchDirectory() {
  std::error_code ignored;
  fs::remove_all(root_, ignored);
}

std::size_t ScratchDirectory::entries() const {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(root_), fs::directory_iterator()));
}

std::string ScratchDirectory::write(const std::string& name, const std::string& content) const {
  std::ofstream(path(name), std::ios::binary) << content;
  return path(name);
}

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

namespace {

void expect_parts(const Outcome& outcome, const char* stream, const std::string& text,
                  const Parts& parts, int exit_code, std::experimental::source_location where) {
  expect_exit(exit_code, outcome, where);
  for (const std::string& part : parts.all) {
    if (text.find(part) != std::string::npos) continue;
    ADD_FAILURE_AT(where.file_name(), static_cast<int>(where.line()))
        << stream << " has no '" << part << "'\n"
        << outcome.command << "\n"
        << outcome.out << outcome.err;
  }
}

}  // namespace

std::string with_fault(const std::string& fault) {
  return std::string("env ASAN_OPTIONS=verify_asan_link_order=0 LD_PRELOAD=") + AR3D_FAULT_SHIM +
         " AR3D_FAULT=" + fault + " ";
}

Outcome run(const std::string& command) {
  const ScratchDirectory scratch;
  const std::string line =
      "bash -c " + shell_word(boost::replace_all_copy(command, "{}", AR3D_PROGRAM)) + " > " +
      scratch.path("out") + " 2> " + scratch.path("err") + " < /dev/null";
  const int status = std::system(line.c_str());
  Outcome outcome;
  outcome.command = command;
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.out = read_file(scratch.path("out"));
  outcome.err = read_file(scratch.path("err"));
  return outcome;
}

void must(const std::string& command) {
  const Outcome outcome = run(command);
  if (outcome.exit_code == 0) return;
  throw std::runtime_error(command + " ended with exit code " + std::to_string(outcome.exit_code) +
                           ": " + outcome.err);
}

Outcome expect_exit(int exit_code, Outcome outcome, std::experimental::source_location where) {
  if (outcome.exit_code != exit_code) {
    ADD_FAILURE_AT(where.file_name(), static_cast<int>(where.line()))
        << "exit code " << outcome.exit_code << " instead of " << exit_code << "\n"
        << outcome.command << "\n"
        << outcome.out << outcome.err;
  }
  return outcome;
}

void expect_output(const Outcome& outcome, const Parts& parts, int exit_code,
                   std::experimental::source_location where) {
  expect_parts(outcome, "standard output", outcome.out, parts, exit_code, where);
}

void expect_error(const Outcome& outcome, const Parts& parts, int exit_code,
                  std::experimental::source_location where) {
  expect_parts(outcome, "standard error", outcome.err, parts, exit_code, where);
}

void expect_one_line(const Outcome& outcome, const std::string& part, int exit_code,
                     std::experimental::source_location where) {
  expect_error(outcome, part, exit_code, where);
  if (std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1) return;
  ADD_FAILURE_AT(where.file_name(), static_cast<int>(where.line()))
      << "not one line: " << outcome.err;
}

}  // namespace ar3d::testing
