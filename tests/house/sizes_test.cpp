// Functions have at most 60 lines and files at most 400 (CONTRIBUTING.md). A table
// or a text inside a function is not counted.
#include <cctype>
#include <regex>
#include <sstream>

#include "support/program.h"

namespace ar3d::testing {
namespace {

using Lines = std::vector<std::string>;

constexpr std::size_t kLongestFunction = 60;
constexpr std::size_t kLongestFile = 400;

Lines lines_of(const std::string& text) {
  Lines lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::size_t indent(const std::string& line) { return line.find_first_not_of(' '); }

/// The line that closes the block opened on line `begin`: the next one that starts with "}" and is
/// indented by at most `column`.
std::size_t closing(const Lines& lines, std::size_t begin, std::size_t column) {
  std::size_t at = begin + 1;
  while (at < lines.size() && (indent(lines[at]) > column || lines[at][indent(lines[at])] != '}'))
    ++at;
  return at;
}

/// Lines of a block without the tables in it: what stands between "return {" or "= {" and its end.
std::size_t counted(const Lines& lines, std::size_t begin, std::size_t end) {
  static const std::regex kTable(R"(.*(return|=) \{)");
  std::size_t count = 0;
  bool raw = false;  // inside a text of several lines
  for (std::size_t at = begin; at <= end && at < lines.size(); ++at) {
    if (!raw) ++count;
    if (lines[at].find("R\"") != std::string::npos) raw = true;
    if (lines[at].find(")\"") != std::string::npos) raw = false;
    if (raw) continue;
    if (at > begin && std::regex_match(lines[at], kTable))
      at = closing(lines, at, indent(lines[at]));
  }
  return count;
}

/// The functions of a formatted source that are too long, by line. Functions stand at column 0, in
/// a class at column 2; their first line may go on for several lines until the one that ends in
/// "{".
std::vector<std::string> long_functions(const Lines& lines) {
  static const std::regex kNoFunction(
      R"--(\s*(inline )?(namespace|class|struct|enum|union|return|switch|for|if|while|do|else|try)\b.*|.*= ?\{|.*R"\w*\(.*)--");
  std::vector<std::string> found;
  for (const std::size_t column : {0, 2}) {
    std::size_t head = lines.size();
    for (std::size_t at = 0; at < lines.size(); ++at) {
      const std::string& line = lines[at];
      if (indent(line) == column && std::isalpha(static_cast<unsigned char>(line[column])) != 0)
        head = at;
      if (line.empty() || line.back() != '{' || head == lines.size()) continue;
      if (indent(line) != column && indent(line) < column + 4) continue;
      if (std::regex_match(lines[head], kNoFunction)) continue;
      const std::size_t end = closing(lines, at, column);
      if (counted(lines, at, end) > kLongestFunction) found.push_back(lines[head]);
      at = end;
      head = lines.size();
    }
  }
  return found;
}

std::vector<fs::path> sources() {
  std::vector<fs::path> found;
  for (const auto& folder : fs::directory_iterator(AR3D_SOURCE_DIR)) {
    if (!fs::exists(folder.path() / "CMakeLists.txt")) continue;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      const fs::path& path = entry.path();
      if (path.extension() == ".h" || path.extension() == ".cpp") found.push_back(path);
    }
  }
  return found;
}

TEST(Sizes, OfFunctionsAndFilesKeepTheLimits) {
  for (const fs::path& path : sources()) {
    const Lines lines = lines_of(read_file(path));
    EXPECT_LE(lines.size(), kLongestFile) << path;
    for (const std::string& function : long_functions(lines))
      ADD_FAILURE() << path << ": more than " << kLongestFunction << " lines: " << function;
  }
}

Lines function_of(std::size_t length, const std::string& body) {
  Lines lines = {"int f(int a,", "      int b) {"};
  while (lines.size() < length) lines.push_back(body);
  lines.push_back("}");
  return lines;
}

TEST(Sizes, SeeALongFunctionButNotALongTable) {
  EXPECT_EQ(long_functions(function_of(60, "  f(1, 2);")).size(), 0u);
  EXPECT_EQ(long_functions(function_of(63, "  f(1, 2);")).size(), 1u);
  Lines table = function_of(100, "      {1, 2},");
  table[2] = "  return {";
  table.insert(table.end() - 1, "  };");
  EXPECT_EQ(long_functions(table).size(), 0u);
}

}  // namespace
}  // namespace ar3d::testing
