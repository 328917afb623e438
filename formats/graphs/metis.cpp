// METIS: a line "n m [fmt [ncon]]", then n lines with the neighbours of a vertex each, 1-based;
// comments begin with %. Weights and sizes are read over. Reference: METIS (gpmetis).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/formats/graphs/arc_collector.h"
#include "ar3d/formats/graphs/plain_lines.h"
#include "ar3d/formats/text/output.h"
#include "ar3d/formats/text/tokens.h"

namespace ar3d {
namespace {

constexpr std::uint64_t kMetisVertices = 0xfffffffe;
/// The comment that our writer puts before every graph.
constexpr std::string_view kMetisMark = "% METIS graph, 1-based";

class MetisParser final : public GraphParser {
 public:
  MetisParser(TextInput& input, const ReadOptions& options)
      : GraphParser(input, options), arcs_(input, options, 1) {}

  std::optional<Graph> next() override {
    if (!read_header()) return std::nullopt;
    arcs_.begin(2 * std::min(m_, kMetisVertices));
    for (std::uint64_t v = read_plain(0); v < n_; v = read_plain(v + 1)) read_row(v);
    if (!arcs_.simplifies() && arcs_.num_arcs() % 2 == 0 && arcs_.num_arcs() / 2 != m_) {
      input_.fail_at(header_line_, 0,
                     fmt::format("{} edges announced, found {}", m_, arcs_.num_arcs() / 2));
    }
    return arcs_.finish(n_);
  }

 private:
  bool read_header() {
    const std::optional<std::string_view> line = next_telling_line(input_);
    if (!line) return false;
    header_line_ = input_.line();
    Tokens tokens(input_, *line);
    n_ = tokens.number("a number of vertices");
    if (n_ > kMetisVertices) {
      tokens.fail(fmt::format("{} vertices are too many, the limit is {}", n_, kMetisVertices));
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
    if (constraints > kMetisVertices)
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

  ArcCollector arcs_;
  std::uint64_t n_ = 0;
  std::uint64_t m_ = 0;
  std::uint64_t header_line_ = 0;
  std::uint64_t skipped_per_row_ = 0;  // sizes and weights before the neighbours
  bool edge_weights_ = false;
};

void append_metis(OutputFile& output, const Graph& graph, unsigned) {
  std::string& out = output.pending();
  out += fmt::format("{}\n{} {}\n", kMetisMark, graph.num_vertices(), graph.num_edges());
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    const char* separator = "";
    for (const HalfEdge& half : graph.incident(v)) {
      append_all(out, std::exchange(separator, " "), std::uint64_t{half.to} + 1);
    }
    out += '\n';
    output.flush_if_full();
  }
}

/// The numbers of a line; nothing if there is another word or a number of more than 64 bits.
std::optional<std::vector<std::uint64_t>> numbers_of(std::string_view line) {
  constexpr std::string_view kSpace = " \t\r\v\f";
  std::vector<std::uint64_t> numbers;
  for (;;) {
    const std::size_t first = line.find_first_not_of(kSpace);
    if (first == std::string_view::npos) return numbers;
    line.remove_prefix(first);
    std::uint64_t value = 0;
    const auto [stop, error] = std::from_chars(line.data(), line.data() + line.size(), value);
    if (error != std::errc()) return std::nullopt;
    line.remove_prefix(static_cast<std::size_t>(stop - line.data()));
    if (!line.empty() && kSpace.find(line[0]) == std::string_view::npos) return std::nullopt;
    numbers.push_back(value);
  }
}

/// Takes the next whole line that is no comment from the text.
std::optional<std::string_view> take_line(std::string_view& text, bool whole) {
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos && !whole) return std::nullopt;
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (!is_comment(line)) return line;
  }
  return std::nullopt;
}

/// Whether the ids in the lines behind the header of a text are from 1 to n; whether it is whole, a
/// line for each vertex, each edge at both of its ends, m of them; and whether the lines may be edges,
/// each of two numbers, or none, and no pair twice.
std::array<bool, 3> metis_fit(std::string_view text, bool whole, std::uint64_t n, std::uint64_t m) {
  using Arc = std::pair<std::uint64_t, std::uint64_t>;
  bool ids_fit = true, may_be_edges = true;
  std::vector<Arc> arcs, pairs;
  std::uint64_t rows = 0;
  for (auto line = take_line(text, whole); line && rows < n; line = take_line(text, whole)) {
    const auto row = numbers_of(*line);
    if (!row) return {false, false, true};
    ++rows;
    for (const std::uint64_t id : *row) {
      ids_fit = ids_fit && id >= 1 && id <= n;
      arcs.emplace_back(rows, id);
    }
    if (row->size() == 2)
      pairs.emplace_back(std::min(row->at(0), row->at(1)), std::max(row->at(0), row->at(1)));
    if (row->size() != 2 && !row->empty()) may_be_edges = false;
  }
  std::ranges::sort(pairs);
  may_be_edges = may_be_edges && std::ranges::adjacent_find(pairs) == pairs.end();
  std::vector<Arc> back;
  for (const auto& [u, v] : arcs) back.emplace_back(v, u);
  std::ranges::sort(arcs);
  std::ranges::sort(back);
  const bool has_loop =
      std::ranges::any_of(arcs, [](const Arc& arc) { return arc.first == arc.second; });
  const bool is_whole =
      !has_loop && (!whole || (rows == n && arcs == back && arcs.size() == 2 * m));
  return {ids_fit, is_whole, may_be_edges};
}

/// True for METIS, false for edge lists, both being numbers: by our mark, or if only one of
/// them fits, else by the ending. A text that can be neither passes for an edge list.
/// @throws InputError, without the file's name, if both fit and the ending says nothing.
bool looks_like_metis(const InputHead& head) {
  if (head.text.starts_with(kMetisMark)) return true;
  const bool is_konect = head.text.starts_with("% sym") || head.text.starts_with("% asym");
  if (head.is_list || is_konect) return false;
  std::string_view text = head.text;
  std::optional<std::string_view> line = take_line(text, head.whole);
  while (line && is_blank(*line)) line = take_line(text, head.whole);
  if (!line) return false;
  const auto header = numbers_of(*line);
  if (!header || header->size() < 2 || header->size() > 4) return false;
  const std::uint64_t n = header->front();
  const std::uint64_t m = header->at(1);
  if (header->size() > 2) {  // with weights; or an edge with one
    const bool is_format =
        fmt::format("{}", header->at(2)).find_first_not_of("01") == std::string::npos;
    return is_format && head.ending != "edgelist" && (n > 0 || m == 0);
  }
  if (n == 0 || m == 0) return false;  // a loop or an edge of an edge list, or its header
  const auto [ids_fit, is_whole, may_be_edges] = metis_fit(text, head.whole, n, m);
  if (!ids_fit) return false;
  if (!may_be_edges || head.ending == "metis") return true;
  if (!is_whole || head.ending == "edgelist") return false;
  throw InputError("this may be METIS or an edge list: --from metis or --from edgelist says which");
}

}  // namespace

GraphFormat metis_format() {
  return {.name = "metis",
          .extensions = {".metis", ".graph"},
          .summary = "METIS: a line \"n m\", then the neighbours of each vertex, 1-based",
          .detect = looks_like_metis,
          .parser = make_parser<MetisParser>,
          .writer = make_appending<append_metis>};
}

}  // namespace ar3d
