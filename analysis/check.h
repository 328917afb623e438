#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/records/run_storage.h"

namespace ar3d {

enum class FindingKind {
  certificate,       ///< the drawing was proved wrong
  theorem_bound,     ///< an extent passes the theorem's bound
  instance_bound,    ///< an extent passes the proof's bound for this very instance
  not_repeatable,    ///< two repetitions of one instance gave different drawings
  not_certified,     ///< an ok row without a certificate, extents or a bound to check against
  unfinished,        ///< timeout, out of memory or crash
  duplicate,         ///< the same measurement stands in the file twice
  nothing_measured,  ///< no row was drawn at all
  missing            ///< rows that the study is not complete without are not in the file
};
/// "certificate", "theorem bound", …
const char* to_string(FindingKind kind);
/// True for what is proved wrong (exit code 4), false for what is missing (exit code 5).
bool is_violation(FindingKind kind);

struct Finding {
  FindingKind kind{};
  std::optional<std::size_t> row;  ///< index in Results::runs; none if it concerns the whole file
  std::string message;             ///< one line, without control characters
};

/// The verdict on a results file. Refused rows (a graph outside the theorem's promise) are counted
/// and do no harm, but a file in which nothing was drawn never passes.
struct CheckVerdict {
  std::size_t rows = 0;
  std::size_t proved = 0;  ///< ok rows whose certificate and bounds hold
  std::size_t refused = 0;
  std::size_t violated_rows = 0;
  std::size_t incomplete_rows = 0;
  std::vector<Finding> findings;  ///< violations first, then in file order

  /// 0 pass; 4 a bound or certificate is violated; 5 incomplete or nothing measured.
  int exit_code() const;
  /// "PASS", "VIOLATED" or "INCOMPLETE".
  const char* word() const;
};

/// Rows that are looked at one at a time.
struct RowView {
  std::size_t count = 0;
  std::int64_t planned = -1;                              ///< StudyIdentity::planned_rows
  std::function<const RunRecord&(std::size_t row)> read;  ///< valid until the next call
};
RowView view_of(const Results& results);
/// Rows that stay in their file. The reader outlives the view. @throws InputError when reading.
RowView view_of(RunReader& reader);

/// Looks at every row, once and in file order, and again at those whose repetitions differ. Cost:
/// O(r log r) time for r rows, 32 bytes a row and what the findings take.
CheckVerdict check(const RowView& rows);
CheckVerdict check(const Results& results);

/// Refuses rows that cannot be of one study: its graphs of one family, parameters, n and index have
/// one seed. @throws InputError naming `path` and the two rows. Memory: 24 bytes a row.
void require_one_study(const RowView& rows, const std::string& path);

/// True if the row alone shows a broken bound or certificate.
bool breaks_promise(const RunRecord& run);

/// A short text for a terminal: the verdict, the counts, and the first `max_findings` findings,
/// each with the command that shows it again.
std::string summary(const CheckVerdict& verdict, const RowView& rows,
                    std::size_t max_findings = 20);
std::string summary(const CheckVerdict& verdict, const Results& results,
                    std::size_t max_findings = 20);

}  // namespace ar3d
