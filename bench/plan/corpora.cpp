#include "ar3d/bench/plan/corpora.h"

#include <fmt/format.h>
#include <glob.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <utility>

#include "ar3d/base/error.h"
#include "ar3d/base/printable.h"
#include "ar3d/bench/spec/read_parts.h"
#include "ar3d/generators/random_graphs.h"

namespace ar3d {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kShuffleStream = 0x73687566666c65;  // "shuffle", as the families have it

std::string absolute_path(const std::string& folder, const std::string& file) {
  return fs::absolute(fs::path(folder) / file).lexically_normal().string();
}

// The files that match, by name; the file itself where it exists under that very name.
std::vector<std::string> matching_files(const std::string& path, const GraphsEntry& entry) {
  std::error_code error;
  const bool is_pattern = entry.file.find_first_of("*?[") != std::string::npos;
  if (!is_pattern || fs::exists(path, error)) return {path};
  glob_t found{};
  const int result = glob(path.c_str(), 0, nullptr, &found);
  std::vector<std::string> files(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  globfree(&found);
  if (result == 0 || result == GLOB_NOMATCH)
    std::erase_if(files, [](const std::string& file) {
      std::error_code ignored;
      return fs::is_directory(file, ignored);
    });
  if (files.empty()) {
    throw InputError(fmt::format("{}no file matches '{}'", entry.place, printable(entry.file)));
  }
  return files;
}

bool is_family(const std::string& name) {
  return std::any_of(families().begin(), families().end(),
                     [&](const Family& family) { return family.name == name; });
}

// The file's name, cut where it is too long; what no name may have becomes '_', and '_' stands
// before what no name begins with and before the name of a family of the catalogue.
std::string own_name(const std::string& path) {
  std::string name = fs::path(path).filename().string();
  for (char& c : name) {
    if (!is_graphs_name(std::string("a") + c)) c = '_';
  }
  std::string own = !is_graphs_name(name.substr(0, 1)) || is_family(name) ? "_" : "";
  own += name;
  return own.substr(0, kLongestGraphsName);
}

void require_name(const GraphFileRecord& record, const GraphsEntry& entry) {
  if (!is_family(record.name) && is_graphs_name(record.name)) return;
  throw InputError(fmt::format(
      "{}'{}' {}: {{ file = …, name = … }} gives {} another one", entry.place,
      printable(record.name),
      is_family(record.name) ? "is the name of a family of the catalogue" : "is no name for graphs",
      printable(record.path)));
}

class CorpusReader {
 public:
  CorpusReader(const StudySpec& spec, const std::string& only) : spec_(spec), only_(only) {}

  std::vector<StudyCorpus> read() {
    std::int64_t number = 0;
    for (const Sweep& sweep : spec_.sweeps) {
      for (const GraphsEntry& entry : sweep.graphs) {
        for (GraphFileRecord& record : records_of(entry, number)) {
          if (only_.empty() || only_ == record.name) add(sweep, entry, std::move(record));
        }
        ++number;
      }
    }
    return std::move(corpora_);
  }

 private:
  std::vector<GraphFileRecord> records_of(const GraphsEntry& entry, std::int64_t number) const {
    std::vector<GraphFileRecord> records;
    if (spec_.graph_files) {
      for (const GraphFileRecord& record : *spec_.graph_files) {
        if (record.entry == number) records.push_back(record);
      }
      if (!records.empty()) return records;
      throw InputError(fmt::format("{}the study does not say which files '{}' was", entry.place,
                                   printable(entry.file)));
    }
    for (const std::string& path : matching_files(absolute_path(spec_.folder, entry.file), entry)) {
      std::error_code ignored;
      if (fs::is_directory(path, ignored)) {
        throw InputError(
            fmt::format("{}cannot read {}: it is a directory", entry.place, printable(path)));
      }
      records.push_back({entry.name.empty() ? own_name(path) : entry.name, number, -1, {}, path});
    }
    if (!entry.name.empty() && records.size() > 1) {
      throw InputError(fmt::format("{}'{}' is one name for the {} files that '{}' matches",
                                   entry.place, entry.name, records.size(), printable(entry.file)));
    }
    return records;
  }

  void add(const Sweep& sweep, const GraphsEntry& entry, GraphFileRecord record) {
    require_name(record, entry);
    CorpusOptions options = entry.options;
    options.sample_seed = spec_.seed;
    const std::shared_ptr<const Corpus> graphs = opened(record, options, entry);
    if (!record.hash.empty() && record.hash != graphs->hash()) {
      throw InputError(fmt::format(
          "{}: its graphs are not those that the study began with ({} graphs with hash {} now, {} "
          "with {} then)",
          printable(record.path), graphs->graphs_in_file(), graphs->hash(), record.graphs,
          record.hash));
    }
    record.hash = graphs->hash();
    record.graphs = static_cast<std::int64_t>(graphs->graphs_in_file());
    require_one_of_a_kind(record, options, entry);
    corpora_.push_back({&sweep, &entry, record, named_corpus(record.name, graphs)});
  }

  std::shared_ptr<const Corpus> opened(const GraphFileRecord& record, const CorpusOptions& options,
                                       const GraphsEntry& entry) const {
    try {
      return spec_.shelf->get(record.path, options);
    } catch (const InputError& error) {
      throw InputError(entry.place + error.what());
    }
  }

  // Rows are told apart by the graphs' hash and, for people, by the name: one must give the other.
  // A sample is no part of it, so that a larger one has the rows of the smaller.
  void require_one_of_a_kind(const GraphFileRecord& record, const CorpusOptions& options,
                             const GraphsEntry& entry) {
    const auto refuse = [&](const std::string& problem) {
      throw InputError(fmt::format("{}{} {}", entry.place, printable(record.path), problem));
    };
    const GraphFileRecord& same_name = by_name_.try_emplace(record.name, record).first->second;
    if (same_name.hash != record.hash) {
      refuse(
          fmt::format("and {} would both be called {}: {{ file = …, name = … }} tells them apart",
                      printable(same_name.path), record.name));
    }
    const GraphFileRecord& same_hash = by_hash_.try_emplace(record.hash, record).first->second;
    if (same_hash.name != record.name) {
      refuse(fmt::format("holds the same graphs as {}", printable(same_hash.path)));
    }
    const std::string kind = fmt::format("{} {}", record.hash, options.largest_component);
    if (samples_.try_emplace(kind, options.sample).first->second != options.sample) {
      refuse("is taken twice, with different samples");
    }
  }

  const StudySpec& spec_;
  const std::string& only_;
  std::vector<StudyCorpus> corpora_;
  std::map<std::string, GraphFileRecord> by_name_;
  std::map<std::string, GraphFileRecord> by_hash_;
  std::map<std::string, std::uint64_t> samples_;
};

}  // namespace

std::vector<FamilyChoice> StudyCorpus::choices() const {
  std::vector<FamilyChoice> choices;
  for (const std::int64_t shuffle : entry->shuffles) {
    FamilyChoice choice{&corpus->family, {}, corpus};
    if (entry->options.largest_component) choice.parameters.push_back({"largest_component", 1});
    if (shuffle > 0) choice.parameters.push_back({"shuffle", shuffle});
    choices.push_back(std::move(choice));
  }
  return choices;
}

std::vector<StudyCorpus> corpora_of(const StudySpec& spec, const std::string& only) {
  return CorpusReader(spec, only).read();
}

Graph corpus_graph(const FamilyChoice& choice, std::uint32_t index, std::uint64_t seed) {
  Graph graph = choice.corpus->graphs->graph(index);
  const bool is_shuffled =
      std::any_of(choice.parameters.begin(), choice.parameters.end(),
                  [](const Setting& setting) { return setting.name == "shuffle"; });
  if (!is_shuffled) return graph;
  RandomStream random(seed, kShuffleStream);
  return shuffled_labels(graph, random);
}

}  // namespace ar3d
