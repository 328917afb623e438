// GML: lists of keys and values in brackets; nodes have ids of their own. Other keys are read over.
// Reference: networkx (parse_gml) and igraph (Read_GML).
#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <cctype>
#include <string>

#include "ar3d/formats/graphs/word_text.h"
#include "ar3d/formats/text/tokens.h"

namespace ar3d {
namespace {

/// Keys are the same in small and capital letters, as igraph reads them.
bool is_key(const TextWord& word, std::string_view key) {
  return boost::algorithm::iequals(word.text, key);
}

bool may_be_key(const TextWord& word) {
  return word.kind == TextWord::Kind::plain && std::ranges::all_of(word.text, [](unsigned char c) {
           return std::isalnum(c) || c == '_';
         });
}

class GmlParser final : public GraphParser {
 public:
  GmlParser(TextInput& input, const ReadOptions& options)
      : GraphParser(input, options), words_(input, false) {}

  std::optional<Graph> next() override {
    while (words_.peek().kind != TextWord::Kind::end) {
      const TextWord key = words_.next();
      if (!may_be_key(key)) fail(key, "expected a key, found");
      if (is_key(key, "graph") && words_.peek().is("[")) return read_graph();
      skip_value(key);
    }
    return std::nullopt;
  }
  std::vector<std::string> names() const override { return graph_.names(); }

 private:
  /// Calls take(key) for each key of the list to come; it has to read the value.
  template <class Take>
  void read_list(const Take& take) {
    const TextWord open = words_.next();
    while (!words_.peek().is("]")) {
      const TextWord key = words_.next();
      if (key.kind == TextWord::Kind::end) words_.fail(open.at, "a [ is never closed");
      if (!may_be_key(key)) fail(key, "expected a key or ], found");
      take(key);
    }
    words_.next();
  }

  Graph read_graph() {
    std::vector<std::array<TextWord, 2>> edges;  // both ends, at the edge's index
    graph_ = GatheredGraph();
    read_list([&](const TextWord& key) {
      const bool is_list = words_.peek().is("[");
      if (is_key(key, "node") && is_list) {
        read_node(key);
      } else if (is_key(key, "edge") && is_list) {
        std::array<TextWord, 2>& ends = edges.emplace_back();
        ends[0].at = ends[1].at = key.at;
        read_list([&](const TextWord& inner) {
          const bool is_source = is_key(inner, "source");
          if (!is_source && !is_key(inner, "target")) return skip_value(inner);
          std::string& end = ends[is_source ? 0 : 1].text;
          if (!end.empty()) fail(inner, "a second");
          end = value_of(inner);
        });
      } else if (is_key(key, "directed")) {
        if (value_of(key) != "0" && !options_.undirected) {
          fail(key, "only undirected graphs are read (--undirected drops directions), not");
        }
      } else {
        skip_value(key);
      }
    });
    for (const auto& [source, target] : edges) {
      const Vertex u = end_of(source);
      graph_.join(u, end_of(target), source.at);
    }
    return graph_.finish(options_, false,
                         [&](std::size_t at, const std::string& why) { words_.fail(at, why); });
  }

  void read_node(const TextWord& node) {
    std::optional<std::string> id;
    std::string label;
    read_list([&](const TextWord& key) {
      if (is_key(key, "id")) {
        if (id) fail(key, "a second");
        return id = value_of(key), void();
      }
      if (is_key(key, "label")) {
        if (!label.empty()) fail(key, "a second");
        return label = value_of(key), void();
      }
      skip_value(key);
    });
    if (!id) fail(node, "no id in a");
    if (const auto problem = name_problem(label.empty() ? *id : label)) {
      words_.fail(node.at, *problem);
    }
    if (graph_.find(*id)) fail(node, fmt::format("id {} stands twice: the second", shown(*id)));
    const Vertex v = graph_.vertex(*id);
    if (!label.empty()) graph_.set_name(v, label);
  }
  Vertex end_of(const TextWord& end) const {
    if (const std::optional<Vertex> found = graph_.find(end.text)) return *found;
    words_.fail(end.at,
                fmt::format("an edge ends at {}, which is no node of this graph", shown(end.text)));
  }

  std::string value_of(const TextWord& key) {
    const TextWord value = words_.next();
    if (!value.is_name()) fail(key, "expected a number or text behind");
    return value.text;
  }
  void skip_value(const TextWord& key) {
    const TextWord value = words_.next();
    if (value.is("[")) return words_.skip_list("[", "]");
    if (!value.is_name()) fail(key, "expected a value behind");
  }
  [[noreturn]] void fail(const TextWord& word, const std::string& problem) const {
    words_.fail(word.at, fmt::format("{} {}", problem, shown(word.text)));
  }

  WordText words_;
  GatheredGraph graph_;
};

void append_gml(OutputFile& output, const Graph& graph, unsigned) {
  output.pending() += "graph [\n";
  append_vertices(output, graph, {"  node [ id ", " ]\n"});
  append_edges(output, graph, {"  edge [ source ", " target ", " ]\n"});
  output.pending() += "]\n";
}

/// The key graph and a list; or another key and its value, and behind them these.
bool looks_like_gml(const InputHead& head) {
  const std::string text = boost::algorithm::to_lower_copy(std::string(head.body));
  const auto behind_blanks = [&](std::size_t at) {
    const std::size_t next = text.find_first_not_of(" \t\r\n", at);
    return next == std::string::npos ? '\0' : text[next];
  };
  const std::size_t key = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_");
  if (key == 0 || key == std::string::npos || is_digit(text[0])) return false;
  if (text.substr(0, key) == "graph") return behind_blanks(key) == '[';
  if (std::string_view("\"[+-.0123456789").find(behind_blanks(key)) == std::string_view::npos) {
    return false;
  }
  for (std::size_t at = text.find("graph", key); at != std::string::npos;
       at = text.find("graph", at + 5)) {
    if (behind_blanks(at + 5) == '[') return true;
  }
  return false;
}

}  // namespace

GraphFormat gml_format() {
  return {.name = "gml",
          .extensions = {".gml"},
          .summary = "GML: graph [ node [ id 0 ] edge [ source 0 target 1 ] ]",
          .detect = looks_like_gml,
          .parser = make_parser<GmlParser>,
          .writer = make_appending<append_gml>};
}

}  // namespace ar3d
