#include "ar3d/analysis/cells.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace ar3d {
namespace {

std::string with_brackets(const std::string& name, const std::string& details) {
  return details.empty() ? name : name + " (" + details + ")";
}

/// Groups the cell's rows by instance. Two wanted sizes may lead to the same n; they stay two
/// instances.
std::vector<InstanceRows> group_instances(const Results& results, const Cell& cell) {
  std::map<std::tuple<std::int64_t, std::int64_t, std::uint64_t>, std::size_t> index_of;
  std::vector<InstanceRows> instances;
  for (const std::size_t row : cell.rows) {
    const RunRecord& run = results.runs[row];
    const auto identity = std::tuple(run.requested_n, run.instance_index, run.seed);
    const auto [place, is_new] = index_of.try_emplace(identity, instances.size());
    if (is_new) instances.push_back({run.n >= 0 ? run.n : run.requested_n, {}});
    instances[place->second].rows.push_back(row);
  }
  std::stable_sort(instances.begin(), instances.end(),
                   [](const auto& a, const auto& b) { return a.n < b.n; });
  return instances;
}

}  // namespace

std::string algorithm_label(const CellKey& key) {
  return with_brackets(key.algorithm, key.options);
}

std::string family_label(const CellKey& key) { return with_brackets(key.family, key.parameters); }

std::vector<Cell> cells(const Results& results) {
  std::map<CellKey, std::size_t> index_of;
  std::vector<Cell> cells;
  for (std::size_t row = 0; row < results.runs.size(); ++row) {
    const RunRecord& run = results.runs[row];
    const CellKey key{run.algorithm, run.options, run.family, run.parameters};
    const auto [place, is_new] = index_of.try_emplace(key, cells.size());
    if (is_new) cells.push_back({key, {}, {}});
    cells[place->second].rows.push_back(row);
  }
  for (Cell& cell : cells) cell.instances = group_instances(results, cell);
  return cells;
}

const RunRecord* first_ok(const Results& results, const InstanceRows& instance) {
  for (const std::size_t row : instance.rows) {
    if (results.runs[row].status == RunStatus::ok) return &results.runs[row];
  }
  return nullptr;
}

}  // namespace ar3d
