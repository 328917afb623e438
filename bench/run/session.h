#pragma once

#include <chrono>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "ar3d/bench/plan/plan.h"
#include "ar3d/bench/run/ranks.h"
#include "ar3d/store/rows.h"

namespace ar3d {

/// Holds how the rows of a plan are made: what the user and the other processes decide. What the
/// study itself decides, timing rules and budget, is in its plan.
struct SessionPolicy {
  int workers = 1;            ///< rows made at the same time in the metrics phase (workers_for)
  int workers_elsewhere = 0;  ///< workers of the study's other processes in the metrics phase
  bool isolate = false;       ///< each row in a worker process; so it is too where rows have limits
  bool force_timing = false;  ///< time even in a build whose times are worth little
  bool metrics_phase = true;  ///< false: its rows are made elsewhere
  bool timed_phases = true;   ///< false: so are those of the other phases
  Ranks* ranks = nullptr;     ///< that batches are shared by; null: this process is alone
  std::FILE* progress = nullptr;  ///< where to tell how far it is; null: nowhere
  std::string name = {};          ///< of the study, for the progress
};

/// Returns the workers of one process: as many as asked for; if 0 was, one for each core, or one
/// for each of several ranks. The only place where that is decided.
int workers_for(int asked, int ranks = 1);

/// Holds where the rows of a plan go, and which are there already.
struct RowSink {
  /// Takes a new row and its index in the plan, one call at a time. What it throws ends the session
  /// and is thrown again there.
  std::function<void(std::size_t index, const RunRecord& row)> add;
  /// Records an entry of the session's environment; may be empty.
  std::function<void(const EnvironmentEntry&)> note = {};
  /// Holds rows that are not to be made, in the order of their keys; null: there are none.
  const Rows* there = nullptr;
};

/// @throws InputError if the plan has timed rows and this build's times are worth little, if a
/// memory limit is asked of a sanitised build, or if there are fewer cores than timed drawings at
/// the same time, or fewer ranks than are to share a batch.
void require_possible(const StudyPlan& plan, const SessionPolicy& policy);

/// Makes the rows of a plan that the sink does not have, phase after phase: metrics, timing, strong
/// and weak scaling; keeps none of them. What goes wrong with a row is its status. In strong and
/// weak batches rows are not isolated; they are only made of drawings that came out before.
/// @throws InputError as require_possible; whatever the sink throws.
void run_session(const StudyPlan& plan, const SessionPolicy& policy, const RowSink& sink);

/// Returns what makes a rank's part of a batch ready, for Ranks::help on all ranks but the first.
/// @param plan  the same on every rank; outlives what is returned.
/// @param stop  asked before every drawing of this process, by several threads at once; once it is
/// true, a batch has rows that were not drawn.
MakeReady batch_parts(const StudyPlan& plan, int rank, const std::function<bool()>& stop);

/// Returns "2026-01-02T03:04:05.678901+00:00".
std::string time_with_zone(
    std::chrono::system_clock::time_point time = std::chrono::system_clock::now());

/// Returns the tables that stand beside a study's rows: its algorithms, files and their graphs.
/// @throws InputError as corpora_of.
std::vector<StoredTable> side_tables_of(const Study& study);

/// Returns everything about a study's results but its rows: name, specification, source,
/// environment, time.
/// @param workers  of the process, for the environment. @throws InputError as corpora_of, and if
/// the executable of a program cannot be read.
Results describe_study(const Study& study, int workers);

/// Requires that rows of one study are of one program each. @param before  of earlier sessions.
/// @param results  for messages. @throws InputError naming a program whose hash is another one now.
void refuse_changed_programs(const StudySpec& spec, const std::vector<EnvironmentEntry>& before,
                             const std::string& results);

/// @throws InputError naming the first program of the study that cannot be run.
void require_programs(const StudySpec& spec);

}  // namespace ar3d
