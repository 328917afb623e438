// Lists the files of collections: patterns, folders, and the groups that a table gives. What no row
// can hold is said of its file, so that it can be skipped.
#include <fmt/format.h>
#include <glob.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>

#include "ar3d/base/error.h"
#include "ar3d/base/printable.h"
#include "ar3d/bench/corpus/corpus.h"
#include "ar3d/bench/plan/plan.h"
#include "ar3d/formats/text/tokens.h"
#include "ar3d/store/journal/journal_format.h"

namespace ar3d {
namespace {

namespace fs = std::filesystem;

// A folder's files and those of its sub-folders; what begins with a dot or ends with a tilde (an
// editor's copy) is left out, and links to folders are not followed. What cannot be read is refused
// where it is to be.
void add_folder(const std::string& top, std::vector<std::string>& files) {
  std::vector<std::string> folders = {top};
  while (!folders.empty()) {
    const std::string folder = std::move(folders.back());
    folders.pop_back();
    std::error_code error, ignored;
    fs::directory_iterator at(folder, error);
    for (; !error && at != fs::directory_iterator(); at.increment(error)) {
      const std::string name = at->path().filename().string();
      if (name.starts_with('.') || name.ends_with('~')) continue;
      if (!at->is_directory(ignored)) {
        files.push_back(at->path().string());
      } else if (!at->is_symlink(ignored)) {
        folders.push_back(at->path().string());
      }
    }
    if (error) files.push_back(folder);
  }
}

// One of the study's own files, whatever the way to its folder.
bool is_own(const fs::path& file, const std::vector<std::string>& own_files) {
  return std::ranges::any_of(own_files, [&](const fs::path& own) {
    std::error_code ignored;
    return file.filename() == own.filename() &&
           fs::equivalent(file.parent_path(), fs::absolute(own).parent_path(), ignored);
  });
}

// What any study has beside its graphs, known by name and content: a journal, results, a report,
// drawings, or an unfinished or cut one of them. Of one that is empty or gone the name has to do.
bool is_of_a_study(const std::string& file) {
  constexpr std::pair<std::string_view, std::string_view> kKinds[] = {
      {".journal", kJournalStart},
      {".h5", "\x89HDF\r\n\x1a\n"},
      {".hdf5", "\x89HDF\r\n\x1a\n"},
      {".html", "<title>ar3d "},
      {".jsonl", "{\"n\":"}};
  static const std::regex piece("(\\.partial-[0-9]+-[0-9a-f]{16}|\\.journal\\.cut-[0-9]+)$");
  if (std::regex_search(file, piece)) return true;
  for (const auto& [ending, mark] : kKinds) {
    if (!file.ends_with(ending)) continue;
    std::array<char, 4096> bytes{};
    std::ifstream in(file, std::ios::binary);
    in.read(bytes.data(), bytes.size());
    const std::string_view beginning(bytes.data(), static_cast<std::size_t>(in.gcount()));
    return beginning.empty() || beginning.find(mark) != std::string_view::npos;
  }
  return false;
}

// The folder that the names of a collection's files begin behind.
fs::path base_of(const std::string& path) {
  const std::size_t wildcard = path.find_first_of("*?[");
  std::error_code ignored;
  if (wildcard == std::string::npos || fs::exists(path, ignored)) {
    return fs::is_directory(path, ignored) ? fs::path(path) : fs::path(path).parent_path();
  }
  return path.substr(0, path.rfind('/', wildcard));
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

// A table "FILE,GROUP": a tab, else the last comma, else the last blank is between them.
std::map<std::string, std::string, std::less<>> read_groups(const std::string& path) {
  std::map<std::string, std::string, std::less<>> groups;
  TextInput input(path);
  while (const std::optional<std::string_view> line = input.next_line()) {
    const std::string_view text = trimmed(*line);
    if (text.empty() || is_comment(text)) continue;
    std::size_t between = text.find('\t');
    if (between == std::string_view::npos) between = text.rfind(',');
    if (between == std::string_view::npos) between = text.rfind(' ');
    if (between == std::string_view::npos) {
      input.fail(0, fmt::format("{} is no line 'FILE,GROUP'", shown(text)));
    }
    const std::string file(trimmed(text.substr(0, between)));
    const std::string group(trimmed(text.substr(between + 1)));
    if (groups.try_emplace(file, group).first->second == group) continue;
    input.fail(0, fmt::format("{} is of group {} above, and of {} here", shown(file),
                              shown(groups.at(file)), shown(group)));
  }
  return groups;
}

// A file whose group no row can hold, or whose path is too long, cannot be read.
void require_group(CorpusFile& file) {
  constexpr std::size_t kLongestGroup = 48, kLongestPath = 512;
  std::size_t bytes = 0;  // as results hold it
  for (const char c : file.file) bytes += c > ' ' && c <= '~' && c != '%' ? 1 : 3;
  if (bytes > kLongestPath) {
    file.problem = fmt::format("{}: its path within the collection takes {} bytes, more than {}",
                               printable(file.path), bytes, kLongestPath);
  }
  if (file.group.size() <= kLongestGroup && printable(file.group) == file.group) return;
  file.problem = fmt::format(
      "{}: group {} is not {} bytes of printable text; `groups` names a table of others",
      printable(file.path), shown(file.group), kLongestGroup);
}

constexpr const char* kCollection = "collection ";  // before its path in a key

std::vector<std::string> matches(const std::string& path) {
  std::error_code ignored;
  if (!is_pattern(path) || fs::exists(path, ignored)) return {path};
  glob_t found{};
  glob(path.c_str(), 0, nullptr, &found);
  std::vector<std::string> files(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  globfree(&found);
  return files;
}

std::vector<std::string> collected_now(const std::string& path,
                                       const std::vector<std::string>& own_files) {
  std::vector<std::string> files;
  try {
    for (const std::string& match : matches(path)) {
      std::error_code ignored;
      if (fs::is_directory(match, ignored)) {
        add_folder(match, files);
      } else {
        files.push_back(match);
      }
    }
  } catch (const fs::filesystem_error& error) {
    throw InputError(fmt::format("cannot read {}: {}", printable(error.path1().string()),
                                 error.code().message()));
  }
  std::erase_if(files, [&](const std::string& file) {
    return is_own(file, own_files) || is_of_a_study(file);
  });
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

bool is_pattern(const std::string& file) { return file.find_first_of("*?[") != std::string::npos; }

[[noreturn]] void refuse_empty(const GraphsEntry& entry) {
  throw InputError(fmt::format("{}no file matches '{}'", entry.location, printable(entry.file)));
}

const std::vector<std::string>& listed_files(const Study& study, const std::string& path,
                                             bool is_collection) {
  OpenFiles& open_files = *study.open_files;
  if (!open_files.listed) open_files.listed = std::chrono::system_clock::now();
  const std::string key = (is_collection ? kCollection : "") + path;
  const auto known = open_files.listings.find(key);
  if (known != open_files.listings.end()) return known->second;
  std::vector<std::string> found =
      is_collection ? collected_now(path, study.own_files) : matches(path);
  std::error_code ignored;
  if (!is_collection && is_pattern(path)) {
    std::erase_if(found, [&](const std::string& file) { return fs::is_directory(file, ignored); });
  }
  return open_files.listings[key] = std::move(found);
}

std::vector<std::string> files_come_since(const Study& study) {
  std::vector<std::string> come;
  for (const auto& [key, then] : study.open_files->listings) {
    if (!key.starts_with(kCollection)) continue;
    const std::string path = key.substr(std::string_view(kCollection).size());
    std::error_code ignored;
    if (!is_pattern(path) && !fs::exists(path, ignored)) continue;
    std::ranges::set_difference(collected_now(path, study.own_files), then,
                                std::back_inserter(come));
  }
  return come;
}

std::vector<CorpusFile> collected_files(const GraphFileRecord& record, const GraphsEntry& entry,
                                        const Study& study) {
  std::map<std::string, std::string, std::less<>> groups;
  if (!record.groups.empty()) groups = read_groups(record.groups);
  const fs::path base = base_of(record.path);
  std::vector<CorpusFile> files;
  bool any_group = groups.empty();
  bool has_folders = false;
  for (const std::string& found : listed_files(study, record.path, true)) {
    const fs::path within = fs::path(found).lexically_relative(base);
    CorpusFile file{
        found, within.filename().string(), within.parent_path().string(), {}, within.string()};
    has_folders = has_folders || !file.group.empty();
    if (!record.groups.empty()) {
      file.name = file.file;
      auto group = groups.find(file.name);
      if (group == groups.end()) group = groups.find(within.filename().string());
      file.group = group == groups.end() ? "" : group->second;
      any_group = any_group || group != groups.end();
    }
    require_group(file);
    files.push_back(std::move(file));
  }
  for (CorpusFile& file :
       files) {  // beside groups of sub-folders those of the folder itself are one
    if (groups.empty() && has_folders && file.group.empty()) file.group = ".";
  }
  if (!any_group) {
    throw InputError(fmt::format("{}{} names no file of {}", entry.location,
                                 printable(record.groups), record.name));
  }
  return files;
}

}  // namespace ar3d
