#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "ar3d/bench/external/external_drawer.h"
#include "ar3d/bench/measure/instruments.h"
#include "ar3d/bench/plan/plan.h"
#include "ar3d/model/graph.h"
#include "ar3d/store/columns/run_record.h"
#include "ar3d/verify/metrics/volume_bound.h"

namespace ar3d {

/// Says which row of a plan is asked for, and what is done for it besides drawing.
struct RowRequest {
  std::size_t index = 0;       ///< of the instance in the plan
  std::size_t run = 0;         ///< of its runs
  bool certify = true;         ///< else the row only has the drawing's hash and no verdict
  std::uint32_t warm_ups = 0;  ///< drawings before the timed one
  bool write = false;          ///< time the formatting as JSON lines
  bool restart = false;        ///< with other programs' processes than those of other repetitions
  bool bisect = true;          ///< seek the bisection of a first instance, for volume_at_least
};

/// Makes rows, one at a time: keeps the graph of one instance and draws it (timed), certifies
/// (outside that clock), measures. Nothing that goes wrong leaves it as an exception: it becomes a
/// row with a status and a message. Construct and use it in one thread.
class RowMaker {
 public:
  /// @param concurrency  rows made at the same time, with this one. @param core  that the thread is
  /// pinned to; -1: none. @param certify_memory_bytes  as the budget has it.
  explicit RowMaker(MemoryScope memory = MemoryScope::process, std::int64_t concurrency = 1,
                    std::int64_t core = -1,
                    const std::optional<LimitByVertices>& certify_memory_bytes = {});

  /// Generates or reads the instance's graph. Where that fails, every row made until the next
  /// prepare() has its status and message.
  void prepare(const PlannedInstance& instance);
  /// Does so for the instance at that index of the plan, unless it is the last one prepared.
  const PlannedInstance& prepare(const StudyPlan& plan, std::size_t index);
  /// Returns null if it could not be generated.
  const Graph* graph() const { return graph_ ? &*graph_ : nullptr; }
  /// Returns what is known of a run of the prepared instance before it is made.
  RunRecord begun(const PlannedRun& planned) const;
  /// Returns the row of a run of the prepared instance.
  RunRecord make_row(const PlannedRun& planned, const RowRequest& request = {});

 private:
  std::int64_t concurrency_, core_;
  std::optional<LimitByVertices> certify_memory_bytes_;
  HardwareCounters counters_;
  RowMemory memory_;
  std::optional<Yardsticks> yardsticks_;  ///< once a row of the timing phase was made
  std::optional<std::size_t> index_;      // in the plan
  PlannedInstance instance_;              // there
  RunRecord base_;
  std::optional<Graph> graph_;
  std::optional<GraphNeeds> needs_;  // once a row asks
  ExternalDrawer drawer_;
  std::int64_t round_ = 0;  // whose processes it holds

  Drawing draw_timed(const PlannedRun& planned, const RowRequest& request, RunRecord& run);
  void draw_and_certify(const PlannedRun& planned, const RowRequest& request, RunRecord& run);
};

/// Runs a step; what it throws becomes the row's status and message. True if it threw nothing.
bool attempt(RunRecord& run, const std::function<void()>& step);

/// Draws and writes down the time and the counted events in `run`.
Drawing timed_drawing(const Graph& graph, const AlgorithmChoice& choice, HardwareCounters& counters,
                      RunRecord& run);

/// Returns the row of a run without any result: what the plan knows of it.
RunRecord planned_row(const PlannedInstance& instance, const PlannedRun& planned);

/// Returns the row of a run that is not tried, because `failed`, a row of the same drawing, went
/// wrong.
RunRecord failed_row(const PlannedInstance& instance, const PlannedRun& planned,
                     const RunRecord& failed);

/// Gives an uncertified row the verdict and the metrics of a certified one of the same drawing.
/// A row that is not ok stays as it is; one of another drawing becomes `crashed`.
void take_over_certificate(const RunRecord& certified, RunRecord& run);

/// Returns a row as one process sends it to another: checksum, tag and record. The checksum tells
/// it from what a program under test writes into descriptors that are not its own.
std::string row_message(char tag, const RunRecord& row);
/// Returns the number of its bytes, the same for every row.
std::size_t row_message_size();
/// Reads such bytes into `row`. @return the tag; nothing if they are no message.
std::optional<char> read_row_message(std::string_view bytes, RunRecord& row);

}  // namespace ar3d
