// A vertex a line with its neighbours: "u: v w …" of numbers (House of Graphs), or "u v w …" of
// networkx, of any names. Every vertex has a line of its own, so the lines say which vertices there
// are, and a list cut short is refused. An edge stands at one of its ends, or all do at both.
// Reference: networkx (read_adjlist).
#include <fmt/format.h>

#include <limits>

#include "ar3d/formats/graphs/arc_collector.h"
#include "ar3d/formats/graphs/edge_collector.h"
#include "ar3d/formats/graphs/list_graph.h"
#include "ar3d/formats/graphs/plain_lines.h"
#include "ar3d/formats/graphs/word_text.h"
#include "ar3d/formats/text/output.h"
#include "ar3d/formats/text/tokens.h"

namespace ar3d {
namespace {

/// A number and a colon behind it begin the line.
bool has_colon(std::string_view line) {
  const std::size_t number = line.find_first_not_of(" \t");
  if (number == std::string_view::npos || !is_digit(line[number])) return false;
  const std::size_t behind = line.find_first_not_of("0123456789", number);
  const std::size_t colon = line.find_first_not_of(" \t", behind);
  return behind != std::string_view::npos && colon != std::string_view::npos && line[colon] == ':';
}

class AdjacencyListParser final : public GraphParser {
 public:
  AdjacencyListParser(TextInput& input, const ReadOptions& options)
      : GraphParser(input, options), ids_(input, options, 0), arcs_(input, options, 0, true) {}

  std::optional<Graph> next() override {
    begin();
    while (const std::optional<std::string_view> line = next_odd_line()) {
      if (is_blank(*line)) continue;
      if (const std::optional<SizeLine> sizes = size_line(input_, *line)) {
        if (sizes_ || rows_ > 0) {
          input_.put_back();
          break;
        }
        sizes_ = sizes;
        sizes_line_ = input_.line();
        if (sizes->base && options_.base && *sizes->base != *options_.base) {
          input_.fail(
              0, fmt::format("ids are from {}, but --base is {}", *sizes->base, *options_.base));
        }
      } else if (is_comment(*line)) {
        is_of_networkx_ = is_of_networkx_ || line->starts_with("# GMT ");
        if ((*line)[0] == '%' && (rows_ > 0 || is_of_networkx_)) {
          input_.fail(1, fmt::format("{} is a comment or begins with a name: # begins a comment",
                                     shown(*line)));
        }
      } else {
        if (rows_ == 0) is_numbers_ = !is_of_networkx_ && has_colon(*line);
        read_row(*line);
      }
    }
    if (!sizes_ && rows_ == 0) return std::nullopt;
    return is_numbers_ || rows_ == 0 ? finish_numbers() : finish_words();
  }
  std::vector<std::string> names() const override {
    return is_numbers_ ? std::vector<std::string>() : named_.names();
  }

 private:
  void begin() {
    named_ = GatheredGraph();
    ids_.begin(std::nullopt);
    arcs_.begin();
    row_lines_.clear();
    sizes_.reset();
    rows_ = 0;
  }

  /// The next line that is not read as one of many plain rows.
  std::optional<std::string_view> next_odd_line() {
    constexpr std::uint64_t kAll = std::numeric_limits<std::uint64_t>::max();
    if (rows_ > 0 && is_numbers_) {
      read_plain_rows(input_, true, kAll, [&](auto u, const auto& row, auto line) {
        if (row.empty()) return false;  // the careful reader's
        for (const std::uint64_t v : row) {
          if (!ids_.accepts(u, v, line)) return false;
        }
        if (!begin_row(u, line)) return false;
        for (const std::uint64_t v : row) {
          arcs_.add(static_cast<Vertex>(u), static_cast<Vertex>(v), line);
        }
        return true;
      });
    }
    return input_.next_line();
  }

