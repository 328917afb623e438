// The verdict on a study: what each row tells alone, what repetitions tell together, and what is
// missing.
#include "ar3d/analysis/check.h"

#include <fmt/format.h>

#include <tuple>

#include "ar3d/analysis/tally.h"
#include "ar3d/base/printable.h"
#include "ar3d/store/columns/run_columns.h"

namespace ar3d {

namespace {

/// The theorem's bound is a rounded double in the file; the verifier has decided it exactly before
/// (violation `size`), so a relative error of a few roundings must not raise an alarm here.
constexpr double kRounding = 1e-12;

using enum FindingKind;

template <class Add>
void check_axis(const RunRecord& run, std::size_t axis, const Add& add) {
  const std::int64_t extent = run.extents[axis], instance_bound = run.instance_bound[axis];
  const double bound = run.theorem_bound[axis];
  const char name = "xyz"[axis];
  if (extent < 0) return add(not_certified, fmt::format("no extent along {} although ok", name));
  if (!std::isfinite(bound)) {
    add(not_certified, fmt::format("no theorem bound along {} to check against", name));
  } else if (static_cast<double>(extent) > bound * (1 + kRounding)) {
    add(theorem_bound,
        fmt::format("extent {} along {} passes the theorem's {:.17g}", extent, name, bound));
  }
  if (instance_bound >= 0 && extent > instance_bound) {
    add(FindingKind::instance_bound,
        fmt::format("extent {} along {} passes the instance's bound {}", extent, name,
                    instance_bound));
  }
}

/// Lemma L.5 is right, too; rows of earlier programs have no such bound (NaN).
template <class Add>
void check_volume(const RunRecord& run, const Add& add) {
  constexpr double kRoundings = 1e-9;
  const double least = metric_of(run, "volume_at_least");
  if (!(run.log2_volume < std::log2(least) - kRoundings)) return;
  add(instance_bound, fmt::format("a volume of 2^{:.6g} is below volume_at_least, {:.17g}",
                                  run.log2_volume, least));
}

/// Adds what every ok row has, whatever its graph; a missing value is NaN.
template <class Add>
void check_numbers(const RunRecord& run, const Add& add) {
  const bool is_timed = run.phase == RunPhase::metrics || run.phase == RunPhase::timing;
  for (const auto& [name, value] : {std::pair{"log2_volume", run.log2_volume},
                                    std::pair{"wall_s", is_timed ? run.wall_s : 0}}) {
    if (std::isfinite(value) && value >= 0) continue;
    add(not_certified, fmt::format("{} is not a number of at least 0 although ok", name));
  }
}

template <class Add>
void check_certificate(const RunRecord& run, const Add& add) {
  if (run.violations > 0) {
    add(certificate, fmt::format("{} violations: {}", run.violations, run.message));
  } else if (run.status == RunStatus::violated) {
    add(certificate, "violated: " + run.message);
  } else if (run.violations < 0) {
    add(not_certified, "ok, but never certified");
  }
}

/// So many violations, and so many other findings, are kept with their message.
constexpr std::size_t kKeptFindings = 1000;

void check_whole_file(const Rows& rows, bool any_drawn, const FindingSink& add) {
  if (!any_drawn) {
    add({FindingKind::nothing_measured,
         {},
         rows.size() == 0 ? "nothing measured: the file has no rows"
                          : "nothing measured: no row was drawn"},
        nullptr);
  }
  const std::int64_t planned = rows.identity().planned_rows;
  if (const auto missing = planned - static_cast<std::int64_t>(rows.size()); missing > 0) {
    add({FindingKind::missing, {}, fmt::format("{} of {} rows are missing", missing, planned)},
        nullptr);
  }
}

std::string describe(const Finding& finding) {
  const std::string head = is_violation(finding.kind) ? "VIOLATED" : "INCOMPLETE";
  if (!finding.row) return fmt::format("{}: {}\n", head, finding.message);
  return fmt::format("{} row {} ({}): {}: {}\n    {}\n", head, *finding.row,
                     to_string(finding.kind), finding.subject, finding.message, finding.command);
}

/// What the row alone tells: certificate, numbers that every ok row has, extents against bounds.
std::vector<Finding> row_findings(const RunRecord& run, std::size_t row) {
  std::vector<Finding> findings;
  const auto add = [&](FindingKind kind, std::string message) {
    findings.push_back({kind, row, std::move(message)});
  };
  if (!run.row_key.empty() && run.row_key.find_first_not_of('0') == std::string::npos) {
    add(not_certified, "its row key is no hash of a row");
  }
  switch (run.status) {
    case RunStatus::refused:
      break;
    case RunStatus::measured:  // nothing was promised
      check_numbers(run, add);
      break;
    case RunStatus::ok:
      check_numbers(run, add);
      if (is_unproved(run)) break;
      check_certificate(run, add);
      for (std::size_t axis = 0; axis < 3; ++axis) check_axis(run, axis, add);
      check_volume(run, add);
      break;
    case RunStatus::violated:
      check_certificate(run, add);
      break;
    default:
      add(unfinished, fmt::format("{}: {}", to_string(run.status), run.message));
  }
  return findings;
}

}  // namespace

bool is_unproved(const RunRecord& run) {
  return run.status == RunStatus::ok && !run.certificate.empty();
}

const char* to_string(FindingKind kind) {
  static constexpr std::array<const char*, 9> kNames = {
      "certificate", "theorem bound", "instance bound",   "not repeatable", "not certified",
      "unfinished",  "duplicate",     "nothing measured", "missing"};
  return kNames.at(static_cast<std::size_t>(kind));
}

bool is_violation(FindingKind kind) {
  return kind == FindingKind::certificate || kind == FindingKind::theorem_bound ||
         kind == FindingKind::instance_bound || kind == FindingKind::not_repeatable;
}

int CheckVerdict::exit_code() const {
  if (violations > 0) return 4;
  return all_findings > 0 || (unproved > 0 && !accepts_unproved) ? 5 : 0;
}

const char* CheckVerdict::word() const {
  const int code = exit_code();
  const bool is_judged = proved > 0 || unproved > 0 || measured == 0;
  return code == 4 ? "VIOLATED" : code == 5 ? "INCOMPLETE" : is_judged ? "PASS" : "MEASURED";
}

bool breaks_promise(const RunRecord& run) {
  const std::vector<Finding> findings = row_findings(run, 0);
  return std::any_of(findings.begin(), findings.end(),
                     [](const Finding& finding) { return is_violation(finding.kind); });
}

CheckVerdict check(const Rows& rows, const std::string& one_study) {
  CheckVerdict verdict;
  verdict.rows = rows.size();
  const ShowCommand show(rows);
  std::vector<bool> is_ok(rows.size()), violated(rows.size()), touched(rows.size());
  std::array<std::size_t, 2> kept{};  // others, violations
  const FindingSink add = [&](Finding finding, const RunRecord* run) {
    const bool is_wrong = is_violation(finding.kind);
    verdict.violations += is_wrong;
    ++verdict.all_findings;
    if (finding.row) (is_wrong ? violated : touched)[*finding.row] = true;
    if (kept[is_wrong] == kKeptFindings && finding.row) return;
    kept[is_wrong] += finding.row.has_value();
    finding.message = one_line(finding.message);
    if (run != nullptr) {
      finding.subject = one_line(graph_label(*run));
      finding.command = one_line(show(*run, finding.row.value()));
    }
    verdict.findings.push_back(std::move(finding));
  };
  bool any_drawn = false;
  RowsTogether together(rows, one_study);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const RunRecord& run = rows.run(row);
    together.add(run);
    for (Finding& finding : row_findings(run, row)) add(std::move(finding), &run);
    is_ok[row] = run.status == RunStatus::ok && !is_unproved(run);
    verdict.unproved += is_unproved(run);
    any_drawn = any_drawn || is_drawn(run);
    verdict.refused += run.status == RunStatus::refused;
    verdict.measured += run.status == RunStatus::measured;
  }
  together.require_one_study();
  kept = {};  // of this second look at the rows as many are kept again
  verdict.is_last_repetition = together.find_in_repetitions(add);
  check_whole_file(rows, any_drawn, add);
  for (std::size_t row = 0; row < rows.size(); ++row) {  // once: violated, incomplete or proved
    verdict.violated_rows += violated[row];
    verdict.incomplete_rows += touched[row] && !violated[row];
    verdict.proved += is_ok[row] && !violated[row] && !touched[row];
  }
  std::ranges::stable_sort(verdict.findings, {}, [](const Finding& finding) {
    return std::tuple(!is_violation(finding.kind), finding.row.value_or(0));
  });
  return verdict;
}

std::string verdict_line(const CheckVerdict& verdict) {
  const std::string unproved = verdict.unproved == 0
                                   ? ""
                                   : fmt::format(", {} not proved{}", verdict.unproved,
                                                 verdict.accepts_unproved ? " (accepted)" : "");
  const std::string measured =
      verdict.measured > 0 ? fmt::format(", {} measured without a guarantee", verdict.measured)
                           : "";
  return fmt::format("{}: {} rows, {} proved, {} violated, {} incomplete, {} refused{}{}\n",
                     verdict.word(), verdict.rows, verdict.proved, verdict.violated_rows,
                     verdict.incomplete_rows, verdict.refused, unproved, measured);
}

std::string summary(const CheckVerdict& verdict, std::size_t max_findings) {
  std::string text = verdict_line(verdict);
  const std::size_t shown = std::min(max_findings, verdict.findings.size());
  for (std::size_t i = 0; i < shown; ++i) text += describe(verdict.findings[i]);
  if (shown < verdict.all_findings) {
    text += fmt::format("… and {} more findings\n", verdict.all_findings - shown);
  }
  return text;
}

}  // namespace ar3d
