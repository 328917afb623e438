#pragma once

#include <map>
#include <string>
#include <vector>

#include "ar3d/analysis/compare/compare.h"

namespace ar3d {

/// Holds what the rounds of all cells of a setting tell together, by algorithm_label().
using SettingVerdicts = std::map<std::string, TimeVerdict>;

/// Gives a cell that its own rounds leave open the verdict of its setting, unless they differ from
/// the setting's estimate: by the signed-rank test, its p-value times `tests` at most the rule's
/// false_discovery_rate.
/// @param log_ratios  of the cell's rounds.
void follow_setting(const TimeVerdict& setting, std::vector<double> log_ratios,
                    const TimeRule& rule, std::size_t tests, TimeVerdict& cell);

/// Fills Comparison::settings from its cells. @param rounds  of settings in turns; of two files
/// Comparison::times says it.
void judge_settings(const SettingVerdicts& rounds, Comparison& comparison);

/// Returns "4.8 %" or "24 %" of the logarithm of a ratio.
std::string rounded_percent(double log_ratio);

}  // namespace ar3d
