#include "ar3d/bench/run_instance.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <new>
#include <optional>

#include "ar3d/model/error.h"
#include "ar3d/results/columns.h"
#include "ar3d/verify/certificate.h"
#include "ar3d/verify/metrics.h"

namespace ar3d {
namespace {

// Wall time, and CPU time of the calling thread, since construction.
class Stopwatch {
 public:
  double wall_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_).count();
  }
  double cpu_s() const { return thread_cpu_s() - cpu_; }

 private:
  static double thread_cpu_s() {
    std::timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }

  double cpu_ = thread_cpu_s();
  std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
};

// Runs a step; what it throws becomes the row's status and message. True if it threw nothing.
template <class Step>
bool attempt(Run& run, Step&& step) {
  const auto failed = [&run](RunStatus status, const char* message) {
    run.status = status;
    run.message = message;
    return false;
  };
  try {
    step();
    return true;
  } catch (const InputError& error) {
    return failed(RunStatus::refused, error.what());
  } catch (const std::bad_alloc&) {
    return failed(RunStatus::out_of_memory, "out of memory");
  } catch (const std::exception& error) {
    return failed(RunStatus::crashed, error.what());
  }
}

std::int64_t peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;
}

std::string counters_text(const std::vector<Counter>& counters) {
  std::string text;
  for (const Counter& counter : counters) {
    text += fmt::format("{}{}={}", text.empty() ? "" : ";", counter.name, counter.value);
  }
  return text;
}

void record_verdict(Run& run, const Certificate& certificate) {
  run.violations = static_cast<std::int64_t>(certificate.violations.size());
  run.status = certificate.valid() ? RunStatus::ok : RunStatus::violated;
  if (!certificate.valid()) run.message = certificate.violations.front().message;
}

void record_metrics(Run& run, const Metrics& metrics) {
  run.extents = metrics.extents;
  run.log2_volume = metrics.log2_volume;
  run.volume_per_n3 = metrics.volume_per_n3;
  run.theorem_bound = metrics.theorem_bound;
  run.slack = metrics.slack;
  run.total_edge_length = metrics.total_edge_length;
  run.longest_edge_length = metrics.longest_edge_length;
  run.smallest_vertex_distance = metrics.smallest_vertex_distance;
  run.bends.fill(0);
  for (std::size_t bends = 0; bends < metrics.bend_histogram.size(); ++bends) {
    run.bends[std::min(bends, run.bends.size() - 1)] +=
        static_cast<std::int64_t>(metrics.bend_histogram[bends]);
  }
}

void record_formulas(Run& run, const Guarantee& guarantee) {
  run.theorem_bound_formula = guarantee.bound.formula();
  if (guarantee.published.empty()) return;
  const SizeBound& published = guarantee.published.front();
  run.published_bound_formula = published.formula();
  for (std::size_t axis = 0; axis < 3 && run.n > 0; ++axis) {
    run.published_bound[axis] = published.axes[axis].value(static_cast<std::uint64_t>(run.n));
  }
}

void draw_and_certify(const Graph& graph, const AlgorithmChoice& choice, Run& run) {
  const Stopwatch drawing_time;
  const Drawing drawing = draw(*choice.algorithm, graph, choice.options);
  run.wall_s = drawing_time.wall_s();
  run.cpu_s = drawing_time.cpu_s();
  run.drawing_hash = drawing_hash(drawing);
  run.counters = counters_text(drawing.counters);
  if (drawing.instance_bound) run.instance_bound = *drawing.instance_bound;

  const Stopwatch certifying_time;
  const Certificate certificate = certify(graph, drawing, choice.algorithm->guarantee);
  run.certify_s = certifying_time.wall_s();
  record_verdict(run, certificate);
  record_metrics(run, measure(graph, drawing, choice.algorithm->guarantee));
  record_formulas(run, choice.algorithm->guarantee);
}

Run described(const PlannedInstance& instance) {
  Run run;
  run.family = instance.choice.family->name;
  run.parameters = instance.parameters;
  run.wanted_n = static_cast<std::int64_t>(instance.wanted_n);
  run.instance_index = instance.index;
  run.seed = instance.seed;
  return run;
}

Run row_of(const Run& instance, const PlannedRun& planned) {
  Run run = instance;
  run.row_key = planned.row_key;
  run.algorithm = planned.choice.algorithm->name;
  run.options = planned.options;
  run.phase = planned.phase;
  run.scale = planned.scale;
  run.repetition = planned.repetition;
  return run;
}

// A row that no results file could hold (a name that is too long, say) is a bug, but only of this
// row.
void require_storable(Run& run) {
  std::string record(run_record_size(), '\0');
  if (!attempt(run, [&] { store_record(run, record.data()); })) {
    run.status = RunStatus::crashed;
    run.counters.clear();
  }
}

std::vector<const PlannedRun*> in_order_of_execution(
    const PlannedInstance& instance, const std::function<bool(const std::string&)>& wanted) {
  std::vector<const PlannedRun*> runs;
  for (const PlannedRun& run : instance.runs) {
    if (!wanted || wanted(run.row_key)) runs.push_back(&run);
  }
  std::stable_sort(runs.begin(), runs.end(), [](const PlannedRun* a, const PlannedRun* b) {
    return a->repetition < b->repetition;
  });
  return runs;
}

}  // namespace

void run_instance(const PlannedInstance& instance,
                  const std::function<bool(const std::string& row_key)>& wanted,
                  const std::function<bool()>& stop,
                  const std::function<void(std::size_t row, Run run)>& emit) {
  const std::vector<const PlannedRun*> runs = in_order_of_execution(instance, wanted);
  if (runs.empty()) return;
  Run base = described(instance);
  std::optional<Graph> graph;
  const bool generated = attempt(base, [&] {
    const Stopwatch time;
    const FamilyChoice& choice = instance.choice;
    graph = generate(*choice.family, instance.wanted_n, instance.seed, choice.parameters);
    base.generate_s = time.wall_s();
    base.n = graph->num_vertices();
    base.m = graph->num_edges();
    base.graph_hash = graph_hash(*graph);
  });
  for (const PlannedRun* planned : runs) {
    if (stop && stop()) return;
    Run run = row_of(base, *planned);
    if (generated) attempt(run, [&] { draw_and_certify(*graph, planned->choice, run); });
    run.peak_bytes = peak_bytes();
    run.peak_scope = "process";
    require_storable(run);
    emit(planned->row, std::move(run));
  }
}

}  // namespace ar3d
