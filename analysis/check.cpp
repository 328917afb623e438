#include "ar3d/analysis/check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string_view>
#include <tuple>

#include "ar3d/analysis/replay.h"
#include "ar3d/analysis/text.h"
#include "ar3d/model/error.h"
#include "ar3d/records/run_columns.h"

namespace ar3d {
namespace {

constexpr std::array<char, 3> kAxis = {'x', 'y', 'z'};

/// The theorem's bound is a rounded double in the file; the verifier has decided it exactly before
/// (violation `size`), so a relative error of a few roundings must not raise an alarm here.
constexpr double kRounding = 1e-12;

using Findings = std::vector<Finding>;

void check_axis(const RunRecord& run, std::size_t row, std::size_t axis, Findings& findings) {
  const std::int64_t extent = run.extents[axis];
  const double bound = run.theorem_bound[axis];
  if (extent < 0) {
    findings.push_back({FindingKind::not_certified, row,
                        fmt::format("no extent along {} although ok", kAxis[axis])});
    return;
  }
  if (!std::isfinite(bound)) {
    findings.push_back({FindingKind::not_certified, row,
                        fmt::format("no theorem bound along {} to check against", kAxis[axis])});
  } else if (static_cast<double>(extent) > bound * (1 + kRounding)) {
    findings.push_back({FindingKind::theorem_bound, row,
                        fmt::format("extent {} along {} passes the theorem's {:.17g}", extent,
                                    kAxis[axis], bound)});
  }
  const std::int64_t instance_bound = run.instance_bound[axis];
  if (instance_bound >= 0 && extent > instance_bound) {
    findings.push_back({FindingKind::instance_bound, row,
                        fmt::format("extent {} along {} passes the instance's bound {}", extent,
                                    kAxis[axis], instance_bound)});
  }
}

/// What every ok row has, whatever its graph; a missing value is NaN.
void check_numbers(const RunRecord& run, std::size_t row, Findings& findings) {
  const bool is_timed = run.phase == RunPhase::metrics || run.phase == RunPhase::timing;
  const std::array<std::pair<const char*, double>, 2> numbers = {
      {{"log2_volume", run.log2_volume}, {"wall_s", is_timed ? run.wall_s : 0}}};
  for (const auto& [name, value] : numbers) {
    if (std::isfinite(value) && value >= 0) continue;
    findings.push_back({FindingKind::not_certified, row,
                        fmt::format("{} is not a number of at least 0 although ok", name)});
  }
}

void check_certificate(const RunRecord& run, std::size_t row, Findings& findings) {
  if (run.violations > 0) {
    findings.push_back({FindingKind::certificate, row,
                        fmt::format("{} violations: {}", run.violations, run.message)});
  } else if (run.status == RunStatus::violated) {
    findings.push_back({FindingKind::certificate, row, "violated: " + run.message});
  } else if (run.violations < 0) {
    findings.push_back({FindingKind::not_certified, row, "ok, but never certified"});
  }
}

/// What the row alone tells.
Findings row_findings(const RunRecord& run, std::size_t row) {
  Findings findings;
  switch (run.status) {
    case RunStatus::refused:
      break;
    case RunStatus::ok:
      check_certificate(run, row, findings);
      check_numbers(run, row, findings);
      for (std::size_t axis = 0; axis < 3; ++axis) check_axis(run, row, axis, findings);
      break;
    case RunStatus::violated:
      check_certificate(run, row, findings);
      break;
    default:
      findings.push_back({FindingKind::unfinished, row,
                          fmt::format("{}: {}", to_string(run.status), run.message)});
  }
  return findings;
}

/// Everything that must be equal in two drawings of the same graph with the same options.
auto drawing_columns(const RunRecord& run) {
  return std::tie(run.graph_hash, run.drawing_hash, run.n, run.m, run.extents, run.bends,
                  run.instance_bound, run.counters, run.violations);
}

/// Which graph, drawn how: rows that agree in it are repetitions.
std::string repetition_key(const RunRecord& run) {
  return fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n{}", run.algorithm, run.options, run.family,
                     run.parameters, run.requested_n, run.instance_index, run.seed);
}

/// What the repetitions of one drawing tell, row after row.
class Repetitions {
 public:
  void look_at(const RunRecord& run, std::size_t row, Findings& findings) {
    if (!measured_.insert({run.phase, run.scale, run.repetition}).second) {
      findings.push_back({FindingKind::duplicate, row, "the same measurement stands twice"});
    }
    if (run.status != RunStatus::ok) return;
    if (!first_) first_ = run;
    if (drawing_columns(run) != drawing_columns(*first_)) {
      findings.push_back({FindingKind::not_repeatable, row,
                          "another drawing than the first repetition's of the same graph"});
    }
  }

