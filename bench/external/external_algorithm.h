#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "ar3d/algorithms/algorithm.h"
#include "ar3d/model/graph.h"

namespace ar3d {

/// Describes one integer setting of a family or an algorithm: its name, and the values that it
/// takes in turn.
using SettingChoices = std::pair<std::string, std::vector<std::int64_t>>;

/// Describes a limit that grows with the graph.
struct LimitByVertices {
  double always = 0;
  double per_vertex = 0;  ///< more, for each vertex
  double operator()(std::uint64_t n) const { return always + per_vertex * static_cast<double>(n); }
};

/// Is a program that draws graphs: a row of the catalogue whose drawings another process makes.
struct ExternalAlgorithm {
  ExternalAlgorithm() = default;
  ExternalAlgorithm(const ExternalAlgorithm&) = delete;  // its row's `draw` refers to it
  ExternalAlgorithm& operator=(const ExternalAlgorithm&) = delete;

  /// Holds name, options, guarantee, and `draw` (external_drawer.h). Without a guarantee no degree
  /// is refused and no verdict given.
  Algorithm row;
  std::vector<SettingChoices> choices;  ///< values that its options take where a sweep names none
  std::vector<std::string> command;     ///< words; "{option}" stands for an option's value
  std::string version;             ///< as its author calls it; empty: program_version() asks git
  std::string input = "edgelist";  ///< what the program reads: graph6, sparse6 or edgelist
  std::string coordinates;  ///< float or double: its decimals are read as such; empty: exactly
  bool one_graph_per_process = false;
  LimitByVertices limit_s{60};  ///< from request to answer
};

/// Returns the words of the command with the options' values. @throws InputError on a brace that
/// encloses no option.
std::vector<std::string> command_with(const ExternalAlgorithm& algorithm, const Settings& options);

/// Returns what such a program reads for one graph: a line of graph6 or sparse6, or, as `edgelist`,
/// a line "n m" and m lines "u v" with ids from 0.
std::string request_of(const ExternalAlgorithm& algorithm, const Graph& graph);

/// Holds the hash of a program whose executable cannot be read.
inline constexpr const char* kAbsentProgram = "absent";

/// Gives XXH3-128 of what the program is made of, as far as its command shows: the contents of the
/// executable (a path, or looked up in $PATH) and of every further word that names a regular file,
/// such as a script. kAbsentProgram if the executable cannot be read. Cost: reading these files.
std::string program_hash(const ExternalAlgorithm& program);

/// Returns the version of the program that its results are kept under: the one that the study
/// names, else the commit of the git repository in which the last of the files of program_hash()
/// lies ("-dirty" behind it: with changes). Empty if there is neither.
std::string program_version(const ExternalAlgorithm& program);

}  // namespace ar3d
