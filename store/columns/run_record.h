#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ar3d {

inline constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

enum class RunStatus : std::uint8_t {
  ok,             ///< proved right
  timeout,        ///< no answer in time
  out_of_memory,  ///< an allocation failed, or passed a limit
  refused,        ///< the generator or the algorithm refused its input
  violated,       ///< proved wrong
  crashed,        ///< an invariant broke, the process died, an answer was no drawing
  measured        ///< drawn and measured; nothing was promised, so nothing was judged
};
/// Returns "ok", "timeout", "out_of_memory", "refused", "violated", "crashed", "measured".
const char* to_string(RunStatus status);
/// @throws InputError naming the text if it is no status.
RunStatus parse_run_status(std::string_view text);
/// Returns whether a drawing came out and is not proved wrong; whether there is no telling what would
/// have come out.
constexpr bool is_good(RunStatus status) {
  return status == RunStatus::ok || status == RunStatus::measured;
}
constexpr bool is_unfinished(RunStatus status) {
  return status == RunStatus::timeout || status == RunStatus::out_of_memory ||
         status == RunStatus::crashed;
}

/// Says what a row was made for. metrics: certified, on all cores, its times disturbed by the other
/// workers; timing: alone on a core of its own; strong, weak: one of a batch of equal drawings
/// that several threads share; strong_ranks, weak_ranks: that several ranks share.
enum class RunPhase : std::uint8_t { metrics, timing, strong, weak, strong_ranks, weak_ranks };
/// Returns "metrics", "timing", "strong", "weak", "strong_r", "weak_r".
const char* to_string(RunPhase phase);
/// Returns whether its rows are drawn in batches; whether these are of one size, however many share
/// them; whether ranks share them, not threads.
constexpr bool is_batched(RunPhase phase) { return phase >= RunPhase::strong; }
constexpr bool is_strong(RunPhase phase) {
  return phase == RunPhase::strong || phase == RunPhase::strong_ranks;
}
constexpr bool is_over_ranks(RunPhase phase) { return phase >= RunPhase::strong_ranks; }
/// @throws InputError naming the text if it is no phase.
RunPhase parse_run_phase(std::string_view text);

/// Holds what is measured beside timed rows: a search of a graph that fits a core's caches, of one
/// that does not, and arithmetic without memory.
inline constexpr std::array kYardsticks = {"cached", "memory", "arithmetic"};

/// Holds what all rows of one drawing have in common. Missing integers are -1, missing floats NaN.
struct DrawingResult {
  RunStatus status = RunStatus::crashed;
  std::string message;       ///< first violation or error, cut to fit
  std::string drawing_hash;  ///< 32 hexadecimal digits
  std::int64_t violations = -1;
  std::string certificate;  ///< how the drawing was judged: empty for exact, "measured", "none"
  std::array<std::int64_t, 3> instance_bound{-1, -1, -1};  ///< from the proof, for this instance
  std::string counters;                                    ///< "H=3;mode=1"

  // Metrics: those of verify/metrics/metrics.h that code reasons with have a member here, and every
  // other one its value in `other_metrics`, in the order of that table.
  std::array<std::int64_t, 3> extents{-1, -1, -1};
  double log2_volume = kMissing;  ///< sum of log2(extent + 1) over the axes
  std::array<std::int64_t, 8> bends{-1, -1, -1, -1, -1, -1, -1, -1};  ///< edges with b bends;
                                                                      ///< last: 7 or more
  double total_edge_length = kMissing;
  double longest_edge_length = kMissing;
  double smallest_vertex_distance = kMissing;                     ///< missing if n < 2
  std::vector<std::variant<std::int64_t, double>> other_metrics;  ///< MetricValues; empty: missing

  // What follows from algorithm, options and n; see set_bounds(). No columns of /runs.
  std::array<double, 3> theorem_bound{kMissing, kMissing, kMissing};
  /// Holds a published bound, for comparison only; missing if there is none.
  std::array<double, 3> published_bound{kMissing, kMissing, kMissing};
};

