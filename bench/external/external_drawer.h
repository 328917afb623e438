#pragma once

#include <map>
#include <memory>
#include <string>

#include "ar3d/bench/external/external_algorithm.h"
#include "ar3d/bench/external/external_process.h"
#include "ar3d/bench/external/program_answer.h"

namespace ar3d {

/// What a program has drawn and how long it took.
struct ExternalDrawing {
  Drawing drawing;
  double wall_s = 0;  ///< from request to answer
  double cpu_s = 0;   ///< the program's own time if it says so, else the CPU time of its process
};

/// Keeps a process for each external program with its options and has it draw graph after graph. A
/// new process first draws a single edge, so that starting it is timed with no graph (unless it
/// takes one graph only), and is listened to for 20 ms behind that answer and the next, lest it
/// write second lines. To be used by one thread.
class ExternalDrawer {
 public:
  /// @throws ProgramFailure as ExternalProcess, and `crashed` if the answer is no drawing of the
  /// graph; InputError if the program refuses the graph. After a failure the process is replaced.
  ExternalDrawing draw(const ExternalAlgorithm& algorithm, const Settings& options,
                       const Graph& graph);

 private:
  std::map<std::string, std::unique_ptr<ExternalProcess>> processes_;  // by command
};

}  // namespace ar3d
