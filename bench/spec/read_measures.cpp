#include "ar3d/bench/spec/read_measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "ar3d/base/error.h"

namespace ar3d {
namespace {

constexpr std::int64_t kMaxRepetitions = 1000000;
constexpr std::int64_t kMaxThreads = 1024;

std::uint32_t small_integer(TomlTable& table, const std::string& key, std::int64_t low,
                            std::int64_t high, std::int64_t otherwise) {
  return static_cast<std::uint32_t>(table.integer(key, low, high, otherwise));
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
  TimedRepetitions repetitions;
  repetitions.precision = table.number("precision", 1e-6, 1);
  // Fewer than six values give no interval of 95 % confidence for their median.
  repetitions.least = small_integer(table, "min", 6, kMaxRepetitions, 6);
  repetitions.most = small_integer(table, "max", repetitions.least, kMaxRepetitions,
                                   std::max<std::int64_t>(repetitions.least, 50));
  table.refuse_other_keys();
  return repetitions;
}

Batches read_batches(const std::string& file, const toml::node& node, const std::string& what,
                     const std::string& sharers) {
  TomlTable table(file, node, what);
  Batches batches;
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
  table.refuse_other_keys();
  return batches;
}

TimingRules read_timing_rules(const std::string& file, const toml::node& node) {
  TomlTable table(file, node, "timing");
  TimingRules rules;
  rules.warm_up = small_integer(table, "warm_up", 0, 1000, 1);
  rules.concurrency = small_integer(table, "concurrency", 1, kMaxThreads, 1);
  rules.write = table.boolean("write", false);
  table.refuse_other_keys();
  return rules;
}

Budget read_budget(const std::string& file, const toml::node& node) {
  TomlTable table(file, node, "budget");
  Budget budget;
  if (const toml::node* time = table.find("row_time")) {
    budget.row_time_s = toml_parsed(file, *time, "row_time", SizeFunction::time);
  }
  if (const toml::node* memory = table.find("row_memory")) {
    budget.row_memory_bytes = toml_parsed(file, *memory, "row_memory", SizeFunction::memory);
  }
  if (const toml::node* memory = table.find("certify_memory")) {
    budget.certify_memory_bytes =
        toml_parsed(file, *memory, "certify_memory", SizeFunction::memory);
  }
  if (const toml::node* study = table.find("study")) {
    budget.study_s = toml_parsed(file, *study, "study", [](const std::string& text) {
      const SizeFunction time = SizeFunction::time(text);
      if (!time.is_constant()) throw InputError("the whole study's budget cannot depend on n");
      return time(0);
    });
  }
  table.refuse_other_keys();
  return budget;
}

}  // namespace ar3d
