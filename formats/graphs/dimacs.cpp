// DIMACS: "p edge N M" or "p col N M" with lines "e u v"; "p sp N M" with arcs "a u v [weight]"
// both ways. Reference: igraph (Read_DIMACS) for "p edge"; the 9th DIMACS challenge has "p sp".
#include <fmt/format.h>

#include <limits>

#include "ar3d/formats/graphs/arc_collector.h"
#include "ar3d/formats/graphs/edge_collector.h"
#include "ar3d/formats/text/output.h"
#include "ar3d/formats/text/tokens.h"

namespace ar3d {
namespace {

class DimacsParser final : public GraphParser {
 public:
  DimacsParser(TextInput& input, const ReadOptions& options)
      : GraphParser(input, options), edges_(input, options, 1), arcs_(input, options, 1) {}

  std::optional<Graph> next() override {
    if (!read_problem()) return std::nullopt;
    arcs_.begin(with_arcs_ ? announced_ : 0);
    if (!with_arcs_) edges_.expect_edges(announced_);
    while (const std::optional<std::string_view> line = next_odd_line()) {
      if (is_blank(*line)) continue;
      Tokens tokens(input_, *line);
      const std::string_view kind = tokens.word();
      if (kind == "c") continue;
      if (kind == "p") {
        input_.put_back();
        break;
      }
      read_line(tokens, kind);
    }
    const std::uint64_t found = with_arcs_ ? arcs_.num_arcs() : edges_.num_edges();
    if (found != announced_) {
      input_.fail(0, fmt::format("{} {} announced, found {}", announced_,
                                 with_arcs_ ? "arcs" : "edges", found));
    }
    if (with_arcs_) return arcs_.finish(edges_.checked_n());
    return edges_.finish();
  }

 private:
  /// Reads up to the line "p …" and begins its graph; false at the end of the text.
  bool read_problem() {
    while (const std::optional<std::string_view> line = input_.next_line()) {
      if (is_blank(*line)) continue;
      Tokens tokens(input_, *line);
      const std::string_view kind = tokens.word();
      if (kind == "c") continue;
      if (kind != "p") tokens.fail(fmt::format("expected 'p', found {}", shown(kind)));
      const std::string_view problem = tokens.word();
      if (problem != "edge" && problem != "col" && problem != "sp") {
        tokens.fail(fmt::format("only 'edge', 'col' and 'sp' are supported here, found {}",
                                shown(problem)));
      }
      with_arcs_ = problem == "sp";
      const std::uint64_t n = tokens.number("a number of vertices");
      announced_ = tokens.number("a number of edges");
      tokens.expect_done("the sizes");
      edges_.begin(n);
      return true;
    }
    return false;
  }

  /// The next line that is not read as one of many plain edges.
  std::optional<std::string_view> next_odd_line() {
    constexpr std::uint64_t kAll = std::numeric_limits<std::uint64_t>::max();
    if (!with_arcs_) edges_.read_plain_edges(input_, "e ", kAll);
    return input_.next_line();
  }

  void read_line(Tokens& tokens, std::string_view kind) {
    if (kind != (with_arcs_ ? "a" : "e")) {
      tokens.fail(
          fmt::format("expected 'c' or '{}', found {}", with_arcs_ ? 'a' : 'e', shown(kind)));
    }
    const Edge ends = edges_.read_ends(tokens);
    if (with_arcs_) {
      if (!tokens.done()) tokens.number("a weight");  // lengths mean nothing here
      arcs_.add(ends.u, ends.v, input_.line());
    } else {
      edges_.add(ends.u, ends.v);
    }
    tokens.expect_done("the edge");
  }

  EdgeCollector edges_;
  ArcCollector arcs_;
  bool with_arcs_ = false;
  std::uint64_t announced_ = 0;
};

void append_dimacs(OutputFile& output, const Graph& graph, unsigned) {
  std::string& out = output.pending();
  out += fmt::format("p edge {} {}\n", graph.num_vertices(), graph.num_edges());
  append_edges(output, graph, {"e ", " ", "\n"}, 1);
}

/// A first line "c …" or "p …", and somewhere "p WORD NUMBER".
bool looks_like_dimacs(const InputHead& head) {
  const std::size_t first = head.body.find_first_not_of(" \t");
  const std::string_view text = head.body.substr(std::min(first, head.body.size()));
  if (text.size() < 2 || (text[0] != 'c' && text[0] != 'p')) return false;
  if (std::string_view(" \t\r\n").find(text[1]) == std::string_view::npos) return false;
  if (head.ending == "dimacs") return true;
  for (std::size_t at = 0; at < text.size();
       at = std::min(text.find('\n', at), text.size() - 1) + 1) {
    const std::string_view line = text.substr(at, text.find('\n', at) - at);
    const std::size_t number = line.find_first_of("0123456789");
    if (line.starts_with("p ") && number != std::string_view::npos && line[number - 1] == ' ') {
      return line.substr(2, number - 3).find_first_of(" \t") == std::string_view::npos;
    }
  }
  return false;
}

}  // namespace

GraphFormat dimacs_format() {
  return {.name = "dimacs",
          .extensions = {".dimacs", ".col", ".gr"},
          .summary = "DIMACS: \"p edge N M\" and lines \"e u v\", 1-based",
          .detect = looks_like_dimacs,
          .parser = make_parser<DimacsParser>,
          .writer = make_appending<append_dimacs>};
}

}  // namespace ar3d
