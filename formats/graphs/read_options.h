#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace ar3d {

/// Says what the first line of an edge list is, where it has two numbers: the number of vertices
/// and of edges, or an edge. `automatic`: a header where it cannot be an edge, an edge where it
/// cannot be a header; where it can be both the file is refused.
enum class FirstLine { automatic, edge, header };

struct ReadOptions {
  std::string format = {};  ///< name of a format; empty: detected by content
  /// Smallest vertex id in edge lists and adjacency lists, 0 or 1; nothing: the list decides.
  std::optional<unsigned> base = {};
  FirstLine first_line = FirstLine::automatic;
  bool simplify = false;    ///< loops and parallel edges are dropped; else they are refused
  bool undirected = false;  ///< arcs are read as edges; else they are refused
  /// A graph may have this many vertices plus 16 per byte of its text; what claims more is refused,
  /// so that a few bytes cannot claim gigabytes.
  std::uint64_t free_vertices = std::uint64_t{1} << 20;
};

}  // namespace ar3d