  /// False if the vertex has a row, or its number is beyond what the text can account for.
  bool begin_row(std::uint64_t u, std::uint64_t line) {
    if (u >= row_lines_.size()) {
      if (vertex_count_problem(u + 1, input_.bytes(), options_)) return false;
      row_lines_.resize(std::max(u + 1, 2 * std::uint64_t{row_lines_.size()}));
    }
    if (row_lines_[u] != 0) return false;
    row_lines_[u] = static_cast<std::uint32_t>(std::min<std::uint64_t>(line, 0xffffffff));
    ++rows_;
    return true;
  }

  void read_row(std::string_view line) {
    Tokens row(input_, line);
    if (is_numbers_) {
      const std::size_t colon = line.find(':');
      Tokens vertex(input_, line.substr(0, std::min(colon, line.size())));
      const Vertex u = read_vertex(vertex);
      if (colon == std::string_view::npos) vertex.fail("expected a colon behind the vertex");
      vertex.expect_done("the vertex before the colon");
      start_row(u, vertex);
      row = Tokens(input_, line, colon + 1);
      while (!row.done()) add(u, read_vertex(row), row);
    } else {
      const Vertex u = read_vertex(row);
      start_row(u, row);
      while (!row.done()) add(u, read_vertex(row), row);
    }
  }
  void start_row(Vertex u, const Tokens& at) {
    if (begin_row(u, input_.line())) return;
    const bool is_second = u < row_lines_.size() && row_lines_[u] != 0;
    if (is_second) {
      at.fail(
          fmt::format("a second line of this vertex, after line {}: a file of several graphs "
                      "has '# vertices N' before each",
                      row_lines_[u]));
    }
    at.fail(*vertex_count_problem(std::uint64_t{u} + 1, input_.bytes(), options_));
  }
  void add(Vertex u, Vertex v, const Tokens& at) {
    if (u == v && !arcs_.simplifies())
      at.fail(fmt::format("edge ({0}, {0}) is a loop", name_of(u)));
    arcs_.add(u, v, input_.line());
  }

  Vertex read_vertex(Tokens& tokens) {
    if (is_numbers_) return ids_.read_vertex(tokens);
    const std::string_view word = tokens.word();
    const bool is_odd =
        word.ends_with(':') || word.find_first_of("{}#\"") != std::string_view::npos;
    if (is_odd || word.ends_with(',') || word.ends_with(';')) {
      tokens.fail(fmt::format("{} is no name of a list of networkx", shown(word)));
    }
    if (const auto problem = end_problem({std::string(word)})) tokens.fail(*problem);
    return named_.vertex(word);
  }

  /// @throws InputError if a neighbour has no line, or not as many have one as the head says.
  void check_rows(std::uint64_t n) const {
    arcs_.for_each([&](Vertex u, Vertex v, std::uint64_t line) {
      for (const Vertex w : {u, v}) {
        if (w < row_lines_.size() && row_lines_[w] != 0) continue;
        input_.fail_at(line, 0,
                       fmt::format("{} is a neighbour without a line of its own: is the "
                                   "list cut short? A line of it alone adds it",
                                   name_of(w)));
      }
    });
    if (!sizes_ || sizes_->n == n) return;
    input_.fail_at(sizes_line_, 0,
                   fmt::format("{} vertices stated, {} have a line: is the list cut "
                               "short?",
                               sizes_->n, n));
  }
  std::string name_of(Vertex v) const {
    return is_numbers_ ? fmt::format("{}", v) : shown(named_.id(v));
  }

