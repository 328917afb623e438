#include "ar3d/formats/graphs/metis.h"

#include <fmt/format.h>

#include <algorithm>

#include "ar3d/formats/graphs/arc_collector.h"
#include "ar3d/formats/graphs/metis_detection.h"
#include "ar3d/formats/graphs/plain_rows.h"
#include "ar3d/formats/text/line_shapes.h"
#include "ar3d/formats/text/numbers_text.h"

namespace ar3d {
namespace {

constexpr std::uint64_t kMaxVertices = 0xfffffffe;

class MetisParser final : public GraphParser {
 public:
  MetisParser(TextInput& input, const ReadOptions& options)
      : input_(input), arcs_(input, options, 1, ArcCollector::Rule::both_ends) {}

  std::optional<Graph> next() override {
    if (!read_header()) return std::nullopt;
    arcs_.begin(2 * std::min(m_, kMaxVertices));
    for (std::uint64_t v = read_plain(0); v < n_; v = read_plain(v + 1)) read_row(v);
    if (!arcs_.simplifies() && arcs_.num_arcs() % 2 == 0 && arcs_.num_arcs() / 2 != m_) {
      input_.fail_at(header_line_, 0,
                     fmt::format("{} edges announced, found {}", m_, arcs_.num_arcs() / 2));
    }
    return arcs_.finish(n_);
  }

 private:
  bool read_header() {
    std::optional<std::string_view> line = input_.next_line();
    while (line && (is_blank(*line) || is_comment(*line))) line = input_.next_line();
    if (!line) return false;
    header_line_ = input_.line();
    Tokens tokens(input_, *line);
    n_ = tokens.number("a number of vertices");
    if (n_ > kMaxVertices) {
      tokens.fail(fmt::format("{} vertices are too many, the limit is {}", n_, kMaxVertices));
    }
    m_ = tokens.number("a number of edges");
    skipped_per_row_ = 0;
    edge_weights_ = false;
    if (!tokens.done()) read_weights(tokens);
    tokens.expect_done("the header");
    return true;
  }

  /// The header's "fmt [ncon]": digits for vertex sizes, vertex weights, edge weights.
  void read_weights(Tokens& tokens) {
    const std::string_view fmt_word = tokens.word();
    if (fmt_word.size() > 3 || fmt_word.find_first_not_of("01") != std::string_view::npos) {
      tokens.fail(fmt::format("expected a format of up to three digits 0 and 1, found {}",
                              shown(fmt_word)));
    }
    const std::string digits = std::string(3 - fmt_word.size(), '0') + std::string(fmt_word);
    std::uint64_t constraints = 1;
    if (!tokens.done()) constraints = tokens.number("a number of weights a vertex");
    if (constraints > kMaxVertices)
      tokens.fail(fmt::format("{} weights a vertex are too many", constraints));
    skipped_per_row_ = (digits[0] == '1' ? 1 : 0) + (digits[1] == '1' ? constraints : 0);
    edge_weights_ = digits[2] == '1';
  }

  /// Reads the plain rows from v on. @return the first row not read.
  std::uint64_t read_plain(std::uint64_t v) {
    if (skipped_per_row_ > 0 || edge_weights_) return v;
    const std::uint64_t first = v;
    return first + read_plain_rows(input_, false, n_ - v, [&](auto, const auto& ids, auto line) {
             for (const std::uint64_t id : ids) {
               if (id - 1 >= n_ || (id - 1 == v && !arcs_.simplifies())) return false;
             }
             for (const std::uint64_t id : ids) {
               arcs_.add(static_cast<Vertex>(v), static_cast<Vertex>(id - 1), line);
             }
             ++v;
             return true;
           });
  }

  void read_row(std::uint64_t v) {
    std::optional<std::string_view> line = input_.next_line();
    while (line && is_comment(*line)) line = input_.next_line();
    if (!line) input_.fail(0, fmt::format("the text ends after {} of {} vertices", v, n_));
    Tokens tokens(input_, *line);
    for (std::uint64_t i = 0; i < skipped_per_row_; ++i) tokens.number("a weight");
    while (!tokens.done()) {
      const std::uint64_t id = tokens.number("a vertex id");
      if (id < 1 || id > n_) {
        tokens.fail(fmt::format("vertex id {} is out of range 1 to {}", id, n_));
      }
      if (id == v + 1 && !arcs_.simplifies()) {
        tokens.fail(fmt::format("edge ({0}, {0}) is a loop", id));
      }
      arcs_.add(static_cast<Vertex>(v), static_cast<Vertex>(id - 1), input_.line());
      if (edge_weights_) tokens.number("the weight of an edge");
    }
  }

  TextInput& input_;
  ArcCollector arcs_;
  std::uint64_t n_ = 0;
  std::uint64_t m_ = 0;
  std::uint64_t header_line_ = 0;
  std::uint64_t skipped_per_row_ = 0;  // sizes and weights before the neighbours
  bool edge_weights_ = false;
};

class MetisWriter final : public GraphWriter {
 public:
  explicit MetisWriter(OutputFile& output) : output_(output) {}
  void write(const Graph& graph) override {
    std::string& out = output_.pending();
    out += fmt::format("{}\n{} {}\n", kMetisMark, graph.num_vertices(), graph.num_edges());
    for (Vertex v = 0; v < graph.num_vertices(); ++v) {
      const char* separator = "";
      for (const HalfEdge& half : graph.incident(v)) {
        out += separator;
        append_number(out, std::uint64_t{half.to} + 1);
        separator = " ";
      }
      out += '\n';
      output_.flush_if_full();
    }
  }

 private:
  OutputFile& output_;
};

}  // namespace

GraphFormat metis_format() {
  return {
      .name = "metis",
      .extensions = {".metis", ".graph"},
      .summary = "METIS: a line \"n m\", then the neighbours of each vertex, 1-based",
      .detect = looks_like_metis,
      .parser = [](TextInput& input, const ReadOptions& options) -> std::unique_ptr<GraphParser> {
        return std::make_unique<MetisParser>(input, options);
      },
      .writer = [](OutputFile& output, const WriteOptions&) -> std::unique_ptr<GraphWriter> {
        return std::make_unique<MetisWriter>(output);
      }};
}

}  // namespace ar3d