 private:
  std::optional<RunRecord> first_;  // that is ok
  std::set<std::tuple<RunPhase, std::int64_t, std::int64_t>> measured_;
};

/// What is kept of a row: hashes, so that only rows that may be wrong are read again.
struct Fingerprint {
  std::size_t key = 0;          ///< of repetition_key
  std::size_t row = 0;          ///< so that rows of one key are neighbours, in file order
  std::size_t measurement = 0;  ///< of phase, scale and repetition
  std::size_t drawing = 0;      ///< of drawing_columns; 0: the row is not ok
  auto operator<=>(const Fingerprint&) const = default;
};

Fingerprint fingerprint_of(const RunRecord& run, std::size_t row) {
  const std::hash<std::string> hash;
  Fingerprint print{hash(repetition_key(run)), row, 0, 0};
  print.measurement =
      hash(fmt::format("{} {} {}", static_cast<int>(run.phase), run.scale, run.repetition));
  if (run.status == RunStatus::ok) {
    print.drawing = hash(fmt::format("{}\n{}\n{} {} {}\n{}\n{}\n{}\n{}", run.graph_hash,
                                     run.drawing_hash, run.n, run.m, run.violations,
                                     fmt::join(run.extents, " "), fmt::join(run.bends, " "),
                                     fmt::join(run.instance_bound, " "), run.counters)) |
                    1;
  }
  return print;
}

/// Whether rows of one key may hold a measurement twice or different drawings.
bool is_suspicious(std::span<const Fingerprint> prints) {
  std::set<std::size_t> measurements, drawings;
  for (const Fingerprint& print : prints) {
    if (!measurements.insert(print.measurement).second) return true;
    if (print.drawing != 0) drawings.insert(print.drawing);
  }
  return drawings.size() > 1;
}

Findings repetition_findings(const RowView& rows, std::vector<Fingerprint> prints) {
  Findings findings;
  std::sort(prints.begin(), prints.end());
  for (auto begin = prints.begin(); begin != prints.end();) {
    const auto end = std::find_if(
        begin, prints.end(), [&](const Fingerprint& print) { return print.key != begin->key; });
    std::map<std::string, Repetitions> drawings;  // more than one if their hashes are equal
    const bool is_read = end - begin > 1 && is_suspicious({begin, end});
    for (auto at = begin; is_read && at != end; ++at) {
      const RunRecord& run = rows.read(at->row);
      drawings[repetition_key(run)].look_at(run, at->row, findings);
    }
    begin = end;
  }
  return findings;
}

void add(Findings more, Findings& findings) {
  for (Finding& finding : more) {
    finding.message = one_line(finding.message);
    findings.push_back(std::move(finding));
  }
}

/// Every row counts once: as violated if any finding of it is a violation, else as incomplete.
void count_rows(const std::vector<bool>& is_ok, CheckVerdict& verdict) {
  std::set<std::size_t> violated, touched;
  for (const Finding& finding : verdict.findings) {
    if (!finding.row) continue;
    touched.insert(*finding.row);
    if (is_violation(finding.kind)) violated.insert(*finding.row);
  }
  verdict.violated_rows = violated.size();
  verdict.incomplete_rows = touched.size() - violated.size();
  verdict.proved = static_cast<std::size_t>(std::count(is_ok.begin(), is_ok.end(), true));
  for (const std::size_t row : touched) verdict.proved -= is_ok[row] ? 1 : 0;
}

std::string describe(const Finding& finding, const RowView& rows) {
  const std::string head = is_violation(finding.kind) ? "VIOLATED" : "INCOMPLETE";
  if (!finding.row) return fmt::format("{}: {}\n", head, finding.message);
  const RunRecord& run = rows.read(*finding.row);
  return fmt::format("{} row {} ({}): {} on {}, n = {}: {}\n    {}\n", head, *finding.row,
                     to_string(finding.kind), one_line(run.algorithm), one_line(run.family), run.n,
                     finding.message, one_line(draw_command(run)));
}

}  // namespace

const char* to_string(FindingKind kind) {
  switch (kind) {
    case FindingKind::certificate:
      return "certificate";
    case FindingKind::theorem_bound:
      return "theorem bound";
    case FindingKind::instance_bound:
      return "instance bound";
    case FindingKind::not_repeatable:
      return "not repeatable";
    case FindingKind::not_certified:
      return "not certified";
    case FindingKind::unfinished:
      return "unfinished";
    case FindingKind::duplicate:
      return "duplicate";
    case FindingKind::nothing_measured:
      return "nothing measured";
    case FindingKind::missing:
      return "missing";
  }
  return "unknown";
}

bool is_violation(FindingKind kind) {
  return kind == FindingKind::certificate || kind == FindingKind::theorem_bound ||
         kind == FindingKind::instance_bound || kind == FindingKind::not_repeatable;
}

int CheckVerdict::exit_code() const {
  if (findings.empty()) return 0;
  return is_violation(findings.front().kind) ? 4 : 5;
}

