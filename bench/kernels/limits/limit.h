#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace ar3d::kernels {

/// What a measured value is held against, for graphs of the group's n.
struct Goal {
  bool is_least = false;  ///< else the most
  double value = 0;
  std::string_view unit = "×";  ///< a literal; of the value and of what is measured
};
inline Goal at_most(double value, std::string_view unit = "×") { return {false, value, unit}; }
inline Goal at_least(double value, std::string_view unit = "×") { return {true, value, unit}; }

/// One line of the table.
struct Limit {
  std::string stage;
  std::string yardstick;
  Goal goal;
  std::string why_missed = {};  ///< what stands between the stage and its goal, where that is known
  std::optional<double> measured = {};
  std::string remark = {};  ///< times in absolute terms, or why nothing was measured
};

/// What is missing here for a measurement: a peer, or a right that the kernel refuses. The line
/// says so and the run goes on, whereas any other exception means that a row is broken.
struct NotMeasured : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What a run is asked for.
struct RunSize {
  std::uint64_t n = 0;  ///< the group's, or the smaller one that the run is bounded by
  int repetitions = 0;  ///< of everything that is timed, in turns
};

/// Lines that share their work. Every line is printed, measured or not.
struct LimitGroup {
  std::string name;
  std::uint64_t n = 0;  ///< vertices of the graph for which the goals are stated
  std::vector<Limit> limits;
  /// Fills in `measured` and `remark` of the limits. What it throws becomes the remark; a limit
  /// that is left without a value is printed as such.
  std::function<void(const RunSize&, std::vector<Limit>&)> measure;
};

// One file each.
std::vector<LimitGroup> drawing_groups();
std::vector<LimitGroup> certifying_groups();
std::vector<LimitGroup> crossing_groups();
std::vector<LimitGroup> memory_groups();
std::vector<LimitGroup> reading_groups();
std::vector<LimitGroup> generating_groups();
std::vector<LimitGroup> study_groups();
std::vector<LimitGroup> layout_groups();

/// What one thread gets from the machine's memory, measured now.
struct MemorySpeed {
  double read_gb_per_s = 0;  ///< a sum over an array that no cache holds
  double copy_gb_per_s = 0;  ///< bytes read and written
  double latency_ns = 0;     ///< a chain of dependent reads at random places
  double overlapped_ns = 0;  ///< the same, 32 chains in turns
};

/// Medians of `rounds` on arrays of `bytes` bytes.
MemorySpeed measure_memory(std::size_t bytes, int rounds);

/// Prints a table in Markdown: for every algorithm that proves its drawings, at its default effort,
/// and every family it draws, the CPU time of drawing in nanoseconds per vertex and its ratio to a
/// breadth-first search, for n = 10^3, 10^4, … up to max_n, vertices shuffled; the exponent of n
/// with which that ratio grows; and at the end the largest of them for each algorithm.
/// @param repetitions  at most.  @param only  rows ALGORITHM/FAMILY that this regular expression
/// finds.
void print_families(std::uint64_t max_n, int repetitions, const std::string& only);

}  // namespace ar3d::kernels
