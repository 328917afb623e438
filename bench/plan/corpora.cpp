// Opens the files of a study whose graphs are instances. Each file is known by the hash of its
// graphs, so that a study that goes on never takes other graphs under an old name.
#include <fmt/format.h>

#include <filesystem>
#include <limits>
#include <set>

#include "ar3d/base/error.h"
#include "ar3d/base/printable.h"
#include "ar3d/bench/corpus/corpus.h"
#include "ar3d/bench/plan/plan.h"
#include "ar3d/bench/spec/read_parts.h"
#include "ar3d/formats/text/tokens.h"

namespace ar3d {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kMostPlaces = std::numeric_limits<std::uint32_t>::max();

std::string absolute_path(const std::string& folder, const std::string& file) {
  return fs::absolute(fs::path(folder) / file).lexically_normal().string();
}

/// The files of a study that has begun, with the graphs that its results hold; none where they hold
/// none of this family.
std::vector<CorpusFile> held_files(const Study& known, const GraphFileRecord& record) {
  std::vector<CorpusFile> files;
  if (!known.stored_graphs || !known.stored_graphs->contains(record.name)) return files;
  const std::map<std::uint32_t, std::string>& lines = known.stored_graphs->at(record.name);
  for (const CollectedFile& file : known.collected) {
    if (file.name != record.name) continue;
    if (file.first < 0 || file.graphs < 0 || file.first > kMostPlaces - file.graphs) {
      throw InputError(fmt::format("/collected_files: {} graphs from {} on are no part of {}",
                                   file.graphs, file.first, record.name));
    }
    const auto first = static_cast<std::uint32_t>(file.first);
    const auto end = static_cast<std::uint32_t>(file.first + file.graphs);
    const std::string name =
        record.groups.empty() ? fs::path(file.file).filename().string() : file.file;
    files.push_back({record.path,
                     name,
                     file.group,
                     {},
                     file.file,
                     file,
                     {lines.lower_bound(first), lines.lower_bound(end)}});
  }
  return files;
}

/// Returns which file is not the one that the study began with; empty where it is unknown.
std::string changed_file(const Study& known, const std::string& family, const Corpus& now) {
  std::set<std::pair<std::string, std::string>> there;
  for (const CollectedFile& file : now.files()) there.emplace(file.file, file.hash);
  std::string first;
  std::size_t changed = 0;
  for (const CollectedFile& file : known.collected) {
    if (file.name != family || there.contains({file.file, file.hash})) continue;
    if (changed++ == 0) first = file.file;
  }
  return changed == 0 ? ""
                      : fmt::format("; {} file{} gone or changed, {} is the first", changed,
                                    changed == 1 ? " is" : "s are", printable(first));
}

/// What a corpus is opened by: files and options.
std::string file_key(const GraphFileRecord& record, const GraphsEntry& entry, bool is_held,
                     bool rescan) {
  const ReadOptions& reading = entry.reading;
  return fmt::format("{}\n{}\n{}\n{};{};{};{};{};{};{};{};{};{};{}", record.name, record.path,
                     record.groups, reading.format, reading.base.value_or(2),
                     static_cast<int>(reading.first_line), reading.simplify, reading.undirected,
                     entry.largest_component, entry.sample, entry.sample_seed, entry.skip, is_held,
                     rescan);
}

void require_name(const GraphFileRecord& record, const GraphsEntry& entry) {
  if (!is_family(record.name) && is_graphs_name(record.name)) return;
  throw InputError(fmt::format(
      "{}'{}' {}: {{ file = …, name = … }} gives {} another one", entry.location,
      printable(record.name),
      is_family(record.name) ? "is the name of a family of the catalogue" : "is no name for graphs",
      printable(record.path)));
}

class CorpusReader {
 public:
  CorpusReader(const Study& study, const std::string& only) : study_(study), only_(only) {}

