#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace ar3d {

/// Gives out the next ticket, each once over all ranks; called by several threads at once.
using Tickets = std::function<std::optional<std::size_t>()>;

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
};

}  // namespace ar3d
