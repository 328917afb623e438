// Matrix Market, "matrix coordinate pattern": the adjacency matrix, symmetric, or general if it is
// symmetric.
#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>

#include "ar3d/formats/graphs/arc_collector.h"
#include "ar3d/formats/graphs/edge_collector.h"
#include "ar3d/formats/graphs/plain_lines.h"
#include "ar3d/formats/text/output.h"
#include "ar3d/formats/text/tokens.h"

namespace ar3d {
namespace {

using boost::algorithm::iequals;

constexpr std::string_view kBanner = "%%MatrixMarket";

bool is_banner(std::string_view line) { return boost::algorithm::istarts_with(line, kBanner); }

class MatrixMarketParser final : public GraphParser {
 public:
  MatrixMarketParser(TextInput& input, const ReadOptions& options)
      : GraphParser(input, options), entries_(input, options, 1), arcs_(input, options, 1) {}

  std::optional<Graph> next() override {
    const std::optional<bool> symmetric = read_banner();
    if (!symmetric) return std::nullopt;
    const std::uint64_t count = read_size();
    if (*symmetric) return read_symmetric(count);
    return read_general(count);
  }

 private:
  /// True for "symmetric", false for "general", nothing at the end of the text.
  std::optional<bool> read_banner() {
    std::optional<std::string_view> line = input_.next_line();
    while (line && !is_banner(*line) && (is_blank(*line) || is_comment(*line)))
      line = input_.next_line();
    if (!line) return std::nullopt;
    if (!is_banner(*line)) {
      input_.fail(1, fmt::format("expected '%%MatrixMarket', found {}", shown(*line)));
    }
    Tokens tokens(input_, *line);
    tokens.word();
    for (const std::string_view wanted : {"matrix", "coordinate", "pattern"}) {
      const std::string_view word = tokens.word();
      if (!iequals(word, wanted)) {
        tokens.fail(fmt::format("only '{}' is supported here, found {}", wanted, shown(word)));
      }
    }
    const std::string_view word = tokens.word();
    const bool is_symmetric = iequals(word, "symmetric");
    if (!is_symmetric && !iequals(word, "general")) {
      tokens.fail(
          fmt::format("only 'symmetric' and 'general' are supported here, found {}", shown(word)));
    }
    tokens.expect_done("the banner");
    return is_symmetric;
  }

  std::string_view next_entry(std::uint64_t announced, std::uint64_t found) {
    if (const std::optional<std::string_view> line = next_telling_line(input_)) return *line;
    input_.fail(0, fmt::format("the text ends after {} of {} announced entries", found, announced));
  }

  /// Begins the graph and returns the number of entries.
  std::uint64_t read_size() {
    const std::optional<std::string_view> line = next_telling_line(input_);
    if (!line) input_.fail(0, "the text ends before the line with the sizes");
    Tokens tokens(input_, *line);
    const std::uint64_t rows = tokens.number("a number of rows");
    const std::uint64_t columns = tokens.number("a number of columns");
    if (rows != columns) {
      tokens.fail(fmt::format("a graph's matrix is square, this one is {} by {}", rows, columns));
    }
    const std::uint64_t count = tokens.number("a number of entries");
    tokens.expect_done("the sizes");
    entries_.begin(rows);
    return count;
  }

  Graph read_symmetric(std::uint64_t count) {
    entries_.expect_edges(count);
    for (;;) {
      entries_.read_plain_edges(input_, "", count - entries_.num_edges());
      if (entries_.num_edges() == count) return entries_.finish();
      Tokens tokens(input_, next_entry(count, entries_.num_edges()));
      entries_.read_edge(tokens);
      tokens.expect_done("the entry");
    }
  }

  Graph read_general(std::uint64_t count) {
    arcs_.begin(count);
    for (;;) {
      read_plain_pairs(input_, "", count - arcs_.num_arcs(), [&](auto u, auto v, auto line) {
        if (!entries_.accepts(u, v, line)) return false;
        arcs_.add(static_cast<Vertex>(u - 1), static_cast<Vertex>(v - 1), line);
        return true;
      });
      if (arcs_.num_arcs() == count) return arcs_.finish(entries_.checked_n());
      Tokens tokens(input_, next_entry(count, arcs_.num_arcs()));
      const auto [u, v] = entries_.read_ends(tokens);
      tokens.expect_done("the entry");
      arcs_.add(u, v, input_.line());
    }
  }

  EdgeCollector entries_;
  ArcCollector arcs_;
};

void append_matrix_market(OutputFile& output, const Graph& graph, unsigned) {
  std::string& out = output.pending();
  out += fmt::format("{} matrix coordinate pattern symmetric\n{} {} {}\n", kBanner,
                     graph.num_vertices(), graph.num_vertices(), graph.num_edges());
  for (const auto [u, v] : graph.edges()) {  // the lower triangle
    const auto [low, high] = std::minmax(u, v);
    append_all(out, std::uint64_t{high} + 1, ' ', std::uint64_t{low} + 1, '\n');
    output.flush_if_full();
  }
}

}  // namespace

GraphFormat matrix_market_format() {
  return {.name = "matrixmarket",
          .extensions = {".mtx"},
          .summary = "Matrix Market: the adjacency matrix as coordinate pattern symmetric",
          .detect = [](const InputHead& head) { return is_banner(head.text); },
          .parser = make_parser<MatrixMarketParser>,
          .writer = make_appending<append_matrix_market>};
}

}  // namespace ar3d