  Graph finish_numbers() {
    check_rows(rows_);
    while (!row_lines_.empty() && row_lines_.back() == 0) row_lines_.pop_back();
    const std::uint64_t largest = row_lines_.size();  // + 1
    const unsigned first = rows_ > 0 && row_lines_[0] == 0 ? 1 : 0;
    const std::optional<unsigned> declared = sizes_ && sizes_->base ? sizes_->base
                                             : options_.base        ? options_.base
                                                                    : std::nullopt;
    if (largest - (rows_ > 0 ? first : 0) == rows_) {
      if (declared && rows_ > 0 && *declared != first) refuse_base(*declared);
      if (first == 1 && !declared) note(0, fmt::format("ids are from 1 to {}", rows_));
      return renumbered(largest, [&](Vertex v) { return v - first; });
    }
    if (declared) refuse_base(*declared);
    note(0,
         fmt::format("ids up to {} of {} vertices have gaps: they are names", largest - 1, rows_));
    std::vector<Vertex> index(largest);
    for (std::uint64_t v = 0; v < largest; ++v) {
      if (row_lines_[v] != 0) index[v] = named_.vertex(fmt::format("{}", v));
    }
    Graph graph = renumbered(largest, [&](Vertex v) { return index[v]; });
    is_numbers_ = false;
    return graph;
  }
  /// The graph of the rows, whose vertices are read as below n.
  template <class Index>
  Graph renumbered(std::uint64_t n, const Index& index) {
    Graph graph = arcs_.finish(n, [&](Vertex v) { return name_of(v); });
    std::vector<Edge> edges(graph.edges().begin(), graph.edges().end());
    for (Edge& edge : edges) edge = {index(edge.u), index(edge.v)};
    return Graph(rows_, std::move(edges));
  }
  [[noreturn]] void refuse_base(unsigned base) const {
    input_.fail(
        0, fmt::format("the lines are not those of vertices {} to {}", base, rows_ + base - 1));
  }

  /// Names that are all the numbers from 0 or 1 on are those.
  Graph finish_words() {
    check_rows(rows_);
    std::vector<Vertex> index(rows_);
    Vertex smallest = 1;
    for (Vertex v = 0; v < rows_; ++v) {
      const std::string& id = named_.id(v);
      const bool is_number = is_whole_number(id) && id.size() < 10 && std::stoul(id) <= rows_;
      index[v] = is_number ? static_cast<Vertex>(std::stoul(id)) : kNone;
      smallest = std::min(smallest, index[v]);
    }
    const bool are_numbers =
        std::ranges::all_of(index, [&](Vertex v) { return v < rows_ + smallest; });
    if (!are_numbers) return renumbered(rows_, [](Vertex v) { return v; });
    if (smallest == 1) note(0, fmt::format("ids are from 1 to {}", rows_));
    Graph graph = renumbered(rows_, [&](Vertex v) { return index[v] - smallest; });
    is_numbers_ = true;
    return graph;
  }

  static constexpr Vertex kNone = std::numeric_limits<Vertex>::max();
  EdgeCollector ids_;
  GatheredGraph named_;  // whose edges are arcs_
  bool is_numbers_ = true;
  bool is_of_networkx_ = false;
  std::optional<SizeLine> sizes_;
  std::uint64_t sizes_line_ = 0;
  std::uint64_t rows_ = 0;
  std::vector<std::uint32_t> row_lines_;  // by vertex: where its row stands; 0: none
  ArcCollector arcs_;
};

void append_adjacency_list(OutputFile& output, const Graph& graph, unsigned base) {
  std::string& out = output.pending();
  append_all(out, "# vertices ", graph.num_vertices(), base == 1 ? " from 1\n" : "\n");
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
/// (its other adjacency lists, of several lines a vertex, have braces); or the ending says so.
bool looks_like_adjacency_list(const InputHead& head) {
  const std::string_view line = head.body.substr(0, head.body.find('\n'));
  if (has_colon(line) || (head.ending == "adjlist" && !head.body.empty())) return true;
  const std::string_view comments(head.text.data(), head.text.size() - head.body.size());
  return !head.body.empty() && comments.find("# GMT ") != std::string_view::npos &&
         head.text.find('{') == std::string_view::npos;
}

}  // namespace

GraphFormat adjacency_list_format() {
  return {.name = "adjlist",
          .extensions = {".adj", ".adjlist", ".lst"},
          .summary = "one vertex per line with its neighbours, \"u: v w …\"",
          .detect = looks_like_adjacency_list,
          .parser = make_parser<AdjacencyListParser>,
          .writer = make_appending<append_adjacency_list>};
}

}  // namespace ar3d
