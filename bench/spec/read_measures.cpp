// Reads the keys of a specification about repetitions, timing, batches and budget. Numbers of
// repetitions that could give no interval are refused here, before anything runs.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "ar3d/base/error.h"
#include "ar3d/bench/spec/read_parts.h"
#include "ar3d/bench/spec/toml_table.h"

namespace ar3d {
namespace {

constexpr std::int64_t kMaxRepetitions = 1000000;
constexpr std::int64_t kMaxThreads = 1024;

constexpr std::size_t kMostCombinations = 100000;

template <class Is>
bool any(const Sweep& sweep, Is is) {
  return std::any_of(sweep.algorithms.begin(), sweep.algorithms.end(), is);
}

}  // namespace

void read_timed_repetitions(const toml::node& node, Sweep& sweep) {
  const std::string what = "timed_repetitions";
  if (!node.is_table()) {
    into(sweep.most_timed, 0, kMaxRepetitions)(node, what);
    sweep.least_timed = sweep.most_timed;
    return;
  }
  sweep.least_timed = 6;  // fewer values give no interval of 95 % confidence for their median
  read_toml_table(node, what,
                  {{"precision", number_into(sweep.timed_precision, 1e-6, 1), true},
                   {"min", into(sweep.least_timed, 6, kMaxRepetitions)},
                   {"max", [&](const toml::node& most, const std::string& key) {
                      into(sweep.most_timed, sweep.least_timed, kMaxRepetitions)(most, key);
                    }}});
  if (!has_toml_key(node, "max")) sweep.most_timed = std::max(sweep.least_timed, 50u);
}

BatchRules read_batches(const toml::node& node, const std::string& what,
                        const std::string& workers) {
  BatchRules batches;
  const auto read_workers = [&](const toml::node& workers, const std::string& key) {
    for (const toml::node* count : one_or_many(workers)) {
      into(batches.workers.emplace_back(), 1, kMaxThreads)(*count, key);
    }
    const bool increasing = std::adjacent_find(batches.workers.begin(), batches.workers.end(),
                                               std::greater_equal<>()) == batches.workers.end();
    if (batches.workers.empty() || batches.workers[0] != 1 || !increasing) {
      refuse_toml(workers, fmt::format("{} do not begin with 1 and increase", key));
    }
  };
  read_toml_table(node, what,
                  {{workers, read_workers, true},
                   {"drawings", into(batches.drawings, 1, kMaxRepetitions)},
                   {"repetitions", into(batches.repetitions, 1, kMaxRepetitions)}});
  return batches;
}

TimingRules read_timing_rules(const toml::node& node) {
  TimingRules rules;
  read_toml_table(node, "timing",
                  {{"warm_up", into(rules.warm_up, 0, 1000)},
                   {"concurrency", into(rules.concurrency, 1, kMaxThreads)},
                   {"write", into(rules.write)},
                   {"restart", into(rules.restart)}});
  return rules;
}

Budget read_budget(const toml::node& node) {
  constexpr double kMost = 1e18;
  Budget budget;
  std::vector<TomlKey> keys;
  const auto add = [&](const std::string& name, std::optional<LimitByVertices>& limit) {
    for (double LimitByVertices::*const part :
         {&LimitByVertices::always, &LimitByVertices::per_vertex}) {
      const bool is_more = part == &LimitByVertices::per_vertex;
      keys.push_back({name + (is_more ? "_per_vertex" : ""),
                      [&limit, part](const toml::node& value, const std::string& key) {
                        if (!limit) limit.emplace();
                        number_into((*limit).*part, 0, kMost)(value, key);
                      }});
    }
  };
  add("row_time_s", budget.row_time_s);
  add("row_memory_bytes", budget.row_memory_bytes);
  add("certify_memory_bytes", budget.certify_memory_bytes);
  keys.push_back({"study_s", number_into(budget.study_s, 0, kMost)});
  read_toml_table(node, "budget", keys);
  return budget;
}

std::vector<Settings> combinations(const std::vector<SettingChoices>& settings) {
  std::vector<Settings> all = {{}};
  for (const auto& [name, values] : settings) {
    std::vector<Settings> longer;
    for (const auto& prefix : all) {
      for (const std::int64_t value : values) {
        longer.push_back(prefix);
        longer.back().push_back({name, value});
      }
    }
    if (longer.size() > kMostCombinations) {
      throw InputError("more than 100000 combinations of settings");
    }
    all = std::move(longer);
  }
  return all;
}

void refuse_bad_batches(const toml::node& node, const Sweep& sweep) {
  if (sweep.batches.empty()) return;
  if (any(sweep, [](const AlgorithmChoice& c) { return c.program != nullptr; })) {
    refuse_toml(node, "strong and weak batches are of the catalogue's algorithms only");
  }
  if (any(sweep, [](const AlgorithmChoice& c) { return c.level != Level::extents; })) {
    refuse_toml(node, "strong and weak batches are of level extents only");
  }
  const CertificateMode first = sweep.algorithms.front().certificate;
  if (any(sweep, [&](const AlgorithmChoice& c) { return c.certificate != first; })) {
    refuse_toml(node, "strong and weak batches are judged by one certificate");
  }
}

}  // namespace ar3d
