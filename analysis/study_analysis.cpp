#include "ar3d/analysis/study_analysis.h"

#include <utility>

#include "ar3d/store/columns/side_tables.h"

namespace ar3d {
namespace {

void refuse_laws_above_theorems(const StudyIdentity& identity, std::vector<ScalingEntry>& scaling) {
  const std::vector<AlgorithmRecord> records = algorithm_records(identity);
  for (ScalingEntry& entry : scaling) {
    const AlgorithmRecord* record =
        find_algorithm_record(records, entry.key.algorithm, entry.key.options);
    if (record == nullptr) continue;
    if (const auto order = theorem_order(record->theorem, entry.quantity)) {
      refuse_law_above(*order, entry);
    }
  }
}

}  // namespace

StudyAnalysis analyse(const RowView& rows, CheckedRows examination) {
  StudyAnalysis analysis{rows, std::move(examination.verdict), {}, {}, {}};
  analysis.tally = tally_of(rows, examination.is_last_repetition);
  analysis.bounds = bounds_table(analysis.tally, *rows.identity);
  analysis.scaling = scaling(analysis.tally);
  refuse_laws_above_theorems(*rows.identity, analysis.scaling);
  return analysis;
}

StudyAnalysis analyse(const RowView& rows) { return analyse(rows, examine(rows)); }

}  // namespace ar3d
