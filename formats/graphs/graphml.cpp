#include "ar3d/formats/graphs/graphml.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/graph/graphml.hpp>
#include <sstream>
#include <unordered_set>
#include <utility>
#include <vector>

#include "ar3d/formats/text/numbers_text.h"
#include "ar3d/formats/text/xml_tags.h"
#include "ar3d/model/error.h"

namespace ar3d {
namespace {

constexpr std::size_t kMaxDepth = 100;  // Boost's parser is recursive

/// Receives the elements from Boost's reader in the order of the file.
class EdgeReceiver final : public boost::mutate_graph {
 public:
  std::uint64_t n = 0;
  std::vector<Edge> edges;

  bool is_directed() const override { return false; }
  boost::any do_add_vertex() override { return static_cast<Vertex>(n++); }
  std::pair<boost::any, bool> do_add_edge(boost::any source, boost::any target) override {
    edges.push_back({boost::any_cast<Vertex>(source), boost::any_cast<Vertex>(target)});
    return {boost::any(edges.size() - 1), true};
  }
  void set_graph_property(const std::string&, const std::string&, const std::string&) override {}
  void set_vertex_property(const std::string&, boost::any, const std::string&,
                           const std::string&) override {}
  void set_edge_property(const std::string&, boost::any, const std::string&,
                         const std::string&) override {}
};

/// Where one <graph> element stands.
struct Range {
  std::size_t begin = 0;
  std::size_t end = 0;
};

class GraphmlParser final : public GraphParser {
 public:
  GraphmlParser(TextInput& input, const ReadOptions&) : input_(input) {}

  std::optional<Graph> next() override {
    if (!loaded_) load();
    if (next_range_ == ranges_.size()) return std::nullopt;
    return read(ranges_[next_range_++]);
  }

 private:
  void load() {
    loaded_ = true;
    while (const std::optional<std::string_view> line = input_.next_line())
      text_.append(*line) += '\n';
    find_graphs();
    if (ranges_.empty()) input_.fail(0, "no <graph> element inside a <graphml> element");
  }

  /// Fills ranges_ with the graphs that stand directly in <graphml>.
  void find_graphs() {
    XmlTags tags(text_);
    std::size_t depth = 0;
    std::size_t begin = 0;
    while (const std::optional<XmlTag> tag = tags.next()) {
      const bool graph = tag->name == "graph";
      if (tag->kind == XmlTag::Kind::close) {
        if (depth > 0) --depth;
        if (graph && depth == 1) ranges_.push_back({begin, tag->end});
        continue;
      }
      if (graph && depth == 1) begin = tag->begin;
      if (tag->kind == XmlTag::Kind::empty) {
        if (graph && depth == 1) ranges_.push_back({begin, tag->end});
      } else if (++depth > kMaxDepth) {
        input_.fail_at(line_of(tag->begin), 0,
                       fmt::format("elements nested deeper than {}", kMaxDepth));
      }
    }
    if (depth > 0) input_.fail(0, "the text ends inside an element");
  }

  /// The document with no other graph than this one.
  std::string document(Range range) const {
    const std::size_t first = ranges_.front().begin;
    return text_.substr(0, first) + text_.substr(range.begin, range.end - range.begin) +
           "</graphml>";
  }

  Graph read(Range range) const {
    EdgeReceiver received;
    std::istringstream stream(document(range));
    try {
      boost::read_graphml(stream, received, 0);
      refuse_unknown_nodes(range, received.n);
      return Graph(received.n, std::move(received.edges));
    } catch (const EdgeError& error) {
      fail_edge(range, error.edge(), error.what());
    } catch (const InputError&) {
      throw;
    } catch (const std::exception& error) {
      // Boost's own exceptions: graph errors, XML errors, missing attributes
      input_.fail_at(line_of(range.begin), 0,
                     fmt::format("graph {}: {}", next_range_, one_line(error.what())));
    }
  }

