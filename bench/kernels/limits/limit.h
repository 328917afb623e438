#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace ar3d::limits {

/// What a measured value is held against, for graphs of the group's n.
struct Goal {
  enum class Kind { at_most, at_least };
  Kind kind = Kind::at_most;
  double value = 0;
  std::string_view unit = "×";  ///< a literal; of the value and of what is measured
};

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
struct Scale {
  std::uint64_t n = 0;  ///< the group's, or the smaller one that the run is bounded by
  int repetitions = 0;  ///< of everything that is timed, in turns
};

/// Lines that share their work. Every line is printed, measured or not.
struct Group {
  std::string name;
  std::uint64_t n = 0;  ///< vertices of the graph for which the goals are stated
  std::vector<Limit> limits;
  /// Fills in `measured` and `remark` of the limits. What it throws becomes the remark; a limit
  /// that is left without a value is printed as such.
  std::function<void(const Scale&, std::vector<Limit>&)> measure;
};

// One file each.
std::vector<Group> drawing_groups();
std::vector<Group> certifying_groups();
std::vector<Group> crossing_groups();
std::vector<Group> memory_groups();
std::vector<Group> reading_groups();
std::vector<Group> generating_groups();
std::vector<Group> study_groups();
std::vector<Group> layout_groups();

}  // namespace ar3d::limits
