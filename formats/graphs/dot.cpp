// DOT of Graphviz, word for word as its scan.l and grammar.y; attributes and ports are read over.
// Reference: Graphviz (gc, dot). Not by its library libcgraph 2.42: behind some errors it reads right
// files of the same process as no graph, without a word; it names no line of a loop or parallel edge,
// and expands two subgraphs of a few bytes to any size. Nor by Boost.Graph, which recurses.
#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <map>
#include <set>
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
    if (words_.peek().is_name()) read_text();
    words_.expect_mark("{", "behind graph");
    edge_ = is_directed ? "->" : "--";
    graph_ = GatheredGraph();
    Subgraph whole;
    read_statements(whole, 0);
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

  /// A subgraph: its vertices, and the named subgraphs in it. A name that comes again in the same
  /// subgraph is the same one, as in Graphviz.
  struct Subgraph {
    std::set<Vertex> vertices;
    std::map<std::string, Subgraph> named;
  };

  /// Behind a {, up to its }. @param depth  of the subgraph; 0: the graph itself.
  void read_statements(Subgraph& here, std::size_t depth) {
    while (!words_.peek().is("}")) {
      if (is_keyword("graph") || is_keyword("node") || is_keyword("edge")) {
        words_.next();
        if (!words_.peek().is("[")) fail("expected [, found");
        read_attributes({});
      } else {
        read_chain(here, depth);
      }
      if (words_.peek().is(";")) words_.next();
    }
    words_.next();
  }

  /// Vertices, an edge "a -- b, c -- {d e}", or "name = value".
  void read_chain(Subgraph& here, std::size_t depth) {
    const std::vector<Vertex> first = read_end(here, depth, true);
    const bool is_edge = words_.peek().is(edge_);
    std::vector<Vertex> ends = first;
    while (words_.peek().is(edge_)) {
      const std::size_t at = words_.next().at;
      const std::vector<Vertex> others = read_end(here, depth, false);
      // Two subgraphs of a few bytes must not claim gigabytes.
      const std::uint64_t edges = graph_.num_edges() + std::uint64_t{ends.size()} * others.size();
      if (vertex_count_problem(edges, at, options_)) {
        words_.fail(at, fmt::format("{} edges claimed by {} bytes", edges, at));
      }
      for (const Vertex u : ends) {
        for (const Vertex v : others) graph_.join(u, v, at);
      }
      ends = others;
    }
    if (words_.peek().is("->")) fail("only undirected edges are read, not");
    if (words_.peek().is("--")) fail("edges of a digraph are ->, not");
    if (words_.peek().is("[")) read_attributes(is_edge ? std::vector<Vertex>() : first);
  }

  /// Vertices between commas, or those of a subgraph; none for a setting.
  std::vector<Vertex> read_end(Subgraph& here, std::size_t depth, bool may_be_setting) {
    const bool is_subgraph = is_keyword("subgraph");
    std::string name;
    if (is_subgraph) {
      words_.next();
      if (words_.peek().is_name()) name = read_text();
    }
    if (words_.peek().is("{")) return read_subgraph(here, name, depth + 1);
    if (is_subgraph) fail("expected {, found");
    std::vector<Vertex> vertices;
    for (;;) {
      if (!words_.peek().is_name()) fail("expected a vertex, found");
      const bool is_html = words_.peek().is_html;
      const std::size_t at = words_.peek().at;
      const std::string id = read_text();
      if (const auto problem = name_problem(id)) words_.fail(at, *problem);
      if (id.starts_with('%')) {
        words_.fail(at, fmt::format("{}: names that begin with % are Graphviz's own", shown(id)));
      }
      if (may_be_setting && vertices.empty() && words_.peek().is("=")) {
        words_.next();
        if (!words_.peek().is_name()) fail("expected a value, found");
        read_text();
        return {};
      }
      for (int ports = 0; ports < 2 && words_.peek().is(":"); ++ports) {
        words_.next();
        if (!words_.peek().is_name()) fail("expected a port, found");
        read_text();
      }
      const Vertex v = graph_.vertex(is_html ? "\x01" + id : id);  // <a> is another one than "a"
      if (is_html) graph_.set_name(v, id);
      vertices.push_back(v);
      if (depth > 0) here.vertices.insert(v);
      if (!words_.peek().is(",")) return vertices;
      words_.next();
    }
  }
  std::vector<Vertex> read_subgraph(Subgraph& here, const std::string& name, std::size_t depth) {
    if (depth > kDeepest) fail(fmt::format("more than {} subgraphs in each other at", kDeepest));
    words_.next();
    Subgraph unnamed;
    Subgraph& inner = name.empty() ? unnamed : here.named[name];
    read_statements(inner, depth);
    if (depth > 1) here.vertices.insert(inner.vertices.begin(), inner.vertices.end());
    return {inner.vertices.begin(), inner.vertices.end()};
  }

  /// A name, or strings joined by +.
  std::string read_text() {
    for (const char* keyword : {"graph", "digraph", "subgraph", "strict", "node", "edge"}) {
      if (is_keyword(keyword)) fail("a name that is a keyword stands in quotes:");
    }
    const bool is_quoted = words_.peek().kind == TextWord::Kind::quoted;
    std::string text = words_.next().text;
    while (is_quoted && words_.peek().is("+")) {
      words_.next();
      if (words_.peek().kind != TextWord::Kind::quoted) fail("expected a string, found");
      text += words_.next().text;
    }
    return text;
  }

  /// [name = value, …] any number of times; a label names the vertices.
  void read_attributes(const std::vector<Vertex>& vertices) {
    while (words_.peek().is("[")) {
      words_.next();
      while (!words_.peek().is("]")) {
        if (!words_.peek().is_name()) fail("expected an attribute, found");
        const std::string name = read_text();
        if (!words_.peek().is("=")) fail("expected =, found");
        words_.next();
        if (!words_.peek().is_name()) fail("expected a value, found");
        const std::string value = read_text();
        const bool is_label = name == "label" || name == "name";
        if (is_label && value != "\\N" && !value.empty() && !vertices.empty()) {
          if (const auto problem = name_problem(value)) fail(*problem + " before");
          for (const Vertex v : vertices) graph_.set_name(v, value);
        }
        if (words_.peek().is(";") || words_.peek().is(",")) words_.next();
      }
      words_.next();
    }
  }

  WordText words_;
  const char* edge_ = "--";
  GatheredGraph graph_;
};