  std::vector<StudyCorpus> read() {
    std::int64_t number = 0;
    for (const Sweep& sweep : study_.spec.sweeps) {
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
    if (study_.begun_with) {
      for (const GraphFileRecord& record : *study_.begun_with) {
        if (record.entry == number) records.push_back(record);
      }
      if (!records.empty()) return records;
      throw InputError(fmt::format("{}the study does not say which files '{}' was", entry.location,
                                   printable(entry.file)));
    }
    const std::string wanted = absolute_path(study_.folder, entry.file);
    if (entry.is_collection) {
      const std::string groups =
          entry.groups.empty() ? "" : absolute_path(study_.folder, entry.groups);
      return {{entry.name, number, -1, {}, wanted, groups}};
    }
    for (const std::string& path : listed_files(study_, wanted, false)) {
      std::error_code ignored;
      if (fs::is_directory(path, ignored)) {
        throw InputError(
            fmt::format("{}cannot read {}: it is a directory; {{ files = …, name = … }} makes one "
                        "collection of it",
                        entry.location, printable(path)));
      }
      records.push_back(
          {entry.name.empty() ? own_graphs_name(path) : entry.name, number, -1, {}, path});
    }
    if (records.empty()) refuse_empty(entry);
    if (!entry.name.empty() && records.size() > 1) {
      throw InputError(
          fmt::format("{}'{}' is one name for the {} files that '{}' matches: {{ "
                      "files = …, name = … }} makes one collection of them",
                      entry.location, entry.name, records.size(), printable(entry.file)));
    }
    return records;
  }

  void add(const Sweep& sweep, const GraphsEntry& entry, GraphFileRecord record) {
    require_name(record, entry);
    const std::shared_ptr<const Corpus> graphs = opened(record, entry);
    if (!record.hash.empty() && record.hash != graphs->hash() && !is_held(record)) {
      throw InputError(fmt::format(
          "{}: its graphs are not those that the study began with ({} graphs with hash {} now, {} "
          "with {} then{})",
          printable(record.path), graphs->graphs_in_file(), graphs->hash(), record.graphs,
          record.hash, changed_file(study_, record.name, *graphs)));
    }
    record.hash = graphs->hash();
    record.graphs = static_cast<std::int64_t>(graphs->graphs_in_file());
    require_one_of_a_kind(record, entry);
    require_rows_of_one_name(*graphs, record, entry);
    corpora_.push_back({&sweep, &entry, record, graphs});
  }

  std::shared_ptr<const Corpus> opened(const GraphFileRecord& record, GraphsEntry entry) const {
    try {
      entry.sample_seed = study_.spec.seed;
      const bool rescan = study_.rescan && entry.sample == 0;  // a sample stays as it was drawn
      std::shared_ptr<const Corpus>& corpus =
          study_.open_files->corpora[file_key(record, entry, is_held(record), rescan)];
      if (corpus) return corpus;
      std::vector<CorpusFile> files = held_files(study_, record);
      if (files.empty() || rescan) {
        for (CorpusFile& file : files_now(record, entry, !files.empty())) {
          files.push_back(std::move(file));
        }
      }
      if (files.empty()) refuse_empty(entry);
      entry.rescan = rescan && files.front().held;
      return corpus = std::make_shared<const Corpus>(files, entry, record.name);
    } catch (const InputError& error) {
      const std::string message = error.what();
      throw InputError(message.starts_with(entry.location) ? message : entry.location + message);
    }
  }

  bool is_held(const GraphFileRecord& record) const {
    return study_.stored_graphs && study_.stored_graphs->contains(record.name);
  }

  /// @param may_be_gone  then there are none where the file or folder is not there any more.
  std::vector<CorpusFile> files_now(const GraphFileRecord& record, const GraphsEntry& entry,
                                    bool may_be_gone) const {
    std::error_code ignored;
    if (may_be_gone && !is_pattern(record.path) && !fs::exists(record.path, ignored)) return {};
    if (!entry.is_collection) return {{record.path, "", ""}};
    return collected_files(record, entry, study_);
  }

  // Rows are known by the graphs' hash and, for people, by the name: one must give the other.
  // A sample is no part of it, so that a larger one has the rows of the smaller.
  void require_one_of_a_kind(const GraphFileRecord& record, const GraphsEntry& entry) {
    const auto refuse = [&](const std::string& problem) {
      throw InputError(fmt::format("{}{} {}", entry.location, printable(record.path), problem));
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
    const std::string kind = fmt::format("{} {}", record.hash, entry.largest_component);
    if (samples_.try_emplace(kind, entry.sample).first->second != entry.sample) {
      refuse("is taken twice, with different samples");
    }
  }

  // The rows of a file have one family, even where a collection holds the file, too.
  void require_rows_of_one_name(const Corpus& graphs, const GraphFileRecord& record,
                                const GraphsEntry& entry) {
    for (const CollectedFile& file : graphs.files()) {
      const std::string& name = by_file_.try_emplace(file.hash, record.name).first->second;
      if (name == record.name) continue;
      throw InputError(fmt::format("{}a file of {} holds the same graphs as one of {}",
                                   entry.location, record.name, name));
    }
  }

  const Study& study_;
  const std::string& only_;
  std::vector<StudyCorpus> corpora_;
  std::map<std::string, GraphFileRecord> by_name_;
  std::map<std::string, GraphFileRecord> by_hash_;
  std::map<std::string, std::string> by_file_;  // hash of a file's graphs -> family
  std::map<std::string, std::uint64_t> samples_;
};

}  // namespace

std::vector<FamilyChoice> StudyCorpus::choices() const {
  std::vector<FamilyChoice> choices;
  for (const std::int64_t shuffle : entry->shuffles) {
    FamilyChoice choice{&corpus->family(), {}, corpus};
    if (entry->largest_component) choice.parameters.push_back({"largest_component", 1});
    if (shuffle > 0) choice.parameters.push_back({"shuffle", shuffle});
    choices.push_back(std::move(choice));
  }
  return choices;
}

std::vector<std::string> graph_files_of(const Study& study) {
  std::vector<std::string> files;
  const auto add = [&](const std::string& path, const std::string& groups, bool is_collection) {
    const std::vector<std::string>& found = listed_files(study, path, is_collection);
    files.insert(files.end(), found.begin(), found.end());
    if (!groups.empty()) files.push_back(groups);
  };
  std::vector<bool> collections;
  for (const Sweep& sweep : study.spec.sweeps) {
    for (const GraphsEntry& entry : sweep.graphs) {
      collections.push_back(entry.is_collection);
      if (study.begun_with) continue;
      add(absolute_path(study.folder, entry.file),
          entry.groups.empty() ? "" : absolute_path(study.folder, entry.groups),
          entry.is_collection);
    }
  }
  for (const GraphFileRecord& record : study.begun_with.value_or(std::vector<GraphFileRecord>())) {
    const auto number = static_cast<std::size_t>(record.entry);
    add(record.path, record.groups, number < collections.size() && collections[number]);
  }
  return files;
}

std::vector<StudyCorpus> corpora_of(const Study& study, const std::string& only) {
  return CorpusReader(study, only).read();
}

}  // namespace ar3d
