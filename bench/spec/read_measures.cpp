// Reads the keys of a specification about repetitions, timing, batches and budget. Numbers of
// repetitions that could give no interval are refused here, before anything runs.
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

#include "ar3d/base/error.h"
#include "ar3d/bench/spec/read_parts.h"
#include "ar3d/bench/spec/toml_table.h"

namespace ar3d {
namespace {

constexpr std::int64_t kMaxRepetitions = 1000000;
constexpr std::int64_t kMaxThreads = 1024;

std::uint32_t small_integer(TomlTable& table, const std::string& key, std::int64_t low,
                            std::int64_t high, std::int64_t otherwise) {
  return static_cast<std::uint32_t>(table.integer(key, low, high, otherwise));
}

constexpr std::size_t kMostCombinations = 100000;

bool has_batches(const Sweep& sweep) {
  const auto has = [](const BatchRules& batches) { return !batches.scales.empty(); };
  return has(sweep.strong) || has(sweep.weak) || has(sweep.strong_ranks) || has(sweep.weak_ranks);
}

template <class Is>
bool any(const Sweep& sweep, Is is) {
  return std::any_of(sweep.algorithms.begin(), sweep.algorithms.end(), is);
}

}  // namespace

TimedRepetitions read_timed_repetitions(const std::string& file, const toml::node& node) {
  const std::string what = "timed_repetitions";
  if (!node.is_table()) {
    const auto count =
        static_cast<std::uint32_t>(toml_integer(file, node, what, 0, kMaxRepetitions));
    return {count, count, 0};
  }
  TomlTable table(file, node, what);
  table.refuse_all_but({"precision", "min", "max"});
  TimedRepetitions repetitions;
  repetitions.precision = table.number("precision", 1e-6, 1);
  // Fewer than six values give no interval of 95 % confidence for their median.
  repetitions.least = small_integer(table, "min", 6, kMaxRepetitions, 6);
  repetitions.most = small_integer(table, "max", repetitions.least, kMaxRepetitions,
                                   std::max<std::int64_t>(repetitions.least, 50));
  return repetitions;
}

BatchRules read_batches(const std::string& file, const toml::node& node, const std::string& what,
                        const std::string& sharers) {
  TomlTable table(file, node, what);
  table.refuse_all_but({sharers, "drawings", "repetitions"});
  BatchRules batches;
  const toml::node& scales = table.get(sharers);
  for (const toml::node* count : one_or_many(scales)) {
    batches.scales.push_back(
        static_cast<std::uint32_t>(toml_integer(file, *count, sharers, 1, kMaxThreads)));
  }
  const bool increasing = std::adjacent_find(batches.scales.begin(), batches.scales.end(),
                                             std::greater_equal<>()) == batches.scales.end();
  if (batches.scales.empty() || batches.scales[0] != 1 || !increasing) {
    refuse_toml(file, scales, fmt::format("{} do not begin with 1 and increase", sharers));
  }
  batches.drawings = small_integer(table, "drawings", 1, kMaxRepetitions, 1);
  batches.repetitions = small_integer(table, "repetitions", 1, kMaxRepetitions, 1);
  return batches;
}

TimingRules read_timing_rules(const std::string& file, const toml::node& node) {
  TomlTable table(file, node, "timing");
  table.refuse_all_but({"warm_up", "concurrency", "write"});
  TimingRules rules;
  rules.warm_up = small_integer(table, "warm_up", 0, 1000, 1);
  rules.concurrency = small_integer(table, "concurrency", 1, kMaxThreads, 1);
  rules.write = table.boolean("write", false);
  return rules;
}

Budget read_budget(const std::string& file, const toml::node& node) {
  constexpr double kMost = 1e18;
  TomlTable table(file, node, "budget");
  table.refuse_all_but({"study_s", "row_time_s", "row_time_s_per_vertex", "row_memory_bytes",
                        "row_memory_bytes_per_vertex", "certify_memory_bytes",
                        "certify_memory_bytes_per_vertex"});
  const auto limit = [&](const std::string& key) -> std::optional<LimitByVertices> {
    const std::string more = key + "_per_vertex";
    const bool has_key = table.find(key) != nullptr, has_more = table.find(more) != nullptr;
    if (!has_key && !has_more) return {};
    return LimitByVertices{has_key ? table.number(key, 0, kMost) : 0,
                           has_more ? table.number(more, 0, kMost) : 0};
  };
  Budget budget;
  budget.row_time_s = limit("row_time_s");
  budget.row_memory_bytes = limit("row_memory_bytes");
  budget.certify_memory_bytes = limit("certify_memory_bytes");
  if (table.find("study_s") != nullptr) budget.study_s = table.number("study_s", 0, kMost);
  return budget;
}

std::vector<Settings> combinations(const std::vector<SettingChoices>& settings) {
  std::vector<Settings> all = {{}};
  for (const SettingChoices& setting : settings) {
    std::vector<Settings> longer;
    for (const auto& prefix : all) {
      for (const std::int64_t value : setting.values) {
        longer.push_back(prefix);
        longer.back().push_back({setting.name, value});
      }
    }
    if (longer.size() > kMostCombinations) {
      throw InputError("more than 100000 combinations of settings");
    }
    all = std::move(longer);
  }
  return all;
}

void refuse_bad_batches(const std::string& file, const toml::node& node, const Sweep& sweep) {
  if (!has_batches(sweep)) return;
  if (any(sweep, [](const AlgorithmChoice& c) { return c.program != nullptr; })) {
    refuse_toml(file, node, "strong and weak batches are of the catalogue's algorithms only");
  }
  if (any(sweep, [](const AlgorithmChoice& c) { return c.level != Level::extents; })) {
    refuse_toml(file, node, "strong and weak batches are of level extents only");
  }
  const CertificateMode first = sweep.algorithms.front().certificate;
  if (any(sweep, [&](const AlgorithmChoice& c) { return c.certificate != first; })) {
    refuse_toml(file, node, "strong and weak batches are judged by one certificate");
  }
}

}  // namespace ar3d