  /// Boost makes a vertex of every name: of two nodes with one id it makes one, of an edge to a
  /// node that is not there a new one. Finds such nodes, if there are any.
  void refuse_unknown_nodes(Range range, std::uint64_t vertices) const {
    std::unordered_set<std::string_view> ids;
    std::uint64_t nodes = 0;
    for_each_tag(range, "node", [&](const XmlTag& tag, std::string_view text) {
      const std::string_view id = attribute_of(text, "id").value_or("");
      if (!ids.insert(id).second)
        fail_tag(range, tag, fmt::format("node {} stands twice", shown(id)));
      ++nodes;
    });
    if (nodes == vertices) return;
    for_each_tag(range, "edge", [&](const XmlTag& tag, std::string_view text) {
      for (const std::string_view end : {"source", "target"}) {
        const std::string_view id = attribute_of(text, end).value_or("");
        if (!ids.contains(id)) {
          fail_tag(range, tag, fmt::format("{} {} is no node of this graph", end, shown(id)));
        }
      }
    });
    input_.fail_at(line_of(range.begin), 0, "an edge ends at a node that is not of this graph");
  }

  [[noreturn]] void fail_edge(Range range, std::uint64_t edge, const std::string& problem) const {
    std::uint64_t seen = 0;
    for_each_tag(range, "edge", [&](const XmlTag& tag, std::string_view) {
      if (seen++ == edge) fail_tag(range, tag, problem);
    });
    input_.fail_at(line_of(range.begin), 0, problem);
  }

  /// Calls visit(tag, its text) for the opening tags of a name inside a graph.
  template <class Visit>
  void for_each_tag(Range range, std::string_view name, Visit visit) const {
    const std::string_view text =
        std::string_view(text_).substr(range.begin, range.end - range.begin);
    XmlTags tags(text);
    while (const std::optional<XmlTag> tag = tags.next()) {
      if (tag->name == name && tag->kind != XmlTag::Kind::close) {
        visit(*tag, text.substr(tag->begin, tag->end - tag->begin));
      }
    }
  }

  [[noreturn]] void fail_tag(Range range, const XmlTag& tag, const std::string& problem) const {
    const std::size_t at = range.begin + tag.begin;
    const std::size_t line_begin = text_.rfind('\n', at) + 1;
    input_.fail_at(line_of(at), at - line_begin + 1, problem);
  }

  std::uint64_t line_of(std::size_t at) const {
    return static_cast<std::uint64_t>(
               std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at), '\n')) +
           1;
  }
  static std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
  }

  TextInput& input_;
  bool loaded_ = false;
  std::string text_;
  std::vector<Range> ranges_;
  std::size_t next_range_ = 0;
};

class GraphmlWriter final : public GraphWriter {
 public:
  explicit GraphmlWriter(OutputFile& output) : output_(output) {
    output_.append(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<graphml "
        "xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n");
  }
  void write(const Graph& graph) override {
    std::string& out = output_.pending();
    out += fmt::format("<graph id=\"g{}\" edgedefault=\"undirected\">\n", graphs_++);
    for (Vertex v = 0; v < graph.num_vertices(); ++v) {
      out += "<node id=\"n";
      append_number(out, v);
      out += "\"/>\n";
      output_.flush_if_full();
    }
    for (const auto [u, v] : graph.edges()) {
      out += "<edge source=\"n";
      append_number(out, u);
      out += "\" target=\"n";
      append_number(out, v);
      out += "\"/>\n";
      output_.flush_if_full();
    }
    out += "</graph>\n";
  }
  void finish() override { output_.append("</graphml>\n"); }

 private:
  OutputFile& output_;
  std::uint64_t graphs_ = 0;
};

}  // namespace

GraphFormat graphml_format() {
  return {.name = "graphml",
          .extensions = {".graphml", ".xml"},
          .summary = "GraphML: nodes and edges as XML, attributes are read over",
          .detect =
              [](const InputHead& head) {
                const std::size_t first = head.text.find_first_not_of(" \t\r\n\xef\xbb\xbf");
                return first != std::string_view::npos && head.text[first] == '<';
              },
          .parser = [](TextInput& input, const ReadOptions&) -> std::unique_ptr<GraphParser> {
            return std::make_unique<GraphmlParser>(input, ReadOptions{});
          },
          .writer = [](OutputFile& output, const WriteOptions&) -> std::unique_ptr<GraphWriter> {
            return std::make_unique<GraphmlWriter>(output);
          }};
}

}  // namespace ar3d
