// The folders are the data flow: who may include whom is written in the tables of
// docs/architecture.md, which this test reads.
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "support/program.h"

namespace ar3d::testing {
namespace {

/// A folder or sub-folder, "bench" or "bench/run", and what of its own kind it may include.
using Allowed = std::map<std::string, std::set<std::string>>;

std::set<std::string> words_of(const std::string& cell) {
  static const std::regex kWord("[a-z_]+");
  std::set<std::string> words;
  for (std::sregex_iterator at(cell.begin(), cell.end(), kWord), end; at != end; ++at)
    words.insert(at->str());
  return words;
}

/// The rows "| `bench/` | … | model, formats |" of a page: a name in backquotes that ends in "/",
/// and the last cell. Rows that say "everything" or nothing are no rules.
Allowed tables_of(const std::string& page) {
  static const std::regex kRow(R"(\| `([a-z_/0-9]+)/` \|(?:.*\|)? ([a-z_, –]+) \|)");
  Allowed table;
  std::istringstream lines(page);
  std::smatch row;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, row, kRow) && row[2] != "everything")
      table[row[1]] = words_of(row[2]);
  }
  return table;
}

/// Sub-folders whose row says "everything": the rule of their folder is not theirs.
std::set<std::string> free_sub_folders(const std::string& page) {
  static const std::regex kRow(R"(\| `([a-z_]+/[a-z_0-9]+)/` \|(?:.*\|)? everything \|)");
  std::set<std::string> folders;
  std::istringstream lines(page);
  std::smatch row;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, row, kRow)) folders.insert(row[1]);
  }
  return folders;
}

Allowed allowed() { return tables_of(read_file(AR3D_SOURCE_DIR "/docs/architecture.md")); }

bool is_source(const fs::path& path) {
  return path.extension() == ".h" || path.extension() == ".cpp";
}

/// The path below ar3d/ that an include line names, or "" for includes of others.
std::string included(const std::string& line) {
  const std::string mark = "\"ar3d/";
  const std::size_t at = line.find(mark);
  if (line.rfind("#include", 0) != 0 || at == std::string::npos) return "";
  const std::size_t begin = at + mark.size();
  return line.substr(begin, line.find('"', begin) - begin);
}

/// A folder of a path, by its place: "bench" and "run" of bench/run/session.h; "" if the path is
/// shorter.
std::string part(const std::string& path, std::size_t index) {
  std::istringstream parts(path);
  std::string name;
  for (std::size_t i = 0; i <= index; ++i) std::getline(parts, name, '/');
  return parts.eof() ? "" : name;
}

/// Whether a file of `folder` ("bench" or "bench/run") may include `target` ("bench/plan/plan.h").
bool may_include(const std::string& folder, const std::set<std::string>& others,
                 const std::string& target) {
  const std::size_t slash = folder.find('/');
  if (slash == std::string::npos) {
    const std::string to = part(target, 0);
    return to == folder || others.count(to) > 0;
  }
  if (part(target, 0) != folder.substr(0, slash)) return true;  // the outer table's matter
  const std::string to = part(target, 1);
  return to.empty() || to == folder.substr(slash + 1) || others.count(to) > 0;
}

std::vector<std::string> forbidden_includes(const fs::path& root, const Allowed& table) {
  std::vector<std::string> found;
  const std::set<std::string> free =
      free_sub_folders(read_file(AR3D_SOURCE_DIR "/docs/architecture.md"));
  for (const auto& [folder, others] : table) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string path = fs::relative(entry.path(), root).string();
      if (!is_source(path) || free.count(part(path, 0) + "/" + part(path, 1)) > 0) continue;
      std::ifstream file(entry.path());
      for (std::string line; std::getline(file, line);) {
        const std::string target = included(line);
        if (target.empty() || may_include(folder, others, target)) continue;
        found.push_back(path + ": " + line);
      }
    }
  }
  return found;
}

TEST(IncludeDirection, FollowsTheTables) {
  EXPECT_THAT(forbidden_includes(AR3D_SOURCE_DIR, allowed()), IsEmpty());
}

