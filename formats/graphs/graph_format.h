#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ar3d/formats/text/output.h"
#include "ar3d/formats/text/text_input.h"
#include "ar3d/model/graph.h"

namespace ar3d {

/// Says what the first line of an edge list is, where it has two numbers: the number of vertices
/// and of edges, or an edge. `automatic`: a header where it cannot be an edge, an edge where it
/// cannot be a header; where it can be both the file is refused.
enum class FirstLine { automatic, edge, header };

struct ReadOptions {
  std::string format = {};  ///< name of a format; empty: detected by content
  unsigned base = 0;        ///< smallest vertex id in edge lists and adjacency lists, 0 or 1
  FirstLine first_line = FirstLine::automatic;
  bool simplify = false;    ///< loops and parallel edges are dropped; else they are refused
  bool undirected = false;  ///< arcs are read as edges; else they are refused
  /// A graph may have this many vertices plus 16 per byte of its text; what claims more is refused,
  /// so that a few bytes cannot claim gigabytes.
  std::uint64_t free_vertices = std::uint64_t{1} << 20;
};

/// Reads the graphs of one input in one format, one after the other.
class GraphParser {
 public:
  GraphParser(TextInput& input, const ReadOptions& options) : input_(input), options_(options) {}
  GraphParser(const GraphParser&) = delete;
  GraphParser& operator=(const GraphParser&) = delete;
  virtual ~GraphParser() = default;
  /// The next graph; nothing at the end. @throws InputError naming file, line, column and value.
  virtual std::optional<Graph> next() = 0;
  /// The vertices' names in the graph just given; empty if the file has none but numbers.
  virtual std::vector<std::string> names() const { return {}; }

 protected:
  TextInput& input_;
  ReadOptions options_;  // a copy: the caller's may be a temporary
};

/// Writes a graph behind those before it; does not commit the output.
using GraphWriter = std::function<void(const Graph&)>;

/// The first bytes of an input, for detection.
struct InputHead {
  std::string_view text;
  bool whole = false;  ///< the text is all there is
  /// The file's ending says "edge list", which lines of numbers alone do not tell from METIS.
  bool is_named_edge_list = false;
};

/// Does the file's ending say "edge list"? ".txt" says nothing.
bool is_named_edge_list(const std::string& name);

/// One row of the catalogue of graph formats. Every format holds many graphs a file.
struct GraphFormat {
  std::string name;
  std::vector<std::string> extensions;  ///< with the dot
  std::string summary;                  ///< one sentence
  /// True if the text looks like this format; asked in the catalogue's order.
  bool (*detect)(const InputHead& head) = nullptr;
  std::unique_ptr<GraphParser> (*parser)(TextInput& input, const ReadOptions& options) = nullptr;
  /// @param base  smallest vertex id in edge lists and adjacency lists, 0 or 1.
  GraphWriter (*writer)(OutputFile& output, unsigned base) = nullptr;
  std::string tail = {};  ///< what stands after the last graph
};

/// Makes a format's parsers, for its row of the catalogue.
template <class Parser>
std::unique_ptr<GraphParser> make_parser(TextInput& input, const ReadOptions& options) {
  return std::make_unique<Parser>(input, options);
}
/// A writer that only appends, graph by graph.
template <void (*append)(OutputFile& output, const Graph& graph, unsigned base)>
GraphWriter make_appending(OutputFile& output, unsigned base) {
  return [&output, base](const Graph& graph) { append(output, graph, base); };
}

/// Append vertices, or edges, each between the texts `around` its numbers.
void append_vertices(OutputFile& output, const Graph& graph,
                     const std::array<std::string_view, 2>& around);
void append_edges(OutputFile& output, const Graph& graph,
                  const std::array<std::string_view, 3>& around, unsigned base = 0);

/// The names, or none if they are just the numbers from 0, or n and these.
std::vector<std::string> telling_names(std::vector<std::string> names);

/// Drops loops, and of parallel edges all but one; what stays is ordered by (u, v), u < v.
/// O(m log m).
void simplify(std::vector<Edge>& edges);

/// Why a graph of n vertices written in `bytes` bytes is refused: more vertices than 32-bit ids, or
/// far more than its text can account for. Nothing if it is accepted.
std::optional<std::string> vertex_count_problem(std::uint64_t n, std::uint64_t bytes,
                                                const ReadOptions& options);

}  // namespace ar3d
