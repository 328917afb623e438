#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/bench/measure/instruments.h"

namespace ar3d {

/// Gives the result of a job.
using GetResult = std::function<std::string()>;
/// Makes a job ready, whatever is not to be timed. What it returns is timed.
using MakeReady = std::function<std::function<GetResult()>(const std::string& job)>;

/// Represents the processes that make one study together. This class is a process that is alone;
/// the program for mpirun has another (apps/mpi/mpi_ranks.cpp). What several ranks do together, all
/// of them have to call.
class Ranks {
 public:
  virtual ~Ranks() = default;
  virtual int rank() const { return 0; }
  virtual int size() const { return 1; }
  bool is_first() const { return rank() == 0; }

  /// Returns the text of rank 0.
  virtual std::string from_first(const std::string& text) { return text; }
  /// Returns the failure of the first rank that has one; empty if none has. No rank returns before
  /// all have come.
  virtual std::string agree(const std::string& failure) { return failure; }
  /// Waits until all ranks have come.
  void barrier() { agree(""); }

  /// Has, on rank 0, ranks 0 .. count - 1 make a job ready, wait for each other, and do it at the
  /// same time, by rank 0's clock; the others are in serve() meanwhile.
  /// @return wall time from the word to begin to the news that the last is done, and the results,
  /// rank by rank. @throws InternalError what went wrong at one of them. @pre count <= size().
  virtual std::pair<double, std::vector<std::string>> at_once(int count, const std::string& job,
                                                              const MakeReady& make_ready) {
    (void)count;
    const std::function<GetResult()> work = make_ready(job);
    const Stopwatch time;
    const GetResult get_result = work();
    const double wall_s = time.seconds();
    return {wall_s, {get_result()}};
  }
  /// Does, on the others, the jobs of rank 0 until it calls stop_serving().
  virtual void serve(const MakeReady& make_ready) { (void)make_ready; }
  virtual void stop_serving() {}

  /// Ends all of several ranks, since the others may wait for ever for this one, which has failed
  /// on its own and said why. Where it is alone, nothing happens.
  virtual void abort_all(int exit_code) { (void)exit_code; }

  bool have_failed = false;  ///< in a step that all do together: all of several ranks know it
};

/// Does a step on all ranks; an InputError of one, or JournalFull, is one of all: each throws it, and
/// have_failed says so. What else is thrown is the rank's own: its caller ends them all
/// (Ranks::abort_all).
void together(Ranks& ranks, const std::function<void()>& step);

/// Returns the processes that mpirun has started; in the program that is not made for it, this
/// process alone. It is the program's own (apps/one_rank.cpp, apps/mpi/mpi_ranks.cpp).
std::unique_ptr<Ranks> join_ranks();

}  // namespace ar3d
