// Matrix Market, "matrix coordinate": the adjacency matrix, symmetric, or a general pattern that is.
// Reference: scipy (mmread).
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <cmath>
#include <cstdlib>

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
    const auto expect = [&](std::initializer_list<std::string_view> wanted) {
      const std::string_view word = tokens.word();
      for (const std::string_view name : wanted) {
        if (iequals(word, name)) return name;
      }
      tokens.fail(fmt::format("only '{}' is read here, found {}", fmt::join(wanted, "' or '"),
                              shown(word)));
    };
    expect({"matrix"});
    expect({"coordinate"});
    has_weights_ = expect({"pattern", "real", "integer"}) != "pattern";
    // Two weights of one edge may differ.
    const bool is_symmetric =
        (has_weights_ ? expect({"symmetric"}) : expect({"symmetric", "general"})) == "symmetric";
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

  static void read_weight(Tokens& tokens) {
    const std::string word(tokens.word());
    char* end = nullptr;
    const double weight = std::strtod(word.c_str(), &end);
    if (!word.empty() && *end == '\0' && std::isfinite(weight) && weight != 0) return;
    tokens.fail(fmt::format("expected the weight of an edge, no 0, found {}", shown(word)));
  }

  Graph read_symmetric(std::uint64_t count) {
    entries_.expect_edges(count);
    for (;;) {
      if (!has_weights_) entries_.read_plain_edges(input_, "", count - entries_.num_edges());
      if (entries_.num_edges() == count) return entries_.finish();
      Tokens tokens(input_, next_entry(count, entries_.num_edges()));
      entries_.read_edge(tokens);
      if (has_weights_) read_weight(tokens);
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

  bool has_weights_ = false;
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
          .summary = "Matrix Market: the adjacency matrix as coordinates, weights are read over",
          .detect = [](const InputHead& head) { return is_banner(head.text); },
          .parser = make_parser<MatrixMarketParser>,
          .writer = make_appending<append_matrix_market>};
}

}  // namespace ar3d