/// What is left of a relation when whatever leads to nothing that is left, or is led to by nothing
/// that is left, goes: its rings, and what lies between two of them.
Allowed rings_of(Allowed table) {
  for (std::size_t before = 0; before != table.size();) {
    before = table.size();
    std::set<std::string> used;
    for (auto& row : table) {
      std::erase_if(row.second,
                    [&](const auto& to) { return to == row.first || !table.contains(to); });
      used.insert(row.second.begin(), row.second.end());
    }
    std::erase_if(table,
                  [&](const auto& row) { return row.second.empty() || !used.contains(row.first); });
  }
  return table;
}

/// "bench/run/" of all that stands in a sub-folder; else the path without its ending, which header
/// and source have in common.
std::string place_of(const std::string& path) {
  const std::string sub_folder = part(path, 1);
  if (sub_folder.empty()) return path.substr(0, path.rfind('.'));
  return part(path, 0) + "/" + sub_folder + "/";
}

Allowed includes_of(const fs::path& root, const std::set<std::string>& folders) {
  Allowed includes;
  for (const std::string& folder : folders) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (!is_source(entry.path())) continue;
      std::set<std::string>& targets =
          includes[place_of(fs::relative(entry.path(), root).string())];
      std::ifstream file(entry.path());
      for (std::string line; std::getline(file, line);) targets.insert(place_of(included(line)));
    }
  }
  return includes;
}

TEST(IncludeDirection, HasNoRings) {
  Allowed table = allowed();
  for (auto& [folder, others] : table) {
    const std::size_t slash = folder.find('/');
    if (slash == std::string::npos) continue;
    std::set<std::string> whole;
    for (const std::string& other : others) whole.insert(folder.substr(0, slash + 1) + other);
    others = whole;
  }
  EXPECT_THAT(rings_of(table), IsEmpty());
  table["base"].insert("model");
  EXPECT_EQ(rings_of(table).size(), 2u) << "base and model";
  // Files that stand beside each other may lead to each other; no sub-folder is among these.
  const std::set<std::string> folders = {"algorithms", "bench", "formats", "verify"};
  for (const auto& [place, targets] : rings_of(includes_of(AR3D_SOURCE_DIR, folders)))
    EXPECT_NE(place.back(), '/') << place << " leads to " << ::testing::PrintToString(targets);
}

TEST(IncludeDirection, HasARuleForEveryFolderWithSources) {
  const Allowed table = allowed();
  const fs::path root = AR3D_SOURCE_DIR;
  for (const auto& entry : fs::directory_iterator(root)) {
    const std::string folder = entry.path().filename();
    if (!fs::exists(entry.path() / "CMakeLists.txt") || folder == "apps" || folder == "tests")
      continue;
    EXPECT_TRUE(table.count(folder)) << folder;
  }
  for (const char* folder : {"bench", "formats", "store", "algorithms", "verify", "analysis"}) {
    for (const auto& entry : fs::directory_iterator(root / folder)) {
      const std::string name = entry.path().filename();
      if (!entry.is_directory() || name == "kernels" || name == "fuzz" || name == "studies")
        continue;
      EXPECT_TRUE(table.count(folder + ("/" + name))) << folder << "/" << name;
    }
  }
}

TEST(IncludeDirection, SeesForbiddenIncludes) {
  Allowed strict = allowed();
  strict["verify"].clear();  // verify does include model, so this table must be violated
  EXPECT_THAT(forbidden_includes(AR3D_SOURCE_DIR, strict), Not(IsEmpty()));
  Allowed inner = allowed();
  inner["bench/run"].clear();  // and so must this one: run makes what plan says
  EXPECT_THAT(forbidden_includes(AR3D_SOURCE_DIR, inner), Not(IsEmpty()));
}

TEST(IncludeDirection, OnlyStoreIncludesHdf5) {
  for (const auto& [folder, unused] : allowed()) {
    if (folder.rfind("store", 0) == 0) continue;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(AR3D_SOURCE_DIR) / folder)) {
      if (!is_source(entry.path())) continue;
      EXPECT_EQ(read_file(entry.path()).find("#include <hdf5"), std::string::npos) << entry.path();
    }
  }
}

}  // namespace
}  // namespace ar3d::testing
