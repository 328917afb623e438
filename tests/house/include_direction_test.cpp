// The folders are the data flow: who may include whom is the table of docs/architecture.md.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

namespace ar3d {
namespace {

namespace fs = std::filesystem;
using Allowed = std::map<std::string, std::set<std::string>>;

const Allowed& allowed() {
  static const Allowed table = {
      {"model", {}},
      {"formats", {"model"}},
      {"generators", {"model"}},
      {"algorithms", {"model"}},
      {"verify", {"model"}},
      {"results", {"model"}},
      {"bench", {"model", "formats", "generators", "algorithms", "verify", "results"}},
      {"analysis", {"model", "results"}},
      {"apps",
       {"model", "formats", "generators", "algorithms", "verify", "results", "bench", "analysis"}},
  };
  return table;
}

bool is_source(const fs::path& path) {
  return path.extension() == ".h" || path.extension() == ".cpp";
}

/// The folder that an include line names, or "" for includes of others.
std::string included_folder(const std::string& line) {
  const std::string mark = "\"ar3d/";
  const std::size_t at = line.find(mark);
  if (line.rfind("#include", 0) != 0 || at == std::string::npos) return "";
  const std::size_t begin = at + mark.size();
  const std::size_t slash = line.find('/', begin);
  return slash == std::string::npos ? "" : line.substr(begin, slash - begin);
}

std::vector<std::string> forbidden_includes(const fs::path& root, const Allowed& table) {
  std::vector<std::string> found;
  for (const auto& [folder, may_include] : table) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (!is_source(entry.path())) continue;
      std::ifstream file(entry.path());
      std::string line;
      while (std::getline(file, line)) {
        const std::string target = included_folder(line);
        if (target.empty() || target == folder || may_include.count(target) > 0) continue;
        found.push_back(fs::relative(entry.path(), root).string() + ": " + line);
      }
    }
  }
  return found;
}

TEST(IncludeDirection, FollowsTheTable) {
  for (const std::string& line : forbidden_includes(AR3D_SOURCE_DIR, allowed()))
    ADD_FAILURE() << line;
}

TEST(IncludeDirection, SeesForbiddenIncludes) {
  Allowed strict = allowed();
  strict["verify"].clear();  // verify does include model, so this table must be violated
  EXPECT_FALSE(forbidden_includes(AR3D_SOURCE_DIR, strict).empty());
}

TEST(IncludeDirection, OnlyResultsIncludesHdf5) {
  for (const auto& [folder, unused] : allowed()) {
    if (folder == "results") continue;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(AR3D_SOURCE_DIR) / folder)) {
      if (!is_source(entry.path())) continue;
      std::ifstream file(entry.path());
      std::string line;
      while (std::getline(file, line)) {
        EXPECT_EQ(line.find("#include <hdf5"), std::string::npos) << entry.path();
      }
    }
  }
}

}  // namespace
}  // namespace ar3d
