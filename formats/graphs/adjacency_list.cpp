// A vertex a line, "u: v w …" (the colon may be missing); an edge may stand at one of its ends or
// at both. Comments and "# vertices N" as in edge lists.
#include <fmt/format.h>

#include <limits>

#include "ar3d/formats/graphs/arc_collector.h"
#include "ar3d/formats/graphs/edge_collector.h"
#include "ar3d/formats/graphs/plain_lines.h"
#include "ar3d/formats/graphs/word_text.h"
#include "ar3d/formats/text/output.h"
#include "ar3d/formats/text/tokens.h"

namespace ar3d {
namespace {

class AdjacencyListParser final : public GraphParser {
 public:
  AdjacencyListParser(TextInput& input, const ReadOptions& options)
      : GraphParser(input, options),
        ids_(input, options, options.base),
        arcs_(input, options, options.base, true) {}

  std::optional<Graph> next() override {
    bool begun = false;
    is_named_ = false;
    named_ = GatheredGraph();
    arcs_.begin();
    while (const std::optional<std::string_view> line = next_odd_line(begun)) {
      if (is_blank(*line)) continue;
      if (std::optional<Tokens> header = size_header(input_, *line)) {
        if (begun) {
          input_.put_back();
          break;
        }
        const std::uint64_t n = header->number("a number of vertices");
        header->expect_done("the number of vertices");
        ids_.begin(n);
        begun = true;
      } else if (!is_comment(*line)) {
        if (!begun) {
          ids_.begin(std::nullopt);
          is_named_ = begins_with_name(*line);
        }
        begun = true;
        read_row(*line);
      }
    }
    if (!begun) return std::nullopt;
    return arcs_.finish(is_named_ ? named_.num_vertices() : ids_.checked_n());
  }
  std::vector<std::string> names() const override { return named_.names(); }

 private:
  /// The next line that is not read as one of many plain rows.
  std::optional<std::string_view> next_odd_line(bool begun) {
    constexpr std::uint64_t kAll = std::numeric_limits<std::uint64_t>::max();
    if (begun && !is_named_) {
      read_plain_rows(input_, true, kAll, [&](auto u, const auto& row, auto line) {
        for (const std::uint64_t v : row) {
          if (!ids_.accepts(u, v, line)) return false;
        }
        if (row.empty()) return false;  // its vertex counts, too: the careful reader's
        for (const std::uint64_t v : row) {
          arcs_.add(static_cast<Vertex>(u - options_.base), static_cast<Vertex>(v - options_.base),
                    line);
        }
        return true;
      });
    }
    return input_.next_line();
  }
  void read_row(std::string_view line) {
    const std::size_t colon = line.find(':');
    std::string_view before = colon == std::string_view::npos ? line : line.substr(0, colon);
    Tokens vertex(input_, before);
    const Vertex u = read_vertex(vertex);
    Tokens row = vertex;
    if (colon != std::string_view::npos) {
      vertex.expect_done("the vertex before the colon");
      row = Tokens(input_, line, colon + 1);
    }
    while (!row.done()) {
      const Vertex v = read_vertex(row);
      if (u == v && !arcs_.simplifies()) {
        row.fail(fmt::format("edge ({0}, {0}) is a loop", std::uint64_t{u} + options_.base));
      }
      arcs_.add(u, v, input_.line());
    }
  }

  Vertex read_vertex(Tokens& tokens) {
    return is_named_ ? named_.vertex(tokens.word()) : ids_.read_vertex(tokens);
  }

  EdgeCollector ids_;
  GatheredGraph named_;  // whose edges are arcs_
  bool is_named_ = false;
  ArcCollector arcs_;
};

void append_adjacency_list(OutputFile& output, const Graph& graph, unsigned base) {
  std::string& out = output.pending();
  out += fmt::format("# vertices {}\n", graph.num_vertices());
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    append_all(out, std::uint64_t{v} + base, ':');
    for (const HalfEdge& half : graph.incident(v)) {
      append_all(out, ' ', std::uint64_t{half.to} + base);
    }
    out += '\n';
    output.flush_if_full();
  }
}

/// The first line that is no comment begins with a number and a colon; or networkx has written it
/// (its other adjacency lists, of several lines a vertex, have braces).
bool looks_like_adjacency_list(const InputHead& head) {
  std::string_view text = head.text;
  bool is_networkx = false;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    is_networkx = is_networkx || line.starts_with("# GMT ");
    if (!is_blank(line) && !is_comment(line) && !line.starts_with("n ")) {
      const std::size_t after = line.find_first_not_of("0123456789 \t");
      if (after != std::string_view::npos && after > 0 && line[after] == ':') return true;
      return is_networkx && head.text.find('{') == std::string_view::npos;
    }
    if (end == std::string_view::npos) return false;
    text.remove_prefix(end + 1);
  }
  return false;
}

}  // namespace

GraphFormat adjacency_list_format() {
  return {.name = "adjlist",
          .extensions = {".adj", ".adjlist"},
          .summary = "one vertex per line with its neighbours, \"u: v w …\"",
          .detect = looks_like_adjacency_list,
          .parser = make_parser<AdjacencyListParser>,
          .writer = make_appending<append_adjacency_list>};
}

}  // namespace ar3d
