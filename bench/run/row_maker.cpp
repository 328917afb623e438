// Makes one row: generates, draws, certifies, measures. Only drawing is inside the clock, and
// whatever goes wrong becomes the status and message of the row.
#include "ar3d/bench/run/row_maker.h"

#include <xxhash.h>

#include <new>

#include "ar3d/base/error.h"
#include "ar3d/bench/corpus/corpus.h"
#include "ar3d/bench/measure/environment.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/store/columns/run_columns.h"
#include "ar3d/verify/examination.h"

namespace ar3d {
namespace {

void record_verdict(RunRecord& run, const Certificate& certificate) {
  const bool is_judged = certificate.mode != CertificateMode::none;
  run.violations = is_judged ? static_cast<std::int64_t>(certificate.violations.size()) : -1;
  run.certificate = certificate.measured ? "measured" : is_judged ? "" : "none";
  run.status = certificate.violated() ? RunStatus::violated : RunStatus::ok;
  if (certificate.violated()) run.message = certificate.violations.front().message;
}

double timed_writing_s(const Drawing& drawing) {
  OutputFile nowhere("/dev/null");
  const Stopwatch time;
  write_drawing_line(nowhere, drawing);
  nowhere.flush();
  return time.seconds();
}

constexpr std::size_t kMostCrossings = 1000000;

// What a program answers may have any number of segments any two of which are near each other; it
// is judged no longer than a drawing of that graph can be worth.
std::uint64_t most_comparisons(const Graph& graph) {
  constexpr std::uint64_t kAlways = 100000000;
  constexpr std::uint64_t kEach = 10000;
  return kAlways + kEach * (std::uint64_t{graph.num_vertices()} + graph.num_edges());
}

// How a drawing is held to the guarantee. One of another process may stand on any lattice, and its
// crossings are counted, however many there are, within reason.
CertifyOptions certifying(const AlgorithmChoice& choice, bool is_of_another,
                          const std::optional<LimitByVertices>& memory, const Graph& graph,
                          const Drawing& drawing, Guarantee& guarantee) {
  CertifyOptions options;
  options.mode = choice.certificate;
  if (memory) {
    options.proof_bytes =
        static_cast<std::uint64_t>(std::clamp((*memory)(graph.num_vertices()), 1.0, 1e18));
  }
  if (!is_of_another) return options;
  guarantee.lattice = drawing.lattice();
  options.max_violations = kMostCrossings;
  options.most_comparisons = most_comparisons(graph);
  options.check_size = choice.is_judged();
  return options;
}

// Why the crossings of a drawing were not counted.
std::string uncounted_crossings(const Certificate& certificate, const Graph& graph) {
  if (certificate.mode == CertificateMode::none) {
    return "crossings not counted: certificate = \"none\"";
  }
  if (certificate.given_up) {
    return fmt::format("crossings not counted: it takes more than {} comparisons of segments",
                       most_comparisons(graph));
  }
  return fmt::format("crossings not counted: there are more than {}", kMostCrossings);
}

// A drawing that was neither proved wrong nor judged to the end.
void refuse_given_up(const Certificate& certificate, const Graph& graph) {
  if (!certificate.given_up || !certificate.violations.empty()) return;
  throw ProgramFailure(
      RunStatus::timeout,
      fmt::format("drawn, but not judged: it takes more than {} comparisons of segments",
                  most_comparisons(graph)));
}

RunRecord instance_row(const PlannedInstance& instance) {
  RunRecord run;
  run.family = instance.choice.family->name;
  run.parameters = instance.parameters;
  run.requested_n = static_cast<std::int64_t>(instance.requested_n);
  run.instance_index = instance.index;
  run.seed = instance.seed;
  if (const auto& corpus = instance.choice.corpus) {
    run.graph_name = corpus->graph_name(instance.index);
    run.group = corpus->file_at(instance.index).group;
  }
  return run;
}

void set_run(const PlannedRun& planned, RunRecord& run) {
  run.row_key = planned.row_key;
  run.algorithm = planned.choice.algorithm->name;
  run.options = planned.options;
  run.level = to_string(planned.choice.level);
  const CertificateMode asked = planned.choice.certificate;
  if (asked == CertificateMode::none) run.certificate = to_string(asked);  // until the verdict
  run.phase = planned.phase;
  run.workers = planned.workers;
  run.repetition = planned.repetition;
}

constexpr std::size_t kHead = sizeof(std::uint64_t);  // of a row on its way: the checksum

std::uint64_t checksum_of(std::string_view message) {
  return XXH3_64bits(message.data() + kHead, message.size() - kHead);
}

}  // namespace

bool attempt(RunRecord& run, const std::function<void()>& step) {
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
  } catch (const ProgramFailure& failure) {
    return failed(failure.status(), failure.what());
  } catch (const std::bad_alloc&) {
    return failed(RunStatus::out_of_memory, "out of memory");
  } catch (const std::exception& error) {
    return failed(RunStatus::crashed, error.what());
  }
}

