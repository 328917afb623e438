#include "ar3d/analysis/check/row_findings.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

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

}  // namespace

bool is_unproved(const RunRecord& run) {
  return run.status == RunStatus::ok && !run.certificate.empty();
}

std::vector<Finding> row_findings(const RunRecord& run, std::size_t row) {
  Findings findings;
  switch (run.status) {
    case RunStatus::refused:
      break;
    case RunStatus::measured:  // nothing was promised
      check_numbers(run, row, findings);
      break;
    case RunStatus::ok:
      check_numbers(run, row, findings);
      if (is_unproved(run)) break;
      check_certificate(run, row, findings);
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

}  // namespace ar3d
