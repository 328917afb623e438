// Collects what a results file says besides its rows. The hash of every foreign program is
// recorded, since rows of a changed program must not stand beside those of the old one.
#include <fmt/chrono.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <set>

#include "ar3d/base/printable.h"
#include "ar3d/bench/corpus/corpus.h"
#include "ar3d/bench/measure/environment.h"
#include "ar3d/bench/plan/plan.h"
#include "ar3d/bench/run/session.h"
#include "ar3d/formats/graphs/graph6.h"

namespace ar3d {
namespace {

std::vector<AlgorithmRecord> algorithms_of(const StudySpec& spec) {
  std::map<std::pair<std::string, std::string>, AlgorithmRecord> records;
  for (const Sweep& sweep : spec.sweeps) {
    for (const AlgorithmChoice& choice : sweep.algorithms) {
      if (!choice.is_judged()) continue;
      const Guarantee& guarantee = choice.algorithm->guarantee;
      AlgorithmRecord record{choice.algorithm->name,
                             settings_text(choice.options),
                             guarantee.bound,
                             {},
                             guarantee.max_bends};
      if (!guarantee.published.empty()) record.published = guarantee.published.front();
      records.try_emplace({record.algorithm, record.options}, record);
    }
  }
  std::vector<AlgorithmRecord> in_order;
  for (auto& [key, record] : records) in_order.push_back(std::move(record));
  return in_order;
}

constexpr std::size_t kBytesOfALine = 100;  // of memory, beside the text

/// The graphs of files, as far as the study wants them in its results: of each file or collection
/// all or none.
StoredGraphs graphs_to_hold(const StudySpec& spec, const std::vector<StudyCorpus>& corpora) {
  StoredGraphs held;
  double bytes = 0;
  for (const StudyCorpus& corpus : corpora) {
    const Corpus& graphs = *corpus.corpus;
    std::map<std::uint32_t, std::string> lines;
    double own = 0;
    for (std::size_t i = 0; i < graphs.size() && bytes + own <= spec.graphs_bytes; ++i) {
      std::string& line = lines[graphs.index(i)];
      append_sparse6(line, graphs.graph(graphs.index(i)));
      line.pop_back();
      own += static_cast<double>(line.size() + kBytesOfALine);
    }
    if (bytes + own > spec.graphs_bytes || held.contains(corpus.record.name)) continue;
    bytes += own;
    held.emplace(corpus.record.name, std::move(lines));
  }
  return held;
}

/// In /environments, so that every session has its own.
EnvironmentEntry program_entry(const ExternalAlgorithm& program) {
  return {"program_" + program.row.name, program_hash(program)};
}

}  // namespace

std::string time_with_zone(std::chrono::system_clock::time_point time) {
  using namespace std::chrono;
  const auto now = time.time_since_epoch();
  const auto seconds = duration_cast<std::chrono::seconds>(now);
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:06}+00:00",
                     fmt::gmtime(static_cast<std::time_t>(seconds.count())),
                     duration_cast<microseconds>(now - seconds).count());
}

void refuse_changed_programs(const StudySpec& spec, const std::vector<EnvironmentEntry>& before,
                             const std::string& results) {
  for (const std::shared_ptr<const ExternalAlgorithm>& program : spec.programs) {
    const EnvironmentEntry now = program_entry(*program);
    for (const EnvironmentEntry& entry : before) {
      if (entry.name != now.name || entry.value == now.value) continue;
      throw InputError(
          fmt::format("program '{}' is not the one that rows of {} were made with (hash {}, was "
                      "{}): put the former one back, or begin anew with `ar3d study run --force`",
                      program->row.name, results, now.value, printable(entry.value)));
    }
  }
}

