#include "ar3d/analysis/study_analysis.h"

#include <utility>

namespace ar3d {

StudyAnalysis analyse(const RowView& rows, CheckedRows examination) {
  StudyAnalysis analysis{rows, std::move(examination.verdict), {}, {}, {}};
  analysis.tally = tally_of(rows, examination.is_last_repetition);
  analysis.bounds = bounds_table(analysis.tally, *rows.identity);
  analysis.scaling = scaling(analysis.tally);
  return analysis;
}

StudyAnalysis analyse(const RowView& rows) { return analyse(rows, examine(rows)); }

}  // namespace ar3d
