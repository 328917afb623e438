#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace ar3d::testing {

/// What references are checked against: the files of a source tree, and the help of the program.
struct Tree {
  std::map<std::string, std::string> files;  ///< text by path, '/' between folders
  std::map<std::string, std::string> help;   ///< by verb and sub-verb: "", "draw", "study run", ...
};

/// The files below `root` that people write: no build folders, no hidden ones, nothing binary.
Tree read_tree(const std::string& root);

/// Expects that `lacks` finds nothing in any file whose whole path matches, of which there are more
/// than `least`.
void expect_of_sources(const char* pattern, int least,
                       const std::function<std::string(const std::string& text)>& lacks);

/// Asks the program for its help, verb by verb.
std::map<std::string, std::string> read_help();

/// References in comments (of C++, JavaScript, style sheets, Python, CMake and shell) and pages
/// that lead nowhere, as "file:line: what". What is looked at:
///  - Lemma, Rule, Step and Repair with a number, which a page defines in bold (CONTRIBUTING.md,
///  "How to
///    cite"); bare numbers, and numbers of notes that are not in the tree;
///  - in backticks: functions, types and columns (a word of the code), files, tests
///    (Suite.Name), commands of the program with their options;
///  - options, in backticks or not;
///  - links between pages and to headings, and paths that begin with a folder of the tree.
std::vector<std::string> dangling_references(const Tree& tree);

}  // namespace ar3d::testing
