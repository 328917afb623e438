// Tells whether two results come from alike machines and builds. A setting that differs from
// session to session by its nature, such as the load, counts as a change only if it disturbs times.
#include <charconv>
#include <set>

#include "ar3d/analysis/compare/compare.h"

namespace ar3d {
namespace {

constexpr const char* kAbsent = "absent";

/// Differs from session to session on one machine, or is the change that is to be judged.
bool is_passing(const std::string& name) {
  return name == "started" || name == "files_listed" || name.starts_with("timing_") ||
         name == "version" || name == "source_hash" || name == "dirty_hash" ||
         name.starts_with("load_") || name.starts_with("program_") || name.starts_with("version_");
}

double leading_number(const std::string& text) {
  double number = 0;  // stays 0 where there is none
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

std::string busy(const Results& results) {
  double own = 1;
  for (const RunRecord& run : results.runs) {
    own = std::max(own, static_cast<double>(run.concurrency));
  }
  return load_of_other_work(results.environment, own);
}

}  // namespace

std::map<std::string, std::string> lasting_settings(
    const std::vector<EnvironmentEntry>& environment) {
  std::map<std::string, std::set<std::string>> values;
  for (const EnvironmentEntry& entry : environment) {
    if (is_passing(entry.name)) continue;
    values[entry.name].insert(entry.value);
  }
  std::map<std::string, std::string> joined;
  for (const auto& [name, of_name] : values) {
    for (const std::string& value : of_name) {
      joined[name] += (joined[name].empty() ? "" : " | ") + value;
    }
  }
  return joined;
}

std::string load_of_other_work(const std::vector<EnvironmentEntry>& environment,
                               double rows_at_a_time) {
  double cores = 1;
  for (const EnvironmentEntry& entry : environment) {
    if (entry.name == "cores") cores = std::max(cores, leading_number(entry.value));
  }
  for (const EnvironmentEntry& entry : environment) {
    const double load = leading_number(entry.value);
    if (entry.name == "load_before" && load > cores / 2) return entry.value;
    if (entry.name == "load_after" && load > rows_at_a_time + cores / 2) return entry.value;
  }
  return "";
}

std::vector<EnvironmentChange> environment_changes(const Results& base, const Results& now) {
  std::map<std::string, EnvironmentChange> settings;
  for (const auto& [name, value] : lasting_settings(base.environment)) {
    settings[name] = {name, value, kAbsent};
  }
  for (const auto& [name, value] : lasting_settings(now.environment)) {
    settings.try_emplace(name, EnvironmentChange{name, kAbsent, ""}).first->second.now = value;
  }
  std::vector<EnvironmentChange> changes;
  for (const auto& [name, change] : settings) {
    if (change.differs()) changes.push_back(change);
  }
  const std::string busy_before = busy(base), busy_after = busy(now);
  if (!busy_before.empty() || !busy_after.empty()) {
    const auto text = [](const std::string& load) { return load.empty() ? "idle" : load; };
    changes.push_back({kLoadOfOtherWork, text(busy_before), text(busy_after)});
  }
  return changes;
}

}  // namespace ar3d
