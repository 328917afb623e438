#include "ar3d/bench/plan.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "ar3d/model/error.h"
#include "ar3d/model/random.h"

namespace ar3d {
namespace {

constexpr std::size_t kMaxRows = 10000000;
constexpr std::uint64_t kProbeSize = 1000;

// "a=1;b=2" for ParameterValues and OptionValues.
template <class Values>
std::string settings_text(const Values& values) {
  std::string text;
  for (const auto& value : values) {
    text += fmt::format("{}{}={}", text.empty() ? "" : ";", value.name, value.value);
  }
  return text;
}

std::string hash128(const std::string& text) {
  const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

std::string instance_identity(const PlannedInstance& instance) {
  return fmt::format("family={}\nparameters={}\nn={}\nindex={}\n", instance.choice.family->name,
                     instance.parameters, instance.n, instance.index);
}

std::uint64_t instance_seed(std::uint64_t study_seed, const std::string& identity) {
  return mix_seed(study_seed, XXH3_64bits(identity.data(), identity.size()));
}

// The largest degree of the family's graphs: of the largest one that the sweep asks for up to
// kProbeSize.
std::uint32_t probed_degree(const FamilyChoice& choice, const std::vector<std::uint64_t>& sizes) {
  std::uint64_t wanted = sizes.front();
  for (const std::uint64_t size : sizes) {
    if (size <= kProbeSize) wanted = size;
  }
  return generate(*choice.family, wanted, 0, choice.parameters).max_degree();
}

bool any_matches(const std::vector<CellPattern>& patterns, const std::string& family,
                 const std::string& algorithm, std::uint64_t n) {
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const CellPattern& p) { return p.matches(family, algorithm, n); });
}

class Planner {
 public:
  explicit Planner(const StudySpec& spec) : spec_(spec) {}

  StudyPlan plan() {
    for (const Sweep& sweep : spec_.sweeps) {
      for (const FamilyChoice& family : sweep.families) add_cells(sweep, family);
    }
    refuse_too_many_rows();
    for (const Cell& cell : cells_) add_instances(cell);
    drop_empty_instances();
    number_rows();
    if (plan_.rows == 0) {
      throw InputError(
          fmt::format("study {} has no run: no algorithm fits a family and a size", spec_.name));
    }
    return std::move(plan_);
  }

 private:
  // A family at one size, and what is done with each of its instances.
  struct Cell {
    FamilyChoice family;
    std::uint64_t wanted_n = 0;
    std::uint64_t n = 0;
    std::uint32_t instances = 1;
    std::uint32_t repetitions = 1;
    std::vector<AlgorithmChoice> algorithms;
  };

  void add_cells(const Sweep& sweep, const FamilyChoice& family) {
    const std::uint32_t degree = probed_degree(family, sweep.sizes);
    for (const std::uint64_t wanted_n : sweep.sizes) {
      const std::uint64_t n = family.family->nearest_n(wanted_n, family.parameters);
      const std::uint32_t instances = family.family->is_random ? sweep.instances : 1;
      cells_.push_back({family, wanted_n, n, instances, sweep.repetitions,
                        fitting_algorithms(sweep, family, degree, n)});
    }
  }

  // Before any of them costs time or memory; rows that are asked for twice count twice.
  void refuse_too_many_rows() const {
    std::size_t rows = 0;
    for (const Cell& cell : cells_) {  // less than 2^60 a cell: no sum wraps before it is refused
      rows += std::size_t{cell.instances} * cell.repetitions * cell.algorithms.size();
      if (rows > kMaxRows) {
        throw InputError(fmt::format("study {} has more than {} rows", spec_.name, kMaxRows));
      }
    }
  }

  void add_instances(const Cell& cell) {
    if (cell.algorithms.empty()) return;
    for (std::uint32_t index = 0; index < cell.instances; ++index) {
      add_runs(instance_of(cell, index), cell);
    }
  }

  std::vector<AlgorithmChoice> fitting_algorithms(const Sweep& sweep, const FamilyChoice& choice,
                                                  std::uint32_t degree, std::uint64_t n) const {
    std::vector<AlgorithmChoice> fitting;
    for (const AlgorithmChoice& algorithm : sweep.algorithms) {
      const std::string& family_name = choice.family->name;
      const std::string& name = algorithm.algorithm->name;
      const auto limit = spec_.max_n.find(name);
      const bool fits =
          degree <= algorithm.algorithm->guarantee.max_degree &&
          (limit == spec_.max_n.end() || n <= limit->second) &&
          (sweep.include.empty() || any_matches(sweep.include, family_name, name, n)) &&
          !any_matches(sweep.exclude, family_name, name, n);
      if (fits) fitting.push_back(algorithm);
    }
    return fitting;
  }

  PlannedInstance& instance_of(const Cell& cell, std::uint32_t index) {
    PlannedInstance instance;
    instance.choice = cell.family;
    instance.parameters = settings_text(cell.family.parameters);
    instance.wanted_n = cell.wanted_n;
    instance.n = cell.n;
    instance.index = index;
    const std::string identity = instance_identity(instance);
    const auto [at, is_new] = place_of_.try_emplace(identity, plan_.instances.size());
    if (is_new) {
      instance.seed = instance_seed(spec_.seed, identity);
      plan_.instances.push_back(std::move(instance));
    }
    return plan_.instances[at->second];
  }

  void add_runs(PlannedInstance& instance, const Cell& cell) {
    const std::string prefix =
        fmt::format("study_seed={}\n{}", spec_.seed, instance_identity(instance));
    for (const AlgorithmChoice& choice : cell.algorithms) {
      const std::string options = settings_text(choice.options);
      for (std::uint32_t repetition = 0; repetition < cell.repetitions; ++repetition) {
        std::string key = hash128(fmt::format("{}algorithm={}\noptions={}\nrepetition={}\n", prefix,
                                              choice.algorithm->name, options, repetition));
        if (!keys_.insert(key).second) continue;
        instance.runs.push_back({choice, options, repetition, std::move(key), 0});
      }
    }
  }

  void drop_empty_instances() {
    std::erase_if(plan_.instances, [](const PlannedInstance& i) { return i.runs.empty(); });
  }

  void number_rows() {
    for (PlannedInstance& instance : plan_.instances) {
      for (PlannedRun& run : instance.runs) run.row = plan_.rows++;
    }
  }

  const StudySpec& spec_;
  std::vector<Cell> cells_;
  StudyPlan plan_;
  std::unordered_map<std::string, std::size_t> place_of_;  // instance identity -> place in the plan
  std::unordered_set<std::string> keys_;
};

}  // namespace

StudyPlan plan_study(const StudySpec& spec) { return Planner(spec).plan(); }

}  // namespace ar3d