void require_programs(const StudySpec& spec) {
  for (const std::shared_ptr<const ExternalAlgorithm>& program : spec.programs) {
    if (program_hash(*program) != kAbsentProgram) continue;
    const std::string& command = program->command.front();
    std::string where = command.find('/') == std::string::npos ? " in any folder of $PATH" : "";
    if (const std::size_t blank = command.find(' '); blank != std::string::npos) {
      where += fmt::format("; words are a list: command = [\"{}\", …]",
                           printable(command.substr(0, blank)));
    }
    throw InputError(fmt::format("program '{}' cannot be run: {} is no file that can be read{}",
                                 program->row.name, printable(command), where));
  }
}

/// What was assumed where a file left a choice, the first notes of it.
std::string notes_text(const std::vector<StudyCorpus>& corpora) {
  constexpr std::size_t kMost = 20;
  std::vector<std::string> notes;
  std::set<const Corpus*> seen;
  for (const StudyCorpus& corpus : corpora) {
    const Corpus* const graphs = corpus.corpus.get();
    if (!seen.insert(graphs).second) continue;
    for (const std::string& note : graphs->notes()) notes.push_back(printable(note));
  }
  const std::size_t more = notes.size() > kMost ? notes.size() - kMost : 0;
  notes.resize(notes.size() - more);
  if (more > 0) notes.push_back(fmt::format("and {} more", more));
  return fmt::format("{}", fmt::join(notes, "; "));
}

std::vector<StoredTable> side_tables_of(const Study& study) {
  const std::vector<StudyCorpus> corpora = corpora_of(study);
  std::vector<StoredTable> tables = {side_table<AlgorithmRecord>(algorithms_of(study.spec))};
  std::vector<GraphFileRecord> files;
  std::vector<SkippedFile> skipped;
  std::vector<CollectedFile> collected;
  std::set<std::string> known;
  for (const StudyCorpus& corpus : corpora) {
    files.push_back(corpus.record);
    if (!known.insert(corpus.record.name).second) continue;  // the same in another sweep
    for (CollectedFile file : corpus.corpus->files()) {
      file.name = corpus.record.name;
      collected.push_back(std::move(file));
    }
    for (SkippedFile file : corpus.corpus->skipped()) {
      file.name = corpus.record.name;
      skipped.push_back(std::move(file));
    }
  }
  for (const SkippedFile& before : study.skipped) {  // of a study that has begun
    const auto is_it = [&](const auto& file) {
      return file.name == before.name && file.file == before.file;
    };
    const bool is_told =
        std::ranges::any_of(skipped, is_it) || std::ranges::any_of(collected, is_it);
    if (!is_told) skipped.push_back(before);
  }
  if (!files.empty()) {
    tables.push_back(side_table<GraphFileRecord>(files));
    tables.push_back(side_table<CollectedFile>(collected));
    tables.push_back(graphs_table(graphs_to_hold(study.spec, corpora)));
  }
  if (!skipped.empty()) tables.push_back(side_table<SkippedFile>(skipped));
  return tables;
}

Results describe_study(const Study& study, int workers) {
  const StudySpec& spec = study.spec;
  Results results;
  results.study_id = spec.name;
  results.spec = spec.text;
  results.spec_hash = content_hash(spec.text);
  results.source_hash = source_hash();
  results.dirty = source_is_dirty();
  results.dirty_hash = dirty_hash();
  results.created = time_with_zone();
  results.tables = side_tables_of(study);
  require_programs(spec);
  results.environment = capture_environment(workers);
  if (const auto listed = study.open_files->listed) {
    results.environment.push_back({"files_listed", time_with_zone(*listed)});
  }
  const std::string notes = notes_text(corpora_of(study));
  if (!notes.empty()) results.environment.push_back({"reading_notes", notes});
  for (const std::shared_ptr<const ExternalAlgorithm>& program : spec.programs) {
    results.environment.push_back(program_entry(*program));
    const std::string version = program_version(*program);
    if (!version.empty()) results.environment.push_back({"version_" + program->row.name, version});
  }
  return results;
}

}  // namespace ar3d
