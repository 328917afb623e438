// The formats of nauty and its relatives (https://users.cecs.anu.edu.au/~bdm/data/formats.txt):
// one graph per line of printable characters. A file may mix the kinds of lines: whichever of the
// formats is chosen, ':' begins sparse6, ';' incremental sparse6, '&' digraph6, everything else
// graph6.
#include <fmt/format.h>

#include <utility>

#include "ar3d/base/error.h"
#include "ar3d/formats/graphs/graph6.h"
#include "ar3d/formats/graphs/graph_format.h"
#include "ar3d/formats/text/tokens.h"

namespace ar3d {
namespace {

class NautyParser final : public GraphParser {
 public:
  using GraphParser::GraphParser;

  std::optional<Graph> next() override {
    while (const std::optional<std::string_view> line = input_.next_line()) {
      const std::size_t begin = after_header(*line);
      if (!is_blank(line->substr(begin)) && !is_comment(*line)) return decode(*line, begin);
    }
    return std::nullopt;
  }

 private:
  /// Returns where the graph begins: behind a header such as ">>graph6<<", which files that have
  /// been joined have in the middle, too.
  std::size_t after_header(std::string_view line) const {
    if (!line.starts_with(">>")) return 0;
    for (const std::string_view header : {">>graph6<<", ">>sparse6<<", ">>digraph6<<"}) {
      if (line.starts_with(header)) return header.size();
    }
    input_.fail(
        1, fmt::format("unknown header {}, expected '>>graph6<<' or '>>sparse6<<'", shown(line)));
  }

  Graph decode(std::string_view line, std::size_t begin) {
    auto [n, edges] = decode_line(line, begin);
    if (options_.simplify) simplify(edges);
    try {
      Graph graph(n, std::move(edges));
      previous_n_ = n;
      previous_ = graph.shared_edges();
      return graph;
    } catch (const EdgeError& error) {
      input_.fail(0, error.what());
    }
  }

  EdgesOnVertices decode_line(std::string_view line, std::size_t begin) const {
    switch (line[begin]) {
      case ':':
        return decode_sparse6({input_, line, begin + 1}, options_);
      case ';':
        if (previous_ == nullptr)
          input_.fail(begin + 1, "an incremental line without a graph before it");
        return decode_incremental_sparse6({input_, line, begin + 1}, previous_n_, *previous_);
      case '&':
        if (options_.undirected) return decode_digraph6({input_, line, begin + 1}, options_);
        input_.fail(begin + 1,
                    "this is digraph6: only undirected graphs are read (--undirected drops "
                    "directions)");
      default:
        return decode_graph6({input_, line, begin}, options_);
    }
  }

  std::uint64_t previous_n_ = 0;
  std::shared_ptr<const std::vector<Edge>> previous_;  // of the last graph, for incremental lines
};

void write_graph6(OutputFile& output, const Graph& graph, unsigned) {
  append_graph6(output.pending(), graph);
  output.flush_if_full();
}

void write_sparse6(OutputFile& output, const Graph& graph, unsigned) {
  append_sparse6(output.pending(), graph, [&] { output.flush_if_full(); });
  output.flush_if_full();
}

/// The first graph of each size in sparse6, the others as changes.
GraphWriter incremental_writer(OutputFile& output, unsigned) {
  return [&output, previous = std::optional<Graph>()](const Graph& graph) mutable {
    if (previous && previous->num_vertices() == graph.num_vertices()) {
      append_incremental_sparse6(output.pending(), *previous, graph);
    } else {
      write_sparse6(output, graph, 0);
    }
    previous = graph;
    output.flush_if_full();
  };
}

/// The first line is one word that begins with a character of graph6 (so it is not made of
/// numbers).
bool looks_like_graph6(const InputHead& head) {
  if (head.body.starts_with(">>")) return !head.body.starts_with(">>sparse6");
  const std::string_view line = head.body.substr(0, head.body.find_first_of("\r\n"));
  return !line.empty() && ((line[0] >= '?' && line[0] <= '~') || line[0] == '&') &&
         line.find_first_of(" \t,;") == std::string_view::npos && head.ending != "adjlist";
}

bool is_one_word(std::string_view body) {
  return body.substr(0, body.find_first_of("\r\n")).find_first_of(" \t") == std::string_view::npos;
}

bool looks_like_sparse6(const InputHead& head) {
  return head.body.starts_with(">>sparse6") ||
         (head.body.starts_with(':') && is_one_word(head.body));
}

/// A first line that is an increment has nothing to change; the parser says so.
bool looks_like_increment(const InputHead& head) {
  return head.body.starts_with(';') && is_one_word(head.body);
}

}  // namespace

GraphFormat graph6_format() {
  return {.name = "graph6",
          .extensions = {".g6"},
          .summary = "nauty's format for small or dense graphs, one graph per line",
          .detect = looks_like_graph6,
          .parser = make_parser<NautyParser>,
          .writer = make_appending<write_graph6>};
}

GraphFormat sparse6_format() {
  return {.name = "sparse6",
          .extensions = {".s6"},
          .summary = "nauty's format for sparse graphs, one graph per line",
          .detect = looks_like_sparse6,
          .parser = make_parser<NautyParser>,
          .writer = make_appending<write_sparse6>};
}

GraphFormat incremental_sparse6_format() {
  return {.name = "isparse6",
          .extensions = {".is6"},
          .summary = "incremental sparse6: each graph as its difference from the one before",
          .detect = looks_like_increment,
          .parser = make_parser<NautyParser>,
          .writer = incremental_writer};
}

}  // namespace ar3d