void append_dot(OutputFile& output, const Graph& graph, unsigned) {
  output.pending() += "graph {\n";
  append_vertices(output, graph, {"", ";\n"});
  append_edges(output, graph, {"", " -- ", ";\n"});
  output.pending() += "}\n";
}

/// Behind comments "strict", "graph" or "digraph", maybe a name, and a {.
bool looks_like_dot(const InputHead& head) {
  std::string_view text = first_text(head.body);
  const auto skip_to = [&](std::size_t at) {
    text = first_text(text.substr(std::min(at, text.size())));
  };
  const auto skip_word = [&](std::string_view word) {
    if (!boost::algorithm::istarts_with(text, word)) return false;
    const std::string_view rest = text.substr(word.size());
    if (!rest.empty() && std::string_view(" \t\r\n{\"/").find(rest[0]) == std::string_view::npos) {
      return false;
    }
    text = first_text(rest);
    return true;
  };
  const bool is_strict = skip_word("strict");
  if (!skip_word("graph") && !skip_word("digraph")) return is_strict && head.ending == "dot";
  if (head.ending == "dot") return true;
  if (text.starts_with('"')) {
    skip_to(text.find('"', 1) + 1);
  } else {
    skip_to(text.find_first_of(" \t\r\n{"));
  }
  return text.starts_with('{');
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
