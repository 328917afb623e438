#pragma once

#include <compare>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "ar3d/store/rows.h"

namespace ar3d {

enum class FindingKind {
  certificate,       ///< the drawing was proved wrong
  theorem_bound,     ///< an extent passes the theorem's bound
  instance_bound,    ///< an extent passes the proof's bound for this very instance, or the
                     ///< volume lies below the least one
  not_repeatable,    ///< two repetitions of one instance gave different drawings
  not_certified,     ///< an ok row without a certificate, extents or a bound to check against
  unfinished,        ///< timeout, out of memory or crash
  duplicate,         ///< the same measurement stands in the file twice
  nothing_measured,  ///< no row was drawn at all
  missing            ///< rows that the study is not complete without are not in the file
};
/// Returns "certificate", "theorem bound", …
const char* to_string(FindingKind kind);
/// Returns true for what is proved wrong (exit code 4), false for what is missing (exit code 5).
bool is_violation(FindingKind kind);

struct Finding {
  FindingKind kind{};
  std::optional<std::size_t> row;  ///< none if it concerns the whole file
  std::string message;             ///< one line, without control characters
  std::string subject = {};        ///< graph_label; empty without a row
  std::string command = {};        ///< the line that draws the row again; empty without a row
};

/// Describes the verdict on the rows of a study: `study status`, `study resume`, `check` and
/// `report` all say this and exit with its code. Refused rows (a graph outside the theorem's
/// promise) are counted and do no harm, but a file in which nothing was drawn never passes. Of
/// measured rows nothing was asked but to be drawn.
struct CheckVerdict {
  std::size_t rows = 0;
  std::size_t proved = 0;    ///< ok rows whose certificate and bounds hold
  std::size_t measured = 0;  ///< rows of programs without a guarantee: drawn, not judged
  std::size_t refused = 0;
  std::size_t unproved = 0;       ///< not violated, but judged by another certificate than exact
  bool accepts_unproved = false;  ///< the caller asked that these do no harm
  std::size_t violated_rows = 0;
  std::size_t incomplete_rows = 0;
  std::size_t violations = 0;     ///< findings that prove something wrong
  std::size_t all_findings = 0;   ///< the others, too
  std::vector<Finding> findings;  ///< violations first, then in file order; at most 1000 of both
  /// Says whether a row is the last one of its graph, algorithm and options.
  std::vector<bool> is_last_repetition;

  /// Returns the exit code: 0 pass; 4 a bound or certificate is violated; 5 incomplete, nothing
  /// measured, or rows that nothing proves.
  int exit_code() const;
  /// Returns "PASS", "VIOLATED", "INCOMPLETE"; or "MEASURED": nothing was asked of any row but to
  /// be drawn.
  const char* word() const;
};

/// Looks at every row, once and in file order, and again at those whose repetitions differ. Cost:
/// O(r log r) time for r rows, 33 bytes per row.
/// @param one_study  given: a path, for messages. The rows have to be of one study.
/// @throws InputError as RowsTogether.
CheckVerdict check(const Rows& rows, const std::string& one_study = "");

/// Returns which graph, drawn how: rows that agree in it are repetitions.
std::string repetition_key(const RunRecord& run);

/// Takes a finding and its row; null if it concerns the whole file.
using FindingSink = std::function<void(Finding, const RunRecord*)>;

/// Finds what rows tell together. It holds their keys and hashes, so that only rows that may be
/// wrong are read again. Memory: 32 bytes per row; of one study 24 more, and 24 per graph.
class RowsTogether {
 public:
  /// @param rows  outlive it. @param one_study  as of check.
  RowsTogether(const Rows& rows, const std::string& one_study);
  ~RowsTogether();
  /// Takes the next row. @throws InputError if they are of one study and its key is none.
  void add(const RunRecord& run);
  /// Requires, after the last row, that those of one study can be that: graphs of one family,
  /// parameters, n and index have one seed, keys are unique and not zero, and there are no more rows
  /// than planned. @throws InputError naming `one_study` and the rows.
  void require_one_study();
  /// Finds measurements that stand twice and repetitions that differ. @return whether a row is the
  /// last one of its graph, algorithm and options.
  std::vector<bool> find_in_repetitions(const FindingSink& found);

 private:
  struct Fingerprint;
  using Repetitions = std::span<const Fingerprint>;  // of one key

  static bool is_suspicious(const Repetitions& rows);
  void compare(const Repetitions& rows, const FindingSink& found) const;

  const Rows& rows_;
  const std::string one_study_;
  std::vector<Fingerprint> prints_;
  std::vector<std::pair<RowKey, std::size_t>> keys_;
  std::vector<std::tuple<std::size_t, std::uint64_t, std::size_t>> graphs_;  // hash, seed and row
};

/// Returns true if the row alone shows a broken bound or certificate.
bool breaks_promise(const RunRecord& run);

/// Returns "PASS: 60 rows, 60 proved, 0 violated, 0 incomplete, 0 refused".
std::string verdict_line(const CheckVerdict& verdict);

/// Returns a short text for a terminal: the verdict's line and the first `max_findings` findings,
/// each with the command that shows it again.
std::string summary(const CheckVerdict& verdict, std::size_t max_findings = 20);

/// Returns true if the row's drawing was judged by another certificate than exact and is not
/// violated: nothing proves it.
bool is_unproved(const RunRecord& run);

}  // namespace ar3d
