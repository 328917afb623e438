// Looks at all files of a verb before it works: what is still needed is not replaced.
#include "outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include "ar3d/base/error.h"
#include "ar3d/base/new_file.h"
#include "ar3d/base/print.h"
#include "ar3d/base/printable.h"
#include "ar3d/bench/keep/study_files.h"
#include "ar3d/bench/plan/plan.h"
#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/formats/catalog.h"
#include "ar3d/formats/drawings/catalog.h"
#include "ar3d/store/journal/journal_format.h"

namespace ar3d {
namespace {

namespace fs = std::filesystem;

// The value of the attribute `format` of every results file (results/SCHEMA.md).
constexpr const char* kResultsMark = "ar3d-results";

bool is_file_name(const std::string& path) { return !path.empty() && path != "-"; }

bool is_regular(const std::string& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

// Whether both names lead to one file, be it there already or not. Devices may be named twice.
bool are_one_file(const std::string& a, const std::string& b) {
  std::error_code error;
  if (fs::exists(a, error) || fs::exists(b, error)) {
    return fs::equivalent(a, b, error) && is_regular(a);
  }
  const auto resolved = [&](const std::string& path) {
    return fs::weakly_canonical(fs::absolute(path), error);
  };
  return resolved(a) == resolved(b) && !error;
}

void refuse_needed(const std::string& path, const VerbFiles& files) {
  std::error_code error;
  if (fs::is_symlink(path, error) && !fs::exists(path, error)) {
    throw InputError(fmt::format("cannot write {}: it is a symbolic link to nothing", path));
  }
  if (!is_regular(path)) return;
  const std::string beginning = beginning_of(path);
  if (begins_as_journal(beginning)) {
    throw InputError(fmt::format("{} is a study's journal, which is not overwritten", path));
  }
  const bool can_be_made_again =
      path == files.page && beginning.find(files.page_is) != std::string::npos;
  if (files.force || can_be_made_again) return;
  // A file without a byte (of mktemp, or of a shell's >) holds nothing to lose.
  if (fs::file_size(path, error) == 0) return;
  const bool is_results = beginning.starts_with("\x89HDF\r\n\x1a\n") &&
                          beginning.find(kResultsMark) != std::string::npos;
  throw InputError(fmt::format("{} exists{}; --force replaces it", path,
                               is_results ? " and is a results file" : ""));
}

// The journal of rank 0 is there as long as a study is not finished.
void refuse_unfinished(const std::string& path) {
  const std::string journal = journal_path(path);
  if (!is_regular(journal)) return;
  throw InputError(fmt::format(
      "{} is the results file of a study that is not finished: go on with `ar3d study resume {}`, "
      "or delete {}",
      path, shell_word(path), shell_word(journal)));
}

}  // namespace

// HDF5 itself is not asked: the file may be anybody's.
std::string beginning_of(const std::string& path) {
  if (!is_regular(path)) return {};
  std::array<char, 4096> bytes{};
  std::ifstream in(path, std::ios::binary);
  in.read(bytes.data(), bytes.size());
  return {bytes.data(), static_cast<std::size_t>(in.gcount())};
}

void add_force(CLI::App& verb, bool& force) {
  verb.add_flag("--force", force, "replace outputs that exist");
}

void refuse_unsafe_outputs(const VerbFiles& files) {
  std::vector<std::string> outputs = files.outputs;
  outputs.push_back(files.page);
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const std::string& output = outputs[i];
    if (output == "-" && !files.streams) {
      throw InputError("- is no name of a file, and this output is not written to standard output");
    }
    if (!is_file_name(output)) continue;
    for (const std::string& input : files.inputs) {
      if (is_file_name(input) && are_one_file(input, output)) {
        throw InputError(fmt::format("{} would be overwritten by what is made from it", output));
      }
    }
    for (std::size_t other = 0; other < i; ++other) {
      if (is_file_name(outputs[other]) && are_one_file(outputs[other], output)) {
        throw InputError(fmt::format("{} is named for two outputs", output));
      }
    }
    refuse_unfinished(output);
    refuse_needed(output, files);
  }
  for (const std::string& output : outputs) {
    if (is_file_name(output)) remove_leftovers(output);
  }
}

void make_folder(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) throw InputError(fmt::format("cannot create {}: {}", path, error.message()));
}

void write_json(const std::string& path, const std::string& text) {
  if (path == "-") return print("{}", text);
  write_file_atomically(path, text);
}

void refuse_foreign_ending(const std::string& path, const std::vector<std::string>& own) {
  if (!is_file_name(path)) return;
  const std::string ending = path_ending(path);
  if (ending.empty() || std::ranges::count(own, ending) > 0) return;
  const auto is_of = [&](const auto& format) {
    return std::ranges::count(format.extensions, ending) > 0;
  };
  constexpr std::array<std::string_view, 9> kOthers = {".csv", ".h5", ".hdf5", ".pdf", ".png",
                                                       ".jpg", ".md", ".toml", ".tex"};
  if (std::ranges::count(kOthers, ending) == 0 && std::ranges::none_of(graph_formats(), is_of) &&
      std::ranges::none_of(drawing_formats(), is_of)) {
    return;
  }
  throw InputError(
      fmt::format("{}: this file is written as {}, not as {}", path, own.front(), ending));
}

std::vector<std::string> files_of_study(const StudyIdentity& identity, const std::string& results) {
  Study study = recorded_study(identity, results);
  study.own_files = own_files_of(results);
  std::vector<std::string> files = graph_files_of(study);
  files.push_back(results);
  for (const auto& program : study.spec.programs) {
    for (const std::string& word : program->command) {
      if (is_regular(word)) files.push_back(word);
    }
  }
  return files;
}

void refuse_foreign_page(const std::string& page, const std::string& results) {
  if (!is_regular(page) || beginning_of(page).find(VerbFiles().page_is) != std::string::npos)
    return;
  throw InputError(
      fmt::format("{} exists and is no report of ar3d: the report of {} would replace it; choose "
                  "another name",
                  page, results));
}

}  // namespace ar3d
