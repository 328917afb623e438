#pragma once

#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ar3d/base/new_file.h"
#include "ar3d/base/system_calls.h"
#include "ar3d/bench/external/external_algorithm.h"
#include "ar3d/model/drawing.h"
#include "ar3d/store/columns/run_record.h"

namespace ar3d {

/// Holds how an external program failed: the status and the message of its row.
class ProgramFailure : public std::runtime_error {
 public:
  ProgramFailure(RunStatus status, const std::string& message)
      : std::runtime_error(message), status_(status) {}
  RunStatus status() const { return status_; }

 private:
  RunStatus status_;
};

/// Holds what a program answers to one graph.
struct ProgramAnswer {
  std::optional<Drawing> drawing;                           ///< its edges are the graph's
  std::string refusal;                                      ///< why it draws none: {"error": "…"}
  double own_s = std::numeric_limits<double>::quiet_NaN();  ///< its own time, if it says so
};

/// Reads one line: a drawing in JSON lines as this program writes them (integers and a Gram
/// matrix), or
///   {"vertices":[[x,y,z],…],"edges":[[u,v,[[x,y,z],…]],…],"seconds":s}
/// with any decimal numbers: vertices in order, bends of an edge from u to v, all straight where
/// `edges` is left out, z = 0 where it is; `seconds` may be left out, too. A finite decimal is an
/// exact rational: all are multiplied by the least power of ten that makes them integers, the
/// drawing's unit, whose exponent the counter `decimals` tells.
/// @param type  "float" or "double": each decimal becomes the nearest value of it, and the drawing
/// is one in that real type (ties to even).
/// @throws InputError if it is none of this, or no drawing of that graph; if a number has more than
/// 18 significant digits, an integer passes kMaxCoordinate, or a number the range of the type.
ProgramAnswer parse_answer(const std::string& algorithm, const Graph& graph, std::string_view line,
                           const std::string& type = {});

/// Represents a program that answers each request with one line. It ends with this object.
class ExternalProcess {
 public:
  /// @throws ProgramFailure if it cannot be run.
  explicit ExternalProcess(const std::vector<std::string>& command);

  struct Answer {
    std::string line;   ///< without its end
    double wall_s = 0;  ///< from the first byte of the request to the last of the line
    double cpu_s = 0;   ///< CPU time of the program's process meanwhile; NaN if it has ended
  };
  /// @param limit_s  wall time.  @param most_bytes  of the line.
  /// @throws ProgramFailure: timeout if there is no line in time; crashed if the program ends
  /// before, answers more than it was asked for or a longer line. It is not to be asked again then.
  Answer ask(const std::string& request, double limit_s, std::size_t most_bytes);

  /// Waits so long for output that was not asked for. @throws ProgramFailure (crashed) if there is
  /// some. `ask` looks, too, without waiting.
  void refuse_second_lines(double wait_s);

 private:
  bool read_output(std::size_t most_bytes);  // false at its end
  bool read_errors();                        // false at their end
  void write_request(const std::string& request, std::size_t& written);
  std::string how_it_ended();

  Child child_;
  Descriptor input_;
  Descriptor output_;
  Descriptor errors_;
  std::string received_;
  std::size_t searched_ = 0;  // of received_, for the end of the line
  std::string last_errors_;   // the last few hundred bytes
  bool errors_ended_ = false;
};

/// While it lives, it keeps a process for each program, with its options, that this thread has draw
/// (ExternalAlgorithm::row), and the process draws graph after graph. A new one first draws a single
/// edge, so that starting it is timed with no graph (unless it takes one graph only), and is
/// listened to for 20 ms behind that answer and the next, lest it write second lines. The last one
/// that began counts; without any a process draws a single graph.
class ExternalDrawer {
 public:
  ExternalDrawer();
  ~ExternalDrawer();
  ExternalDrawer(const ExternalDrawer&) = delete;
  ExternalDrawer& operator=(const ExternalDrawer&) = delete;

  /// Returns, once, what the last drawing took, without its line: wall time from request to answer,
  /// and as CPU time the program's own time if it says so, else that of its process. Nothing if no
  /// program has drawn since.
  std::optional<ExternalProcess::Answer> take_times() {
    return std::exchange(times_, std::nullopt);
  }

  /// Draws as the algorithm's row does, in the thread's processes.
  /// @throws ProgramFailure as ExternalProcess, and `crashed` if the answer is no drawing of the
  /// graph; InputError if the program refuses the graph. After a failure the process is replaced.
  static Drawing draw(const ExternalAlgorithm& algorithm, const Graph& graph,
                      const Settings& options);

  /// Ends its processes: the next drawing of each program is made by a new one.
  void restart() { processes_.clear(); }

 private:
  std::map<std::string, std::unique_ptr<ExternalProcess>> processes_;  // by command
  std::optional<ExternalProcess::Answer> times_;
  ExternalDrawer* const before_;
};

}  // namespace ar3d
