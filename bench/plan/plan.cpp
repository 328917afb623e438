// Makes the list of rows out of a specification. What instances have in common is kept once, so
// that a plan of many rows is small; rows that two sweeps ask for are planned once.
#include "ar3d/bench/plan/plan.h"

#include <fmt/format.h>

#include <tuple>

#include "ar3d/base/error.h"
#include "ar3d/bench/corpus/corpus.h"

namespace ar3d {
namespace {

constexpr std::size_t kMaxRows = 10000000;
constexpr std::uint64_t kProbeSize = 1000;
constexpr std::uint64_t kLargestProbe = 100 * kProbeSize;

// The largest degree of the family's graphs: of the largest one that the sweep asks for up to
// kProbeSize, or one of kProbeSize if it asks for larger ones only. Where the parameters make even
// that one far larger, planning does not generate it: what the catalogue says has to do.
std::uint32_t probed_degree(const FamilyChoice& choice, const std::vector<std::uint64_t>& sizes) {
  std::uint64_t wanted = std::min(sizes.front(), kProbeSize);
  for (const std::uint64_t size : sizes) {
    if (size <= kProbeSize) wanted = size;
  }
  if (choice.family->nearest_n(wanted, choice.parameters) > kLargestProbe) {
    return choice.family->max_degree;
  }
  return generate(*choice.family, wanted, 0, choice.parameters).max_degree();
}

// Drawings of all repetitions of a batch that so many share; at most 2^50.
std::uint64_t drawings_of(const BatchRules& batches, std::uint32_t workers, RunPhase phase) {
  const std::uint64_t drawings = std::uint64_t{batches.repetitions} * batches.drawings;
  return is_strong(phase) ? drawings : drawings * workers;
}

// Rows of one drawing; at most 2^62.
std::uint64_t rows_of_a_drawing(const Sweep& sweep) {
  std::uint64_t rows = std::uint64_t{sweep.repetitions} + sweep.most_timed;
  for (const auto& [phase, batches] : sweep.batches) {
    for (const std::uint32_t workers : batches.workers)
      rows += drawings_of(batches, workers, phase);
  }
  return rows;
}

// Every row of one drawing, in order.
template <class Use>
void for_each_row(const Sweep& sweep, PlannedRun run, Use&& use) {
  const auto make = [&](RunPhase phase, std::int64_t workers, std::uint32_t i,
                        std::uint32_t batch) {
    run.phase = phase;
    run.workers = workers;
    run.repetition = i;
    run.batch = batch;
    run.optional = phase == RunPhase::timing && i >= sweep.least_timed;
    use(run);
  };
  for (std::uint32_t i = 0; i < sweep.repetitions; ++i) make(RunPhase::metrics, -1, i, 0);
  for (std::uint32_t i = 0; i < sweep.most_timed; ++i) make(RunPhase::timing, -1, i, 0);
  for (const auto& [phase, batches] : sweep.batches) {
    for (const std::uint32_t workers : batches.workers) {
      const auto drawings = static_cast<std::uint32_t>(drawings_of(batches, workers, phase));
      const std::uint32_t members = drawings / batches.repetitions;
      for (std::uint32_t i = 0; i < drawings; ++i) make(phase, workers, i, i / members);
    }
  }
}

bool any_matches(const std::vector<CellPattern>& patterns, const std::string& family,
                 const std::string& algorithm, std::uint64_t n) {
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const CellPattern& p) { return p.matches(family, algorithm, n); });
}

class Planner {
 public:
  explicit Planner(const Study& study) : study_(study), spec_(study.spec) {
    plan_.instances = PlannedInstances(spec_.seed);
  }

  StudyPlan plan() {
    const std::vector<StudyCorpus> corpora = corpora_of(study_);
    for (const Sweep& sweep : spec_.sweeps) {
      require_known_patterns(sweep, corpora);
      for (const FamilyChoice& family : sweep.families) add_sizes(sweep, family);
      for (const StudyCorpus& corpus : corpora) {
        if (corpus.sweep != &sweep) continue;
        for (const FamilyChoice& choice : corpus.choices()) add_corpus_sizes(sweep, choice);
      }
    }
    for (const SizedFamily& sized : sized_) groups_[group_key(sized)].push_back(&sized);
    for (const SizedFamily& sized : sized_) add_instances(sized);
    plan_.timing = spec_.timing;
    plan_.budget = spec_.budget;
    if (plan_.rows() == 0) {
      std::string why = "no algorithm fits a family and a size";
      for (const auto& [algorithm, families] : plan_.left_out) {
        why += fmt::format("; {} draws degree {} at most, not {}", algorithm->name,
                           algorithm->guarantee.max_degree, *families.begin());
      }
      throw InputError(fmt::format("study {} has no run: {}", spec_.name, why));
    }
    return std::move(plan_);
  }