RowMaker::RowMaker(MemoryScope memory, std::int64_t concurrency, std::int64_t core,
                   const std::optional<LimitByVertices>& certify_memory_bytes)
    : concurrency_(concurrency),
      core_(core),
      certify_memory_bytes_(certify_memory_bytes),
      memory_(memory) {}

const PlannedInstance& RowMaker::prepare(const StudyPlan& plan, std::size_t index) {
  if (index_ != index) {
    instance_ = plan.instances[index];
    prepare(instance_);
    index_ = index;
  }
  return instance_;
}

void RowMaker::prepare(const PlannedInstance& instance) {
  index_.reset();
  graph_.reset();
  needs_.reset();
  base_ = instance_row(instance);
  attempt(base_, [&] {
    const Stopwatch time;
    Graph graph = graph_of(instance);
    base_.generate_s = time.seconds();
    base_.n = graph.num_vertices();
    base_.m = graph.num_edges();
    base_.graph_hash = graph_hash(graph);
    base_.max_degree = graph.max_degree();
    graph_ = std::move(graph);
  });
}

RunRecord RowMaker::begun(const PlannedRun& planned) const {
  RunRecord run = base_;
  set_run(planned, run);
  run.concurrency = concurrency_;
  run.core = core_;
  run.build_kind = build_kind();
  return run;
}

RunRecord RowMaker::make_row(const PlannedRun& planned, const RowRequest& request) {
  RunRecord run = begun(planned);
  if (planned.phase == RunPhase::timing) {
    if (!yardsticks_) yardsticks_.emplace();
    run.yardsticks_s = yardsticks_->now_s();
  }
  run.base_bytes = memory_.begin_row();
  if (graph_) attempt(run, [&] { draw_and_certify(planned, request, run); });
  run.peak_bytes = memory_.peak_bytes();
  run.peak_scope = to_string(memory_.scope());
  // A row that no results file could hold (a name that is too long, say) is a bug, but only of this
  // row.
  if (!attempt(run, [&] { record_of(run); })) {
    run.status = RunStatus::crashed;
    run.counters.clear();
  }
  return run;
}

Drawing RowMaker::draw_timed(const PlannedRun& planned, const RowRequest& request, RunRecord& run) {
  const AlgorithmChoice& choice = planned.choice;
  if (request.restart && std::exchange(round_, run.repetition) != run.repetition) drawer_.restart();
  for (std::uint32_t i = 0; i < request.warm_ups; ++i) {
    draw(*choice.algorithm, *graph_, choice.options);
  }
  run.warm_ups = request.warm_ups;
  if (request.warm_ups > 0) memory_.restart();
  drawer_.take_times();  // of warm-ups
  return timed_drawing(*graph_, choice, counters_, run);
}