/// Describes one row of /runs: instance x algorithm x options x repetition. Times in seconds,
/// memory in bytes, lengths and extents in lattice units. Missing integers are -1, missing floats
/// NaN; never 0.
struct RunRecord : DrawingResult {
  std::string row_key;  ///< 32 hexadecimal digits: identity of (study, instance, algorithm,
                        ///< options, repetition)
  std::string family;
  std::string parameters;  ///< "k=2;p=750000", complete and in catalogue order
  std::int64_t requested_n = -1;
  std::int64_t n = -1;
  std::int64_t m = -1;
  std::int64_t instance_index = -1;  ///< 0, 1, … : which instance of (family, parameters, n)
  std::uint64_t seed = 0;            ///< the generator's seed of this instance
  std::string graph_hash;            ///< 32 hexadecimal digits
  std::string graph_name;  ///< of a graph of files: its file, "#3" behind it if of several
  std::string group;       ///< of a graph of a collection
  std::int64_t max_degree = -1;
  std::string algorithm;
  std::string options;  ///< "effort=1", complete and in catalogue order
  RunPhase phase = RunPhase::metrics;
  std::int64_t workers = -1;     ///< threads or ranks that share the batch; missing outside of one
  std::int64_t repetition = -1;  ///< within (phase, workers)
  std::string
      level;  ///< "extents", "positions", "full": what was stored of the drawing; may be missing

  // Measured.
  double generate_s = kMissing;
  double wall_s = kMissing;   ///< drawing only
  double cpu_s = kMissing;    ///< drawing only, CPU time of the thread
  double store_s = kMissing;  ///< storing positions or bends, as the level asks
  double certify_s = kMissing;
  double metrics_s = kMissing;
  double write_s = kMissing;      ///< formatting the drawing as JSON lines into nothing
  std::int64_t concurrency = -1;  ///< rows that this study makes at the same time
  std::int64_t core = -1;         ///< core that the row was pinned to
  std::int64_t warm_ups = -1;     ///< drawings of the same graph just before, thrown away
  /// Holds CPU times of yardsticks near the row, which tell how fast the machine was: kYardsticks.
  std::array<double, 3> yardsticks_s{kMissing, kMissing, kMissing};
  std::string build_kind;          ///< why its times are worth little: "debug", "sanitised"
  std::int64_t instructions = -1;  ///< drawing only, by hardware counters, user space
  std::int64_t cycles = -1;
  std::int64_t cache_misses = -1;
  std::int64_t counted_instructions = -1;  ///< drawing only, counted by callgrind
  std::int64_t estimated_cycles = -1;      ///< of the same, with callgrind's simulated cache
  std::int64_t base_bytes = -1;            ///< resident memory when the row began
  std::int64_t draw_peak_bytes = -1;       ///< peak resident memory while drawing
  std::int64_t peak_bytes = -1;     ///< peak resident memory from the row's beginning to its end
  std::string peak_scope;           ///< "row", "worker", "process"; empty if missing
  double batch_s = kMissing;        ///< wall time of the whole batch, if in one
  double ideal_batch_s = kMissing;  ///< what it would be with perfect scaling
  double efficiency = kMissing;     ///< ideal_batch_s / batch_s
  std::int64_t session = -1;        ///< which of the /environments it was made in
};

/// Returns true if a drawing came out, proved right or wrong.
inline bool is_drawn(const RunRecord& run) {
  return is_good(run.status) || run.status == RunStatus::violated;
}

/// Returns the certificate that was asked for, as the row's certificate and message tell: "exact",
/// "none", "measured"; in results of 0.2.0 also "double" and others, which proved nothing: the
/// message of a drawing that such a one did not accept begins "certificate double did not accept
/// it; ".
std::string asked_certificate(const RunRecord& run);

/// Returns the time of drawing that is judged: CPU time of the thread, since other processes
/// lengthen only the wall time by taking turns with it; wall time where the CPU time is missing.
inline double drawing_time_s(const RunRecord& run) {
  return run.cpu_s > 0 ? run.cpu_s : run.wall_s;
}

/// Returns how slow the machine was near the row: the mean of the logarithms of the two yardsticks
/// that are as short as a small drawing (that of memory is too rare and noisy); NaN if they are
/// missing.
inline double log_slowness(const RunRecord& run) {
  const double product = run.yardsticks_s[0] * run.yardsticks_s[2];
  return product > 0 ? std::log(product) / 2 : kMissing;
}

/// Returns the logarithm of the drawing time in units of those yardsticks, else in seconds.
inline double log_corrected_time(const RunRecord& run) {
  const double slowness = log_slowness(run);
  return std::log(drawing_time_s(run)) - (std::isnan(slowness) ? 0 : slowness);
}

}  // namespace ar3d
