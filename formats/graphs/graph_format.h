#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ar3d/formats/graphs/read_options.h"
#include "ar3d/formats/text/output.h"
#include "ar3d/formats/text/text_input.h"
#include "ar3d/model/graph.h"

namespace ar3d {

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
  /// What has been assumed since the last call, a line each: "FILE:LINE: ids are from 1".
  std::vector<std::string> take_notes() { return std::exchange(notes_, {}); }

 protected:
  /// Notes what has been assumed; line 0: of the whole file.
  void note(std::uint64_t line, const std::string& text) {
    constexpr std::size_t kMost = 8;
    if (notes_.size() == kMost) return;  // a line a graph says no more
    notes_.push_back(line == 0 ? fmt::format("{}: {}", input_.name(), text)
                               : fmt::format("{}:{}: {}", input_.name(), line, text));
  }

  TextInput& input_;
  ReadOptions options_;  // a copy: the caller's may be a temporary

 private:
  std::vector<std::string> notes_;
};

/// Writes a graph behind those before it; does not commit the output.
using GraphWriter = std::function<void(const Graph&)>;

/// The first bytes of an input, for detection.
struct InputHead {
  std::string_view text;
  bool whole = false;  ///< the text is all there is
  /// The format that the file's ending says, which decides where the content leaves a choice.
  std::string_view ending = {};
  bool is_list = false;  ///< options of lists are given: no other format of numbers is meant
  std::string_view body = text;  ///< from the first line on that is neither blank nor a comment
};

/// The name of the format that the file's ending says; empty if it says none, as ".txt".
std::string_view told_format(std::string_view name);

/// What stands behind blanks and comments (#, //, "% " and /* */).
std::string_view first_text(std::string_view text);

/// @throws InputError where the text is no graph but what stands in its place (a page of HTML, an
/// archive, a pointer of git-lfs), or of a format that others read, with what converts it; by the
/// ending alone not if the format is forced.
void refuse_foreign(TextInput& input, bool is_forced);

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

/// Why that text is no name of a vertex: a control character, or bytes that are no UTF-8.
std::optional<std::string> name_problem(std::string_view text);

/// Drops loops, and of parallel edges all but one; what stays is ordered by (u, v), u < v.
/// O(m log m).
void simplify(std::vector<Edge>& edges);

/// Why a graph of n vertices written in `bytes` bytes is refused: more vertices than 32-bit ids, or
/// far more than its text can account for. Nothing if it is accepted.
std::optional<std::string> vertex_count_problem(std::uint64_t n, std::uint64_t bytes,
                                                const ReadOptions& options);

}  // namespace ar3d
