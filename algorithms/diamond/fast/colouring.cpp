// Step 1.1 for large graphs: the results of the two walks of trails.h. Directions first, then
// colours, are written along the pieces of chains as marks, and read off for all edges at the end.
// Cost: O(n + m), and 25 bytes per vertex.
#include "ar3d/algorithms/diamond/fast/trails.h"
#include "ar3d/base/long_vector.h"

namespace ar3d::diamond::fast {
namespace {

/// From so many vertices on many walks at a time are faster.
constexpr Vertex kManyToColour = 1u << 12;

bool all_degrees_are_4_or_0(const Graph& graph, std::uint32_t threads) {
  std::atomic<bool> all{true};
  for_ranges_in_threads(threads, graph.num_vertices(),
                        [&](std::uint32_t, std::size_t begin, std::size_t end) {
                          bool odd = false;
                          for (auto v = static_cast<Vertex>(begin); v < end; ++v) {
                            odd |= graph.degree(v) % 4 != 0;
                          }
                          if (odd) all = false;
                        });
  return all;
}

/// balanced_orientation(), by pairs: enters(directions, port).
TwoBitMarks directions_of(const Records& records, bool all_linked, const WalkSizes& sizes) {
  TwoBitMarks directions(2 * records.size(), sizes.threads > 1);
  const auto write = [&](const TrailPiece& piece) {
    const auto enter = [&](PortNumber p, std::uint32_t in) {
      directions.set(p >> 1, in ^ (p & 1));
    };
    const TrailStretch& stretch = *piece.stretch;
    enter(stretch.start, piece.backwards);
    const std::uint32_t in = piece.backwards ? 0 : 1;
    for (std::uint32_t i = 0; i < stretch.num_kept; ++i) enter(stretch.kept[i], in);
  };
  Trails<LinkPairs> trails(records, {}, all_linked, sizes);
  trails.walk_cut(write);
  trails.walk_uncut(
      [&](std::uint32_t pair, std::uint32_t end) {
        while ((pair = directions.first_unmarked(pair, end)) < end) {
          if (records[pair >> 1][pair << 1 & 2] != kNone) return PortNumber{2 * pair};
          ++pair;
        }
        return kNoPort;
      },
      write);
  return directions;
}

/// The edges out of a vertex: by the entries first_out() and second_out(), if it has these entries.
std::uint32_t first_out(const TwoBitMarks& directions, Vertex v) { return directions.bit(2 * v); }
std::uint32_t second_out(const TwoBitMarks& directions, Vertex v) {
  return 2 + directions.bit(2 * v + 1);
}

/// The colours of two_colouring(), by vertex: whether the edge out by first_out() is red. If there
/// is a second edge out, it has the other colour.
TwoBitMarks colours_of(const Records& records, bool all_linked, const TwoBitMarks& directions,
                       const WalkSizes& sizes) {
  TwoBitMarks reds(records.size(), sizes.threads > 1);
  const auto write = [&](const TrailPiece& piece) {
    const auto colour = [&](PortNumber p, std::uint32_t c) {
      reds.set(vertex_of(p), c ^ (p >> 1 & 1));
    };
    const TrailStretch& stretch = *piece.stretch;
    const std::uint32_t leaves = enters(directions, stretch.start) ^ 1u;
    if (leaves) colour(stretch.start, piece.odd);
    // Every second edge is walked against its direction, hence all of these have one colour.
    const std::uint32_t c = piece.odd ^ leaves;
    for (std::uint32_t i = 0; i < stretch.num_kept; ++i) colour(stretch.kept[i], c);
  };
  Trails<LinkSameDirection> trails(records, {&directions}, all_linked, sizes);
  trails.walk_cut(write);
  trails.walk_uncut(
      [&](std::uint32_t v, std::uint32_t end) {
        while ((v = reds.first_unmarked(v, end)) < end) {
          const std::uint32_t entry = first_out(directions, v);
          if (records[v][entry] != kNone) return port(v, entry);
          ++v;
        }
        return kNoPort;
      },
      write);
  return reds;
}

TwoColouring edges_out(const Graph& graph, const TwoBitMarks& directions, const TwoBitMarks& reds,
                       std::uint32_t threads) {
  TwoColouring result;
  for (auto& next : result) {
    reserve_long(next, graph.num_vertices());
    next.resize(graph.num_vertices());
  }
  constexpr HalfEdge kNothing{kNone, kNone};
  const auto write = [&](Vertex v, const HalfEdge* row) {
    const std::array<HalfEdge, 2> out{row[first_out(directions, v)],
                                      row[second_out(directions, v)]};
    const std::uint32_t red = reds.bit(v);
    result[kGreen][v] = out[red];
    result[kRed][v] = out[red ^ 1u];
  };
  for_ranges_in_threads(threads, graph.num_vertices(),
                        [&](std::uint32_t, std::size_t begin, std::size_t end) {
                          for (auto v = static_cast<Vertex>(begin); v < end; ++v) {
                            const auto row = graph.incident(v);
                            if (row.size() == 4) {
                              write(v, row.data());
                              continue;
                            }
                            std::array<HalfEdge, 4> padded{kNothing, kNothing, kNothing, kNothing};
                            std::copy(row.begin(), row.end(), padded.begin());
                            write(v, padded.data());
                          }
                        });
  return result;
}

}  // namespace

TwoColouring colouring(const Graph& graph) {
  if (graph.num_vertices() >= kManyToColour) {
    const auto threads = threads_for(graph.num_vertices());
    return colouring(graph, walk_sizes(graph.num_vertices(), threads));
  }
  const PaddedNeighbours neighbours = padded_neighbours(graph);
  return two_colouring(graph, neighbours, balanced_orientation(neighbours));
}

TwoColouring colouring(const Graph& graph, const WalkSizes& sizes) {
  Records records = padded_neighbours(graph, sizes.threads);
  const bool all_linked = all_degrees_are_4_or_0(graph, sizes.threads);
  const TwoBitMarks directions = directions_of(records, all_linked, sizes);
  const TwoBitMarks reds = colours_of(records, all_linked, directions, sizes);
  records = Records();  // its memory, which the result takes
  return edges_out(graph, directions, reds, sizes.threads);
}

}  // namespace ar3d::diamond::fast
