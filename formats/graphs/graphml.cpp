// GraphML, parsed by pugixml: vertices are numbered in the order of their <node> elements; a file
// may hold several <graph> elements. Attributes are read over. The whole file is held in memory
// while it is read. Reference: networkx (read_graphml) and igraph (Read_GraphML).
#include <fmt/format.h>

#include <cstring>
#include <pugixml.hpp>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/formats/graphs/graph_format.h"
#include "ar3d/formats/graphs/node_ids.h"
#include "ar3d/formats/text/output.h"

// The whole document is read into pugixml's tree, which expands no entity that a document defines
// itself and parses without recursion: neither bombs of entities nor deep nesting cost more than
// their text.
namespace ar3d {
namespace {

/// True if that is the name of the element, with or without the prefix of a namespace.
bool is_named(pugi::xml_node element, const char* name) {
  if (std::strcmp(element.name(), name) == 0) return true;
  const char* const prefix = std::strrchr(element.name(), ':');
  return prefix != nullptr && std::strcmp(prefix + 1, name) == 0;
}

class GraphmlParser final : public GraphParser {
 public:
  using GraphParser::GraphParser;

  std::optional<Graph> next() override {
    if (!loaded_) load();
    if (next_ == graphs_.size()) return std::nullopt;
    return read(graphs_[next_++]);
  }
  std::vector<std::string> names() const override {
    return next_ == 0 ? std::vector<std::string>() : names_of(graphs_[next_ - 1]);
  }

 private:
  void load() {
    loaded_ = true;
    text_ = input_.take_all();
    constexpr unsigned kOptions = pugi::parse_escapes | pugi::parse_wconv_attribute;
    const pugi::xml_parse_result parsed =
        document_.load_buffer(text_.data(), text_.size(), kOptions);
    if (!parsed) fail_at(static_cast<std::size_t>(parsed.offset), parsed.description());
    for (const pugi::xml_node root : document_.children()) {
      if (!is_named(root, "graphml")) continue;
      for (const pugi::xml_node child : root.children()) {
        if (is_named(child, "graph")) graphs_.push_back(child);
      }
    }
    if (graphs_.empty()) input_.fail(0, "no <graph> element inside a <graphml> element");
  }

  /// The text of the key that is called "label" or "name", or the id.
  std::vector<std::string> names_of(pugi::xml_node graph) const {
    std::set<std::string_view> keys;
    for (const pugi::xml_node key : graph.parent().children()) {
      const std::string_view name = key.attribute("attr.name").value();
      if (name == "label" || name == "name") keys.emplace(key.attribute("id").value());
    }
    std::vector<std::string> names;
    for (const pugi::xml_node node : graph.children()) {
      if (!is_named(node, "node")) continue;
      std::string& name = names.emplace_back(node.attribute("id").value());
      for (const pugi::xml_node data : node.children()) {
        const bool is_name = keys.contains(data.attribute("key").value());
        if (is_name && !data.text().empty()) name = data.text().get();
      }
    }
    return telling_names(std::move(names));
  }

  Graph read(pugi::xml_node graph) const {
    const std::string_view kind = graph.attribute("edgedefault").value();
    if (kind != "undirected" && !(kind == "directed" && options_.undirected)) {
      fail(graph, fmt::format("edgedefault is {}: only undirected graphs are read (--undirected "
                              "drops directions)",
                              shown(kind)));
    }
    NodeIds ids;
    std::vector<pugi::xml_node> edge_elements;  // their ends may stand behind them
    for (const pugi::xml_node element : graph.children()) {
      if (is_named(element, "edge")) {
        refuse_graphs_inside(element);
        edge_elements.push_back(element);
      } else if (is_named(element, "node")) {
        read_node(element, ids);
      } else if (is_named(element, "hyperedge")) {
        fail(element, "hyperedges are not read");
      }
    }
    check_stated(graph, "parse.nodes", ids.size());
    check_stated(graph, "parse.edges", edge_elements.size());
    std::vector<Edge> edges;
    for (const pugi::xml_node element : edge_elements) edges.push_back(read_edge(element, ids));
    if (options_.simplify) simplify(edges);
    try {
      return Graph(ids.size(), std::move(edges));
    } catch (const EdgeError& error) {
      fail(edge_elements[error.edge()], error.what());
    }
  }

