// DOT of Graphviz: undirected graphs, with subgraphs as ends of edges; attributes and ports are
// read over. Not by Boost.Graph's reader, which names no line, recurses with its input, and reads
// one graph a file.
#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <string>

#include "ar3d/formats/graphs/word_text.h"
#include "ar3d/formats/text/tokens.h"

namespace ar3d {
namespace {

constexpr std::size_t kDeepest = 200;  // subgraphs in subgraphs

class DotParser final : public GraphParser {
 public:
  DotParser(TextInput& input, const ReadOptions& options)
      : GraphParser(input, options), words_(input, true) {}

  std::optional<Graph> next() override {
    if (words_.peek().kind == TextWord::Kind::end) return std::nullopt;
    const bool is_strict = is_keyword("strict");
    if (is_strict) words_.next();
    const bool is_directed = is_keyword("digraph");
    if (is_directed && !options_.undirected) {
      fail("only undirected graphs are read (--undirected drops directions), not");
    }
    if (!is_directed && !is_keyword("graph")) fail("expected graph, found");
    words_.next();
    if (words_.peek().is_name()) words_.next();
    words_.expect_mark("{", "behind graph");
    graph_ = GatheredGraph();
    read_statements(0);
    return graph_.finish(options_, is_strict,
                         [&](std::size_t at, const std::string& why) { words_.fail(at, why); });
  }
  std::vector<std::string> names() const override { return graph_.names(); }

 private:
  bool is_keyword(std::string_view keyword) {
    return words_.peek().kind == TextWord::Kind::plain &&
           boost::algorithm::iequals(words_.peek().text, keyword);
  }
  [[noreturn]] void fail(const std::string& problem) {
    words_.fail(words_.peek().at, fmt::format("{} {}", problem, shown(words_.peek().text)));
  }

  /// Behind a {, up to its }. @return the vertices that stand there.
  std::vector<Vertex> read_statements(std::size_t depth) {
    std::vector<Vertex> all;
    while (!words_.peek().is("}")) {
      if (words_.peek().is(";") || words_.peek().is(",")) {
        words_.next();
        continue;
      }
      if (is_keyword("graph") || is_keyword("node") || is_keyword("edge")) {
        words_.next();
        if (!words_.peek().is("[")) fail("expected [, found");
        read_attributes(std::nullopt);
        continue;
      }
      const std::vector<Vertex> here = read_chain(depth);
      all.insert(all.end(), here.begin(), here.end());
    }
    words_.next();
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  /// A vertex, an edge "a -- b -- {c d}", or "name = value".
  std::vector<Vertex> read_chain(std::size_t depth) {
    std::vector<Vertex> ends = read_end(depth, true);
    std::vector<Vertex> all = ends;
    while (words_.peek().is("--") || (options_.undirected && words_.peek().is("->"))) {
      const std::size_t at = words_.next().at;
      const std::vector<Vertex> others = read_end(depth, false);
      // Two subgraphs of a few bytes must not claim gigabytes.
      const std::uint64_t edges = graph_.num_edges() + std::uint64_t{ends.size()} * others.size();
      if (vertex_count_problem(edges, at, options_)) {
        words_.fail(at, fmt::format("{} edges claimed by {} bytes", edges, at));
      }
      for (const Vertex u : ends) {
        for (const Vertex v : others) graph_.join(u, v, at);
      }
      all.insert(all.end(), others.begin(), others.end());
      ends = others;
    }
    if (words_.peek().is("->")) fail("only undirected edges are read, not");
    if (words_.peek().is("[")) {
      read_attributes(all.size() == 1 ? std::optional(all[0]) : std::nullopt);
    }
    return all;
  }

  std::vector<Vertex> read_end(std::size_t depth, bool may_be_setting) {
    const bool is_subgraph = is_keyword("subgraph");
    if (is_subgraph) {
      words_.next();
      if (words_.peek().is_name()) words_.next();
    }
    if (words_.peek().is("{")) {
      if (depth == kDeepest) fail(fmt::format("more than {} subgraphs in each other at", kDeepest));
      words_.next();
      return read_statements(depth + 1);
    }
    if (is_subgraph || !words_.peek().is_name()) fail("expected a vertex, found");
    const std::string id = read_text();
    if (may_be_setting && words_.peek().is("=")) {
      words_.next();
      if (!words_.peek().is_name()) fail("expected a value, found");
      read_text();
      return {};
    }
    while (words_.peek().is(":")) {  // a port
      words_.next();
      if (!words_.peek().is_name()) fail("expected a port, found");
      words_.next();
    }
    return {graph_.vertex(id)};
  }

  /// A name, or strings joined by +.
  std::string read_text() {
    std::string text = words_.next().text;
    while (words_.peek().is("+")) {
      words_.next();
      if (words_.peek().kind != TextWord::Kind::quoted) fail("expected a string, found");
      text += words_.next().text;
    }
    return text;
  }

  /// [name = value, …] any number of times; a label names the vertex.
  void read_attributes(std::optional<Vertex> vertex) {
    while (words_.peek().is("[")) {
      words_.next();
      while (!words_.peek().is("]")) {
        if (!words_.peek().is_name()) fail("expected an attribute, found");
        const std::string name = read_text();
        std::string value;
        if (words_.peek().is("=")) {
          words_.next();
          if (!words_.peek().is_name()) fail("expected a value, found");
          value = read_text();
        }
        const bool is_label =
            vertex && (name == "label" || name == "name") && value != "\\N" && !value.empty();
        if (is_label) graph_.set_name(*vertex, value);
        if (words_.peek().is(";") || words_.peek().is(",")) words_.next();
      }
      words_.next();
    }
  }

  WordText words_;
  GatheredGraph graph_;
};

void append_dot(OutputFile& output, const Graph& graph, unsigned) {
  output.pending() += "graph {\n";
  append_vertices(output, graph, {"", ";\n"});
  append_edges(output, graph, {"", " -- ", ";\n"});
  output.pending() += "}\n";
}

bool looks_like_dot(const InputHead& head) {
  std::string_view text = head.text;
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  if (text.starts_with("//") || text.starts_with("/*")) return true;
  const std::string_view word = text.substr(0, text.find_first_of(" \t\r\n{\""));
  using boost::algorithm::iequals;
  return iequals(word, "graph") || iequals(word, "digraph") || iequals(word, "strict");
}

}  // namespace

GraphFormat dot_format() {
  return {.name = "dot",
          .extensions = {".dot", ".gv"},
          .summary = "DOT of Graphviz: graph { a -- b; }, attributes are read over",
          .detect = looks_like_dot,
          .parser = make_parser<DotParser>,
          .writer = make_appending<append_dot>};
}

}  // namespace ar3d
