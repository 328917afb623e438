// The names of a study's files. All are derived from the name of the results file, so that a killed
// study is found again and what it left is removed without touching other files.
#include "ar3d/bench/keep/study_files.h"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>

#include "ar3d/base/error.h"
#include "ar3d/base/number.h"
#include "ar3d/base/system_calls.h"
#include "ar3d/store/journal/journal_reader.h"
#include "ar3d/store/rows.h"

namespace ar3d {
namespace {

namespace fs = std::filesystem;
constexpr std::string_view kSuffix = ".journal";
constexpr std::string_view kRank = ".rank-";

// The number that stands between the two, from 1 on; nothing if no such number does.
std::optional<int> rank_between(std::string_view name, std::string_view before,
                                std::string_view after) {
  if (name.size() <= before.size() + after.size() || !name.starts_with(before) ||
      !name.ends_with(after)) {
    return std::nullopt;
  }
  name.remove_suffix(after.size());
  const auto rank = integer_of<int>(name.substr(before.size()));
  return rank && *rank >= 1 ? rank : std::nullopt;
}

std::string file_name(const std::string& path) { return fs::path(path).filename().string(); }

std::string folder_of(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

// The names of the files in the folder of a path. A folder that is not there has none; every other
// failure to list is an error, since what is not seen here would be taken for not there.
std::vector<std::string> names_beside(const std::string& path) {
  const std::string folder = folder_of(path);
  const auto refuse = [&folder](int reason) {
    throw InputError(fmt::format("cannot list {}: {}", folder, std::strerror(reason)));
  };
  const std::unique_ptr<DIR, int (*)(DIR*)> open(opendir(folder.c_str()), closedir);
  std::vector<std::string> names;
  if (!open && errno == ENOENT) return names;
  if (!open) refuse(errno);
  for (;;) {
    errno = 0;
    const dirent* entry = readdir(open.get());
    if (entry == nullptr && errno != 0) refuse(errno);
    if (entry == nullptr) return names;
    names.emplace_back(entry->d_name);
  }
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

std::string in_resolved_folder(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  if (folder.empty()) return path;
  std::error_code error;
  const fs::path resolved = fs::canonical(folder, error);
  if (error) return path;
  return (resolved / fs::path(path).filename()).string();
}

void require_results_name(const std::string& results) {
  const std::string name = file_name(results);
  const std::size_t at = name.rfind(kRank);
  const bool is_of_a_rank =
      at != std::string::npos && rank_between(name, name.substr(0, at) + std::string(kRank), "");
  if (name.empty() || name.ends_with(kSuffix) || is_of_a_rank ||
      name.find(".partial-") != std::string::npos) {
    throw InputError(fmt::format(
        "'{}' cannot name a results file: names that end in .journal or .rank-1, or hold "
        ".partial-, are of the files beside one",
        results));
  }
}

std::vector<std::string> existing_journals(const std::string& results) {
  const std::string own = file_name(results);
  std::vector<int> ranks;
  for (const std::string& name : names_beside(results)) {
    if (name == own + std::string(kSuffix)) ranks.push_back(0);
    if (const auto rank = rank_between(name, own + std::string(kRank), kSuffix)) {
      ranks.push_back(*rank);
    }
  }
  std::sort(ranks.begin(), ranks.end());
  std::vector<std::string> paths;
  for (const int rank : ranks) paths.push_back(journal_path(results, rank));
  return paths;
}

std::string results_path_of(const std::string& journal_or_results) {
  std::string path = journal_or_results;
  if (!path.ends_with(kSuffix)) return path;
  path.resize(path.size() - kSuffix.size());
  const std::size_t at = path.rfind(kRank);
  if (at == std::string::npos) return path;
  return rank_between(path, path.substr(0, at) + std::string(kRank), "") ? path.substr(0, at)
                                                                         : path;
}

std::string report_path(const std::string& results) {
  return fs::path(results).replace_extension(".html").string();
}

std::string drawings_path(const std::string& results) {
  return fs::path(results).replace_extension(".drawings.jsonl").string();
}

std::vector<std::string> own_files_of(const std::string& results) {
  return {results, report_path(results), drawings_path(results)};
}

void remove_study_leftovers(const std::string& results) {
  std::vector<std::string> paths = existing_journals(results);
  for (std::string& path : own_files_of(results)) paths.push_back(std::move(path));
  paths.push_back(journal_path(results));
  for (const std::string& path : paths) remove_leftovers(path);
}

// The journal of rank 0 is removed first.
bool rows_are_in_results(const std::string& results) {
  const std::vector<std::string> journals = existing_journals(results);
  if (journals.empty()) return true;
  return journals.front() != journal_path(results) && fs::exists(results) &&
         Rows(results).identity().created == journal_status(journals.front()).identity.created;
}

void remove_journals(const std::string& results) {
  for (const std::string& path : existing_journals(results)) {
    std::error_code error;
    fs::remove(path, error);
    if (error) throw InputError(fmt::format("cannot remove {}: {}", path, error.message()));
  }
}

Descriptor open_folder(const std::string& results) {
  Descriptor folder(open(folder_of(results).c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  if (folder.get() >= 0) return folder;
  throw InputError(fmt::format("cannot open {}: {}", folder_of(results), std::strerror(errno)));
}

std::string path_in_folder(const Descriptor& folder, const std::string& results) {
  const bool is_same = has_its_name(folder.get(), folder_of(results));
  std::error_code error;
  const fs::path now =
      is_same ? fs::path() : fs::read_symlink(fmt::format("/proc/self/fd/{}", folder.get()), error);
  return is_same || error ? results : (now / file_name(results)).string();
}

}  // namespace ar3d
