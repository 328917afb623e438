#include "ar3d/bench/keep/study_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>

#include "ar3d/results/hdf5/results_reader.h"
#include "ar3d/results/journal/journal_reader.h"

namespace ar3d {
namespace {

namespace fs = std::filesystem;
constexpr std::string_view kSuffix = ".journal";
constexpr std::string_view kRank = ".rank-";

// What a journal's name says.
struct Name {
  std::string results;
  int rank = 0;
};

std::optional<Name> parse_name(std::string path) {
  if (!path.ends_with(kSuffix)) return std::nullopt;
  path.resize(path.size() - kSuffix.size());
  const std::size_t at = path.rfind(kRank);
  if (at == std::string::npos) return Name{path, 0};
  int rank = 0;
  const char* end = path.data() + path.size();
  const auto read = std::from_chars(path.data() + at + kRank.size(), end, rank);
  if (read.ec != std::errc() || read.ptr != end || rank < 1) return Name{path, 0};
  return Name{path.substr(0, at), rank};
}

// The files in the folder of the results file.
std::vector<std::string> neighbours(const std::string& results) {
  const fs::path folder = fs::path(results).parent_path();
  std::vector<std::string> paths;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, ignored)) {
    paths.push_back((folder / entry.path().filename()).string());
  }
  return paths;
}

}  // namespace

std::string path_of_shard(const std::string& results, const Shard& shard) {
  if (shard.count == 1) return results;
  const fs::path path(results);
  return (path.parent_path() / path.stem()).string() +
         fmt::format(".shard-{}-of-{}", shard.index, shard.count) + path.extension().string();
}

std::string journal_path(const std::string& results, int rank) {
  if (rank == 0) return fmt::format("{}{}", results, kSuffix);
  return fmt::format("{}{}{}{}", results, kRank, rank, kSuffix);
}

std::vector<std::string> existing_journals(const std::string& results) {
  std::vector<std::pair<int, std::string>> found;
  for (const std::string& path : neighbours(results)) {
    const auto name = parse_name(path);
    if (name && name->results == results) {
      found.emplace_back(name->rank, journal_path(results, name->rank));
    }
  }
  std::sort(found.begin(), found.end());
  std::vector<std::string> paths;
  for (auto& [rank, path] : found) paths.push_back(std::move(path));
  return paths;
}

std::string results_path_of(const std::string& journal_or_results) {
  const auto name = parse_name(journal_or_results);
  return name ? name->results : journal_or_results;
}

std::string report_path(const std::string& results) {
  return fs::path(results).replace_extension(".html").string();
}

void remove_leftovers(const std::string& results) {
  const std::string page = report_path(results);
  for (const std::string& path : neighbours(results)) {
    const bool ours = path.starts_with(results + ".") || path.starts_with(page + ".");
    std::error_code ignored;  // they do no harm
    if (ours && path.find(".partial-") != std::string::npos) fs::remove(path, ignored);
  }
}

// The journal of rank 0 is removed first.
bool rows_are_in_results(const std::string& results) {
  const std::vector<std::string> journals = existing_journals(results);
  if (journals.empty()) return true;
  return journals.front() != journal_path(results) && fs::exists(results) &&
         ResultsReader(results).identity().created ==
             journal_status(journals.front()).identity.created;
}

void remove_journals(const std::string& results) {
  for (const std::string& path : existing_journals(results)) fs::remove(path);
}

}  // namespace ar3d
