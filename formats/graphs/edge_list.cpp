#include "ar3d/formats/graphs/edge_list.h"

#include <limits>

#include "ar3d/formats/graphs/edge_collector.h"
#include "ar3d/formats/text/line_shapes.h"
#include "ar3d/formats/text/numbers_text.h"

namespace ar3d {
namespace {

class EdgeListParser final : public GraphParser {
 public:
  EdgeListParser(TextInput& input, const ReadOptions& options)
      : input_(input), edges_(input, options, options.base) {}

  std::optional<Graph> next() override {
    bool begun = false;
    while (const std::optional<std::string_view> line = next_odd_line(begun)) {
      if (is_blank(*line)) continue;
      if (const std::optional<Tokens> header = size_header(input_, *line)) {
        if (begun) {
          input_.put_back();
          break;
        }
        begin_with(*header);
        begun = true;
      } else if (!is_comment(*line)) {
        if (!begun) edges_.begin(std::nullopt);
        begun = true;
        Tokens tokens(input_, *line);
        edges_.read_edge(tokens);
        tokens.expect_done("the edge");
      }
    }
    if (!begun) return std::nullopt;
    return edges_.finish();
  }

 private:
  /// The next line that is not read as one of many plain edges.
  std::optional<std::string_view> next_odd_line(bool begun) {
    constexpr std::uint64_t kAll = std::numeric_limits<std::uint64_t>::max();
    if (begun) edges_.read_plain_edges(input_, "", kAll);
    return input_.next_line();
  }
  void begin_with(Tokens header) {
    const std::uint64_t n = header.number("a number of vertices");
    header.expect_done("the number of vertices");
    edges_.begin(n);
  }

  TextInput& input_;
  EdgeCollector edges_;
};

class EdgeListWriter final : public GraphWriter {
 public:
  EdgeListWriter(OutputFile& output, const WriteOptions& options)
      : output_(output), base_(options.base) {}

  void write(const Graph& graph) override {
    std::string& out = output_.pending();
    out += "# vertices ";
    append_number(out, graph.num_vertices());
    out += '\n';
    for (const auto [u, v] : graph.edges()) {
      append_number(out, std::uint64_t{u} + base_);
      out += ' ';
      append_number(out, std::uint64_t{v} + base_);
      out += '\n';
      output_.flush_if_full();
    }
  }

 private:
  OutputFile& output_;
  unsigned base_;
};

/// Numbers or comments first; the last format asked, so that an odd line is reported by its number.
bool looks_like_edge_list(const InputHead& head) {
  const std::size_t first = head.text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return true;
  const std::string_view text = head.text.substr(first);
  return is_digit(text[0]) || is_comment(text) || text.starts_with("n ");
}

}  // namespace

GraphFormat edge_list_format() {
  return {
      .name = "edgelist",
      .extensions = {".edges", ".edgelist", ".el", ".txt"},
      .summary = "one edge \"u v\" a line, comments with # or %, \"# vertices N\" begins a graph",
      .detect = looks_like_edge_list,
      .parser = [](TextInput& input, const ReadOptions& options) -> std::unique_ptr<GraphParser> {
        return std::make_unique<EdgeListParser>(input, options);
      },
      .writer = [](OutputFile& output,
                   const WriteOptions& options) -> std::unique_ptr<GraphWriter> {
        return std::make_unique<EdgeListWriter>(output, options);
      }};
}

}  // namespace ar3d
