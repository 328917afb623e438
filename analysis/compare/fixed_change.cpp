#include "ar3d/analysis/compare/fixed_change.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>

#include "ar3d/analysis/check/row_findings.h"

namespace ar3d {
namespace {

using Wide = boost::multiprecision::uint256_t;  // holds every product of three 64-bit numbers

/// Lattice points of the box.
Wide volume(const RunRecord& run) {
  Wide points = 1;
  for (const std::int64_t extent : run.extents) points *= Wide(extent) + 1;
  return points;
}

bool has_extents(const RunRecord& run) {
  return std::all_of(run.extents.begin(), run.extents.end(), [](auto e) { return e >= 0; });
}

bool has_bends(const RunRecord& run) {
  return std::all_of(run.bends.begin(), run.bends.end(), [](auto b) { return b >= 0; });
}

std::string box(const RunRecord& run) {
  return fmt::format("{} x {} x {}", run.extents[0], run.extents[1], run.extents[2]);
}

/// Total number of bends; edges with 7 or more count 7.
Wide total_bends(const RunRecord& run) {
  Wide total = 0;
  for (std::size_t b = 0; b < run.bends.size(); ++b) total += Wide(run.bends[b]) * b;
  return total;
}

std::size_t most_bends(const RunRecord& run) {
  std::size_t most = 0;
  for (std::size_t b = 0; b < run.bends.size(); ++b) {
    if (run.bends[b] > 0) most = b;
  }
  return most;
}

Effect direction(bool worse) { return worse ? Effect::worse : Effect::better; }

/// Judged right is more than drawn, and drawn more than not.
int rank_of(RunStatus status) {
  return status == RunStatus::ok ? 2 : status == RunStatus::measured ? 1 : 0;
}

void compare_status(const RunRecord& base, const RunRecord& now,
                    std::vector<FixedChange>& changes) {
  const bool violated = now.status == RunStatus::violated || now.violations > 0;
  if (violated) {
    changes.push_back({Effect::violated, fmt::format("violated: {}", now.message)});
  } else if (base.status != now.status) {
    const int before = rank_of(base.status), after = rank_of(now.status);
    const Effect effect = before == after ? Effect::other : direction(after < before);
    changes.push_back({effect, fmt::format("status {} became {}", to_string(base.status),
                                           to_string(now.status))});
  } else if (base.violations >= 0 && now.violations < 0 && now.status == RunStatus::ok) {
    changes.push_back({Effect::worse, "no longer certified"});
  } else if (is_unproved(base) != is_unproved(now)) {
    changes.push_back(
        is_unproved(now)
            ? FixedChange{Effect::worse,
                          fmt::format("no longer proved (certificate {})", now.certificate)}
            : FixedChange{Effect::better, "proved now"});
  }
}

void compare_volume(const RunRecord& base, const RunRecord& now,
                    std::vector<FixedChange>& changes) {
  if (!has_extents(base) || !has_extents(now) || base.extents == now.extents) return;
  const Wide before = volume(base), after = volume(now);
  const std::string boxes = fmt::format("box {} became {}", box(base), box(now));
  if (before == after) {
    changes.push_back({Effect::other, boxes});
  } else {
    changes.push_back({direction(after > before),
                       fmt::format("{} volume: {}", after > before ? "larger" : "smaller", boxes)});
  }
}

void compare_bends(const RunRecord& base, const RunRecord& now, std::vector<FixedChange>& changes) {
  if (!has_bends(base) || !has_bends(now) || base.bends == now.bends) return;
  const std::size_t most_before = most_bends(base), most_after = most_bends(now);
  if (most_before != most_after) {
    changes.push_back(
        {direction(most_after > most_before),
         fmt::format("most bends of an edge: {} became {}", most_before, most_after)});
    return;
  }
  const Wide before = total_bends(base), after = total_bends(now);
  changes.push_back({before == after ? Effect::other : direction(after > before),
                     fmt::format("bends in all: {:.0f} became {:.0f}", before.convert_to<double>(),
                                 after.convert_to<double>())});
}

}  // namespace

std::vector<FixedChange> fixed_changes(const PairedRow& row) {
  const RunRecord& base = *row.base;
  const RunRecord& now = *row.now;
  std::vector<FixedChange> changes;
  compare_status(base, now, changes);
  if (!base.graph_hash.empty() && !now.graph_hash.empty() && base.graph_hash != now.graph_hash) {
    changes.push_back({Effect::worse, "the same family, n and seed give another graph"});
    return changes;
  }
  compare_volume(base, now, changes);
  compare_bends(base, now, changes);
  const bool drawn = !base.drawing_hash.empty() && !now.drawing_hash.empty();
  if (changes.empty() && drawn && base.drawing_hash != now.drawing_hash) {
    changes.push_back({Effect::other, "another drawing of the same volume and bends"});
  }
  return changes;
}

double log2_volume_change(const PairedRow& row) {
  if (!has_extents(*row.base) || !has_extents(*row.now)) return 0;
  double change = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    change += std::log2((static_cast<double>(row.now->extents[axis]) + 1) /
                        (static_cast<double>(row.base->extents[axis]) + 1));
  }
  return change;
}

std::vector<FixedChange> instruction_change(const PairedCell& cell, double threshold) {
  double before = 0, after = 0;
  for (const PairedRow& row : cell.rows) {
    if (row.base->counted_instructions < 0 || row.now->counted_instructions < 0) continue;
    before += static_cast<double>(row.base->counted_instructions);
    after += static_cast<double>(row.now->counted_instructions);
  }
  if (before <= 0 || after <= 0) return {};
  const double ratio = after / before;
  if (ratio <= 1 + threshold && ratio >= 1 / (1 + threshold)) return {};
  return {{direction(ratio > 1), fmt::format("instructions x{:.4f}", ratio)}};
}

}  // namespace ar3d