 private:
  // A family at one size, and what is done with each of its instances.
  struct SizedFamily {
    FamilyChoice family;
    std::uint64_t requested_n = 0;
    std::uint64_t n = 0;
    std::uint32_t instances = 1;
    const Sweep* sweep = nullptr;
    std::vector<AlgorithmChoice> algorithms;
    std::size_t first_in_corpus = 0;
  };

  // Parsing could not tell the names of files.
  static void require_known_patterns(const Sweep& sweep, const std::vector<StudyCorpus>& corpora) {
    if (sweep.graphs.empty()) return;
    for (const std::vector<CellPattern>* patterns : {&sweep.include, &sweep.exclude}) {
      for (const CellPattern& pattern : *patterns) {
        const bool is_file =
            std::any_of(corpora.begin(), corpora.end(), [&](const StudyCorpus& corpus) {
              return corpus.sweep == &sweep && corpus.record.name == pattern.family;
            });
        if (pattern.family.empty() || is_file) continue;
        try {
          find_family(pattern.family);
        } catch (const InputError& error) {
          throw InputError(fmt::format("{}{}, and no file of this sweep is called so",
                                       pattern.location, error.what()));
        }
      }
    }
  }

  // One for each number of vertices that graphs of the corpus have. Whether their degrees fit is
  // for their rows to say.
  void add_corpus_sizes(const Sweep& sweep, const FamilyChoice& choice) {
    const Corpus& graphs = *choice.corpus;
    for (std::size_t first = 0, end = 0; first < graphs.size(); first = end) {
      const std::uint64_t n = graphs.n(first);
      while (end < graphs.size() && graphs.n(end) == n) ++end;
      std::vector<AlgorithmChoice> fitting = fitting_algorithms(sweep, choice, 0, n);
      if (fitting.empty()) continue;
      const auto count = static_cast<std::uint32_t>(end - first);
      sized_.push_back({choice, n, n, count, &sweep, std::move(fitting), first});
      count_rows(sized_.back());
    }
  }

  void add_sizes(const Sweep& sweep, const FamilyChoice& family) {
    const std::uint32_t degree = probed_degree(family, sweep.sizes);
    for (const std::uint64_t requested_n : sweep.sizes) {
      const std::uint64_t n = family.family->nearest_n(requested_n, family.parameters);
      const bool many = depends_on_seed(*family.family, family.parameters);
      const std::uint32_t instances = many ? sweep.instances : 1;
      std::vector<AlgorithmChoice> fitting = fitting_algorithms(sweep, family, degree, n);
      if (fitting.empty()) continue;
      sized_.push_back({family, requested_n, n, instances, &sweep, std::move(fitting), 0});
      count_rows(sized_.back());
    }
  }

  // Refuses too many before any of them costs time or memory; rows asked for twice count twice.
  void count_rows(const SizedFamily& sized) {
    const std::size_t drawings = std::size_t{sized.instances} * sized.algorithms.size();
    const std::size_t each = rows_of_a_drawing(*sized.sweep);
    if (each > (kMaxRows - planned_rows_) / drawings) {
      throw InputError(fmt::format("study {} has more than {} rows", spec_.name, kMaxRows));
    }
    planned_rows_ += drawings * each;
  }

  static std::string group_key(const SizedFamily& sized) {
    const std::shared_ptr<const Corpus>& corpus = sized.family.corpus;
    return fmt::format("{}\n{}\n{}\n{}", sized.family.family->name, corpus ? corpus->hash() : "",
                       settings_text(sized.family.parameters), sized.n);
  }

  // The families at one size that have the same graphs.
  using SameGraphs = std::vector<const SizedFamily*>;