const char* CheckVerdict::word() const {
  const int code = exit_code();
  return code == 0 ? "PASS" : code == 4 ? "VIOLATED" : "INCOMPLETE";
}

bool breaks_promise(const RunRecord& run) {
  const Findings findings = row_findings(run, 0);
  return std::any_of(findings.begin(), findings.end(),
                     [](const Finding& finding) { return is_violation(finding.kind); });
}

void require_one_study(const RowView& rows, const std::string& path) {
  struct Graph {
    std::size_t identity;  // hash of family, parameters, n and index
    std::uint64_t seed;
    std::size_t row;
    auto operator<=>(const Graph&) const = default;
  };
  const auto identity_of = [](const RunRecord& run) {
    return fmt::format("{}\n{}\n{}\n{}", run.family, run.parameters, run.n, run.instance_index);
  };
  std::vector<Graph> graphs;
  graphs.reserve(rows.count);
  for (std::size_t row = 0; row < rows.count; ++row) {
    const RunRecord& run = rows.read(row);
    if (run.n < 0) continue;
    graphs.push_back({std::hash<std::string>()(identity_of(run)), run.seed, row});
  }
  std::sort(graphs.begin(), graphs.end());
  for (std::size_t i = 1; i < graphs.size(); ++i) {
    const Graph &one = graphs[i - 1], &two = graphs[i];
    if (one.identity != two.identity || one.seed == two.seed) continue;
    const RunRecord run = rows.read(std::min(one.row, two.row));
    if (identity_of(run) != identity_of(rows.read(std::max(one.row, two.row)))) continue;
    throw InputError(fmt::format(
        "{}: rows {} and {} are of different studies: {}, n = {}, instance {} has two seeds", path,
        std::min(one.row, two.row), std::max(one.row, two.row), one_line(run.family), run.n,
        run.instance_index));
  }
}

RowView view_of(const Results& results) {
  return {results.runs.size(), results.planned_rows,
          [&](std::size_t row) -> const RunRecord& { return results.runs[row]; }};
}

RowView view_of(RunReader& reader) {
  const auto run = std::make_shared<RunRecord>();
  return {reader.size(), reader.identity().planned_rows,
          [&reader, run](std::size_t row) -> const RunRecord& {
            *run = reader.read(row);
            return *run;
          }};
}

CheckVerdict check(const RowView& rows) {
  CheckVerdict verdict;
  verdict.rows = rows.count;
  bool any_drawn = false;
  std::vector<bool> is_ok(rows.count);
  std::vector<Fingerprint> prints(rows.count);
  for (std::size_t row = 0; row < rows.count; ++row) {
    const RunRecord& run = rows.read(row);
    add(row_findings(run, row), verdict.findings);
    is_ok[row] = run.status == RunStatus::ok;
    any_drawn = any_drawn || is_ok[row] || run.status == RunStatus::violated;
    verdict.refused += run.status == RunStatus::refused;
    prints[row] = fingerprint_of(run, row);
  }
  add(repetition_findings(rows, std::move(prints)), verdict.findings);
  if (!any_drawn) {
    const std::string why = rows.count == 0 ? "the file has no rows" : "no row was drawn";
    verdict.findings.push_back({FindingKind::nothing_measured, {}, "nothing measured: " + why});
  }
  if (const auto missing = rows.planned - static_cast<std::int64_t>(rows.count); missing > 0) {
    verdict.findings.push_back({FindingKind::missing,
                                {},
                                fmt::format("{} of {} rows are missing", missing, rows.planned)});
  }
  std::stable_sort(verdict.findings.begin(), verdict.findings.end(),
                   [](const Finding& a, const Finding& b) {
                     return std::tuple(!is_violation(a.kind), a.row.value_or(0)) <
                            std::tuple(!is_violation(b.kind), b.row.value_or(0));
                   });
  count_rows(is_ok, verdict);
  return verdict;
}

CheckVerdict check(const Results& results) { return check(view_of(results)); }

std::string summary(const CheckVerdict& verdict, const Results& results, std::size_t max_findings) {
  return summary(verdict, view_of(results), max_findings);
}

std::string summary(const CheckVerdict& verdict, const RowView& rows, std::size_t max_findings) {
  std::string text = fmt::format("{}: {} rows, {} proved, {} violated, {} incomplete, {} refused\n",
                                 verdict.word(), verdict.rows, verdict.proved,
                                 verdict.violated_rows, verdict.incomplete_rows, verdict.refused);
  const std::size_t shown = std::min(max_findings, verdict.findings.size());
  for (std::size_t i = 0; i < shown; ++i) text += describe(verdict.findings[i], rows);
  if (shown < verdict.findings.size()) {
    text += fmt::format("… and {} more findings\n", verdict.findings.size() - shown);
  }
  return text;
}

}  // namespace ar3d