  void check_stated(pugi::xml_node graph, const char* count, std::size_t found) const {
    const std::string_view stated = graph.attribute(count).value();
    if (stated.empty() || stated == fmt::format("{}", found)) return;
    fail(graph,
         fmt::format("{} is {}, found {}: is the file cut short?", count, shown(stated), found));
  }

  void refuse_graphs_inside(pugi::xml_node element) const {
    for (const pugi::xml_node inner : element.children()) {
      if (is_named(inner, "graph")) fail(inner, "graphs inside nodes or edges are not read");
    }
  }

  void read_node(pugi::xml_node element, NodeIds& ids) const {
    refuse_graphs_inside(element);
    const pugi::xml_attribute id = element.attribute("id");
    if (!id) fail(element, "a node without an id");
    if (const auto problem = name_problem(id.value())) fail(element, *problem);
    if (!ids.add(id.value())) {  // its text lies in the document
      fail(element, fmt::format("node {} stands twice", shown(id.value())));
    }
  }

  Edge read_edge(pugi::xml_node element, const NodeIds& ids) const {
    const std::string_view directed = element.attribute("directed").value();
    if ((directed == "true" || directed == "1") && !options_.undirected) {
      fail(element, "directed edges are not read (--undirected drops directions)");
    }
    return {end_of(element, "source", ids), end_of(element, "target", ids)};
  }
  Vertex end_of(pugi::xml_node element, const char* which, const NodeIds& ids) const {
    const pugi::xml_attribute end = element.attribute(which);
    if (!end) fail(element, fmt::format("an edge without a {}", which));
    const std::optional<Vertex> found = ids.find(end.value());
    if (!found) {
      fail(element, fmt::format("{} {} is no node of this graph", which, shown(end.value())));
    }
    return *found;
  }

  [[noreturn]] void fail(pugi::xml_node element, const std::string& problem) const {
    fail_at(static_cast<std::size_t>(element.offset_debug() - 1), problem);  // at its '<'
  }
  [[noreturn]] void fail_at(std::size_t offset, const std::string& problem) const {
    input_.fail_behind(std::string_view(text_).substr(0, offset), problem);
  }

  bool loaded_ = false;
  std::string text_;  // UTF-8, for places in messages
  pugi::xml_document document_;
  std::vector<pugi::xml_node> graphs_;
  std::size_t next_ = 0;
};

GraphWriter graphml_writer(OutputFile& output, unsigned) {
  output.append(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<graphml "
      "xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n");
  return [&output, graphs = std::uint64_t{0}](const Graph& graph) mutable {
    output.pending() += fmt::format("<graph id=\"g{}\" edgedefault=\"undirected\">\n", graphs++);
    append_vertices(output, graph, {"<node id=\"n", "\"/>\n"});
    append_edges(output, graph, {"<edge source=\"n", "\" target=\"n", "\"/>\n"});
    output.pending() += "</graph>\n";
  };
}

}  // namespace

GraphFormat graphml_format() {
  return {.name = "graphml",
          .extensions = {".graphml", ".xml"},
          .summary = "GraphML: nodes and edges as XML, attributes are read over",
          .detect =
              [](const InputHead& head) {
                const std::size_t first = head.text.find_first_not_of(" \t\r\n");
                return first != std::string_view::npos && head.text[first] == '<';
              },
          .parser = make_parser<GraphmlParser>,
          .writer = graphml_writer,
          .tail = "</graphml>\n"};
}

}  // namespace ar3d
