#include "study_rows.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/bench/keep/journaled_study.h"
#include "ar3d/bench/keep/study_files.h"
#include "ar3d/store/columns/run_columns.h"
#include "ar3d/store/row_collection.h"

namespace ar3d {
namespace {

// Rows that the study is complete with. Of one that times drawings until a precision is reached
// nobody knows before how many it will have: those that are there are looked at.
std::int64_t planned_rows(const std::string& file, const StudyIdentity& identity) {
  const JournaledStudy study = begun_study(file);
  const bool is_open =
      std::any_of(study.spec.sweeps.begin(), study.spec.sweeps.end(),
                  [](const Sweep& sweep) { return sweep.timed.least < sweep.timed.most; });
  if (!is_open) return identity.planned_rows;
  const StudyOutcome outcome = outcome_so_far(study);
  return static_cast<std::int64_t>(outcome.rows + outcome.missing);
}

}  // namespace

struct StudyRows::Journals {
  RowCollection rows{run_format()};
  std::vector<AlgorithmRecord> algorithms;
  std::vector<char> record = std::vector<char>(run_record_size());
  RunRecord run;
};

StudyRows::StudyRows(const std::string& file) {
  const std::string results = results_path_of(file);
  if (rows_are_in_results(results)) {
    view_results(results);
    return;
  }
  try {
    view_journals(file, results);
  } catch (const InputError&) {  // a study that ends takes its journals away
    if (!rows_are_in_results(results)) throw;
    view_results(results);
  }
}

StudyRows::~StudyRows() = default;

void StudyRows::view_results(const std::string& results) {
  reader_ = std::make_unique<RunReader>(results);
  view_ = view_of(*reader_);
}

void StudyRows::view_journals(const std::string& file, const std::string& results) {
  journals_ = std::make_unique<Journals>();
  for (const std::string& journal : existing_journals(results)) journals_->rows.add(journal);
  journals_->rows.close();
  const StudyIdentity& identity = journals_->rows.identity();
  journals_->algorithms = algorithm_records(identity);
  view_.identity = &identity;
  view_.environment = &journals_->rows.environment();
  view_.count = journals_->rows.size();
  view_.planned = planned_rows(file, identity);
  view_.read = [journals = journals_.get()](std::size_t row) -> const RunRecord& {
    journals->rows.read(row, journals->record.data());
    journals->run = load_record(journals->record.data());
    RunRecord& run = journals->run;
    set_bounds(find_algorithm_record(journals->algorithms, run.algorithm, run.options), run);
    return journals->run;
  };
}

namespace {

// What the study itself asks for; a specification that cannot be read any more asks for nothing.
bool accepts_unproved(const StudyIdentity& identity, const std::string& file) {
  try {
    return parse_study(identity.spec, file).accept_unproved;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

CheckedRows judge(const RowView& rows, const std::string& file) {
  require_one_study(rows, file);
  CheckedRows examination = examine(rows);
  if (examination.verdict.unproved > 0 && rows.identity != nullptr) {
    examination.verdict.accepts_unproved = accepts_unproved(*rows.identity, file);
  }
  return examination;
}

}  // namespace ar3d