void RowMaker::draw_and_certify(const PlannedRun& planned, const RowRequest& request,
                                RunRecord& run) {
  const AlgorithmChoice& choice = planned.choice;
  const bool is_judged = choice.is_judged();
  Drawing drawing = draw_timed(planned, request, run);
  const auto times_of_another = drawer_.take_times();  // process, if one has drawn
  if (times_of_another) {
    run.wall_s = times_of_another->wall_s;
    run.cpu_s = times_of_another->cpu_s;
    run.instructions = run.cycles = run.cache_misses = -1;
  }
  if (memory_.scope() != MemoryScope::process) run.draw_peak_bytes = memory_.peak_bytes();
  if (choice.level != Level::extents) {
    const Stopwatch storing_time;
    drawing = at_level(std::move(drawing), choice.level);
    run.store_s = storing_time.seconds();
  }
  run.counters = settings_text(drawing.counters);
  if (drawing.instance_bound) run.instance_bound = *drawing.instance_bound;
  if (request.write) run.write_s = timed_writing_s(drawing);
  if (!request.certify) {
    run.drawing_hash = drawing_hash(drawing);
    run.status = is_judged ? RunStatus::ok : RunStatus::measured;
    return;
  }
  Guarantee guarantee = choice.algorithm->guarantee;
  const CertifyOptions how = certifying(choice, times_of_another.has_value(), certify_memory_bytes_,
                                        *graph_, drawing, guarantee);
  Examination examination = examine(*graph_, drawing, guarantee, {}, how);
  const Stopwatch angles_time;
  auto& summary = examination.summary;
  if (!summary.real) {
    set_angles_and_crossings(*graph_, drawing, guarantee, examination.certificate, summary);
  } else if (!is_judged) {  // versions of a program are compared by these
    summary.smallest_vertex_angle = summary.real->smallest_vertex_angle;
    summary.smallest_bend_angle = summary.real->smallest_bend_angle;
  }
  run.certify_s = examination.certify_s;
  run.metrics_s = examination.metrics_s + angles_time.seconds();
  run.drawing_hash = examination.drawing_hash;
  if (is_judged) {
    if (!needs_) needs_ = needs_of(*graph_);
    if (request.bisect && base_.instance_index == 0) seek_bisection(*graph_, guarantee, *needs_);
    examination.summary.volume_at_least = volume_at_least(*needs_, guarantee);
    examination.summary.optimum = known_optimum(*graph_, guarantee);
  }
  set_metrics(examination.summary, run);
  if (is_judged) {
    refuse_given_up(examination.certificate, *graph_);
    record_verdict(run, examination.certificate);
    const bool is_published = !guarantee.published.empty();
    set_bounds(&guarantee.bound, is_published ? &guarantee.published.front() : nullptr, run);
  } else {
    run.status = RunStatus::measured;
    if (examination.summary.crossings < 0) {
      run.message = uncounted_crossings(examination.certificate, *graph_);
    }
  }
}

Drawing timed_drawing(const Graph& graph, const AlgorithmChoice& choice, HardwareCounters& counters,
                      RunRecord& run) {
  counters.start();
  const Stopwatch cpu(kCpuTime);
  const Stopwatch time;
  Drawing drawing = draw(*choice.algorithm, graph, choice.options);
  run.wall_s = time.seconds();
  run.cpu_s = cpu.seconds();
  const auto [instructions, cycles, cache_misses] = counters.stop();
  run.instructions = instructions;
  run.cycles = cycles;
  run.cache_misses = cache_misses;
  return drawing;
}

RunRecord planned_row(const PlannedInstance& instance, const PlannedRun& planned) {
  RunRecord run = instance_row(instance);
  set_run(planned, run);
  return run;
}

RunRecord failed_row(const PlannedInstance& instance, const PlannedRun& planned,
                     const RunRecord& failed) {
  RunRecord run = planned_row(instance, planned);
  run.n = failed.n;
  run.m = failed.m;
  run.graph_hash = failed.graph_hash;
  run.max_degree = failed.max_degree;
  run.status = failed.status;
  run.message = failed.message;
  return run;
}

void take_over_certificate(const RunRecord& certified, RunRecord& run) {
  if (!is_good(run.status)) return;
  if (run.drawing_hash != certified.drawing_hash) {
    run.status = RunStatus::crashed;
    run.message = "another drawing than the certified one of the same graph and options";
    return;
  }
  static_cast<DrawingResult&>(run) = certified;
}

std::size_t row_message_size() { return kHead + 1 + run_record_size(); }

std::string row_message(char tag, const RunRecord& row) {
  std::string message(row_message_size(), '\0');
  message[kHead] = tag;
  store_record(row, message.data() + kHead + 1);
  const std::uint64_t checksum = checksum_of(message);
  std::memcpy(message.data(), &checksum, kHead);
  return message;
}

std::optional<char> read_row_message(std::string_view bytes, RunRecord& row) {
  std::uint64_t checksum = 0;
  if (bytes.size() != row_message_size()) return std::nullopt;
  std::memcpy(&checksum, bytes.data(), kHead);
  if (checksum != checksum_of(bytes)) return std::nullopt;
  row = load_record(bytes.data() + kHead + 1);
  return bytes[kHead];
}

}  // namespace ar3d
