// Collects what a results file says besides its rows. The hash of every foreign program is
// recorded, since rows of a changed program must not stand beside those of the old one.
#include "ar3d/bench/run/describe_study.h"

#include <fmt/chrono.h>

#include <chrono>
#include <ctime>

#include "ar3d/base/printable.h"
#include "ar3d/bench/measure/environment.h"
#include "ar3d/bench/plan/corpora.h"
#include "ar3d/bench/plan/plan.h"

namespace ar3d {
namespace {

std::vector<AlgorithmRecord> algorithms_of(const StudySpec& spec) {
  std::map<std::pair<std::string, std::string>, AlgorithmRecord> records;
  for (const Sweep& sweep : spec.sweeps) {
    for (const AlgorithmChoice& choice : sweep.algorithms) {
      if (choice.program && !choice.program->has_guarantee) continue;
      const AlgorithmRecord record = algorithm_record(choice);
      records.try_emplace({record.algorithm, record.options}, record);
    }
  }
  std::vector<AlgorithmRecord> in_order;
  for (auto& [key, record] : records) in_order.push_back(std::move(record));
  return in_order;
}

/// In /environments, so that every session has its own.
EnvironmentEntry program_entry(const ExternalAlgorithm& program) {
  return {"program_" + program.row.name, program_hash(program)};
}

}  // namespace

std::string now_with_zone() {
  using namespace std::chrono;
  const auto now = system_clock::now().time_since_epoch();
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

Results describe_study(const StudySpec& spec, int workers) {
  Results results;
  results.study_id = spec.name;
  results.spec = spec.text;
  results.spec_hash = content_hash(spec.text);
  results.source_hash = source_hash();
  results.dirty = source_is_dirty();
  results.dirty_hash = dirty_hash();
  results.created = now_with_zone();
  results.tables = {algorithm_table(algorithms_of(spec))};
  std::vector<GraphFileRecord> files;
  std::vector<SkippedFile> skipped;
  for (const StudyCorpus& corpus : corpora_of(spec)) {
    files.push_back(corpus.record);
    for (SkippedFile file : corpus.corpus->graphs->skipped()) {
      file.name = corpus.record.name;
      skipped.push_back(std::move(file));
    }
  }
  if (!files.empty()) results.tables.push_back(graph_file_table(files));
  if (!skipped.empty()) results.tables.push_back(skipped_file_table(skipped));
  results.environment = capture_environment(workers);
  for (const std::shared_ptr<const ExternalAlgorithm>& program : spec.programs) {
    results.environment.push_back(program_entry(*program));
    if (results.environment.back().value != kAbsentProgram) {
      const std::string version = program_version(*program);
      if (!version.empty())
        results.environment.push_back({"version_" + program->row.name, version});
      continue;
    }
    throw InputError(fmt::format(
        "program '{}' cannot be run: {} is no file that can be read{}", program->row.name,
        printable(program->command.front()),
        program->command.front().find('/') == std::string::npos ? " in any folder of $PATH" : ""));
  }
  return results;
}

}  // namespace ar3d
