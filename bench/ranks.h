#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace ar3d {

/// Gives out the next ticket, each once over all ranks; called by several threads at once.
using Tickets = std::function<std::optional<std::size_t>()>;

/// Does a job that was made ready, and tells about it.
using Work = std::function<std::string()>;
/// Makes a job ready: whatever is not to be timed.
using MakeReady = std::function<Work(const std::string& job)>;

/// The processes that make one study together. This class is a process that is alone; the program
/// for mpirun has another (apps/mpi/mpi_ranks.cpp). What several ranks do together, all of them
/// have to call.
class Ranks {
 public:
  virtual ~Ranks() = default;
  virtual int rank() const { return 0; }
  virtual int size() const { return 1; }
  bool is_first() const { return rank() == 0; }

  /// The text of rank 0.
  virtual std::string from_first(const std::string& text) { return text; }
  /// The text of the first rank that has any. No rank returns before all have come.
  virtual std::string any_of(const std::string& text) { return text; }

  /// Calls `use` on every rank with tickets for 0 .. work.size() - 1, roughly in this order;
  /// work[i] is what ticket i costs in any unit. The tickets of a process that is alone are empty:
  /// it may take all in any order.
  virtual void share_out(const std::vector<double>& work,
                         const std::function<void(const Tickets&)>& use) {
    (void)work;
    use({});
  }

  /// On rank 0: ranks 0 .. count - 1 make a job ready, wait for each other, and do it at the same
  /// time. Returns what they tell, rank by rank; the others are in help() meanwhile.
  /// @throws InternalError what went wrong at one of them. @pre count <= size().
  virtual std::vector<std::string> at_once(int count, const std::string& job,
                                           const MakeReady& make_ready) {
    (void)count;
    return {make_ready(job)()};
  }
  /// On the others: does the jobs of rank 0 until it calls dismiss().
  virtual void help(const MakeReady& make_ready) { (void)make_ready; }
  virtual void dismiss() {}
};

}  // namespace ar3d