  // The instances that none before has asked for, as blocks on which the same members agree.
  void add_instances(const SizedFamily& sized) {
    const SameGraphs& group = groups_.at(group_key(sized));
    std::uint32_t planned = 0;  // instances 0 .. planned - 1
    for (auto before = group.begin(); *before != &sized; ++before) {
      planned = std::max(planned, (*before)->instances);
    }
    while (planned < sized.instances) {
      std::uint32_t end = sized.instances;
      for (const SizedFamily* other : group) {
        if (other->instances > planned) end = std::min(end, other->instances);
      }
      add_block(sized, group, planned, end);
      planned = end;
    }
  }

  void add_block(const SizedFamily& sized, const SameGraphs& group, std::uint32_t first,
                 std::uint32_t end) {
    const auto& corpus = sized.family.corpus;
    const auto index = [&](std::uint32_t i) {
      return corpus ? corpus->index(sized.first_in_corpus + i) : i;
    };
    PlannedInstance instance;
    instance.choice = sized.family;
    instance.parameters = settings_text(sized.family.parameters);
    instance.requested_n = sized.requested_n;
    instance.n = sized.n;
    instance.index = index(first);
    std::set<RunIdentity> known;
    for (const SizedFamily* other : group) {
      if (other->instances > first) add_runs(instance, *other, known);
    }
    if (instance.runs.empty()) return;
    plan_.instances.push_back(std::move(instance));
    for (std::uint32_t i = first + 1; i < end; ++i) plan_.instances.add(index(i));
  }

  std::vector<AlgorithmChoice> fitting_algorithms(const Sweep& sweep, const FamilyChoice& choice,
                                                  std::uint32_t degree, std::uint64_t n) {
    std::vector<AlgorithmChoice> fitting;
    for (const AlgorithmChoice& algorithm : sweep.algorithms) {
      const std::string& family_name = choice.family->name;
      const std::string& name = algorithm.algorithm->name;
      const auto limit = spec_.max_n.find(name);
      if (degree > algorithm.algorithm->guarantee.max_degree) {
        plan_.left_out[algorithm.algorithm].insert(family_name);
      }
      const bool fits =
          degree <= algorithm.algorithm->guarantee.max_degree &&
          (limit == spec_.max_n.end() || n <= limit->second) &&
          (sweep.include.empty() || any_matches(sweep.include, family_name, name, n)) &&
          !any_matches(sweep.exclude, family_name, name, n);
      if (fits) fitting.push_back(algorithm);
    }
    return fitting;
  }

  // What tells the runs of one instance apart.
  using RunIdentity = std::tuple<const Algorithm*, std::string, Level, std::string, RunPhase,
                                 std::int64_t, std::uint32_t>;

  static void add_runs(PlannedInstance& instance, const SizedFamily& sized,
                       std::set<RunIdentity>& known) {
    for (const AlgorithmChoice& choice : sized.algorithms) {
      PlannedRun run;
      run.choice = choice;
      const bool is_measured = choice.algorithm->guarantee.claim == Claim::measured;
      if (is_measured) run.choice.certificate = {};  // whichever was asked for
      run.options = settings_text(choice.options);
      run.precision = sized.sweep->timed_precision;
      for_each_row(*sized.sweep, run, [&](const PlannedRun& row) {
        const bool is_new =
            known
                .emplace(choice.algorithm, row.options, choice.level,
                         to_string(row.choice.certificate), row.phase, row.workers, row.repetition)
                .second;
        if (is_new) instance.runs.push_back(row);
      });
    }
  }

  const Study& study_;
  const StudySpec& spec_;
  std::vector<SizedFamily> sized_;
  std::size_t planned_rows_ = 0;  // of all of them
  StudyPlan plan_;
  std::map<std::string, SameGraphs> groups_;
};

}  // namespace

CurveKey curve_of(const PlannedInstance& instance, const PlannedRun& run) {
  const Level level = run.choice.level;
  return {run.choice.algorithm->name, run.options, instance.choice.family->name,
          instance.parameters, level == Level::extents ? "" : to_string(level)};
}

bool is_same_drawing(const PlannedRun& a, const PlannedRun& b) {
  return a.choice.algorithm == b.choice.algorithm && a.options == b.options &&
         a.choice.level == b.choice.level && a.choice.certificate == b.choice.certificate;
}

StudyPlan plan_study(const Study& study) { return Planner(study).plan(); }

}  // namespace ar3d
