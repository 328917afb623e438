// One edge "u v" per line, or "u,v" or "u;v", maybe in quotes; a weight may follow; comments begin
// with # or %. A line "# vertices N", "% vertices N" or "n N" begins a graph with N vertices; edges
// without such a line make a graph up to the largest id.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "ar3d/base/error.h"
#include "ar3d/formats/graphs/edge_collector.h"
#include "ar3d/formats/graphs/word_text.h"
#include "ar3d/formats/text/output.h"
#include "ar3d/formats/text/tokens.h"

namespace ar3d {
namespace {

/// A blank of a name in quotes, until its line is in words.
constexpr char kBlankOfName = '\x1f';

/// The names of the columns of a list with separators: source, target, and maybe more.
bool is_heading(std::string_view line) {
  std::string columns;
  for (const char c : line.substr(0, 32)) {
    const int lower = std::tolower(static_cast<unsigned char>(c));
    if (c != '"' && c != '\r') columns += c == ';' ? ',' : static_cast<char>(lower);
  }
  return (columns + ",").starts_with("source,target,") || (columns + ",").starts_with("from,to,");
}

/// The comma or semicolon behind the line's first column; 0 if it is of no such list.
/// @param told  the file is called an edge list: names without blanks may have separators, too.
char separator_of(std::string_view line, bool told) {
  std::size_t behind = line.find_first_not_of("0123456789");
  if (line.starts_with('"')) {
    do {
      behind = line.find('"', behind + 1) + 1;
    } while (behind > 0 && line.substr(behind).starts_with('"'));
  } else if (is_heading(line) || (told && line.find_first_of(" \t") == std::string_view::npos)) {
    behind = line.find_first_of(",;");
  }
  const bool is_list = behind > 0 && behind < line.size();
  return is_list && (line[behind] == ',' || line[behind] == ';') ? line[behind] : '\0';
}

constexpr const char* kInAStudy = "in a study the keys base and first_line";

class EdgeListParser final : public GraphParser {
 public:
  EdgeListParser(TextInput& input, const ReadOptions& options)
      : GraphParser(input, options), edges_(input, options, options.base) {}

  std::optional<Graph> next() override {
    bool begun = false;
    first_.reset();
    named_ = GatheredGraph();
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
        if (!begun) {
          edges_.begin(std::nullopt);
          if (!has_heading_) separator_ = separator_of(*line, is_told());
          if (is_heading(*line)) {
            has_heading_ = true;
            continue;
          }
        }
        Tokens tokens(input_, in_words(*line));
        if (!begun) {
          if (is_of_names(tokens)) return read_named(*line);
          read_first_line(tokens);
        } else {
          edges_.read_edge(tokens);
        }
        begun = true;
        skip_attributes(tokens);
      }
    }
    if (!begun) return std::nullopt;
    if (first_) decide_first_line();
    return edges_.finish();
  }
  std::vector<std::string> names() const override { return named_.names(); }

 private:
  /// All lines to come, and this one: "alice bob", and nothing behind it but attributes or a
  /// weight.
  Graph read_named(std::string_view line) {
    for (std::optional<std::string_view> next = line; next; next = input_.next_line()) {
      if (is_blank(*next) || is_comment(*next)) continue;
      Tokens tokens(input_, in_words(*next));
      const Vertex u = named_.vertex(name_of(tokens.word()));
      if (tokens.done()) tokens.fail("expected a second name, the other end of the edge");
      named_.join(u, named_.vertex(name_of(tokens.word())), input_.line());
      Tokens rest = tokens;
      const std::string_view behind = rest.word();
      const bool is_weight = !begins_with_name(behind) && rest.done();
      if (!behind.empty() && !behind.starts_with('{') && !is_weight) tokens.expect_done("the edge");
    }
    return named_.finish(options_, false, [&](std::size_t at, const std::string& why) {
      input_.fail_at(at, 0, why);
    });
  }

  /// The first line of a graph that no size line begins.
  struct First {
    std::uint64_t a = 0;
    std::uint64_t b = 0;
    std::uint64_t line = 0;
    std::string problem;    ///< why it is no edge; empty: it is collected as one
    std::uint64_t end = 0;  ///< its largest vertex + 1
  };

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
  /// Is the file called an edge list, by its ending or by --from? Lines of three numbers and of
  /// names tell nothing.
  bool is_told() const { return !options_.format.empty() || is_named_edge_list(input_.name()); }
  /// Is the first line's first word a name? Without separators it is only where names may be.
  bool is_of_names(Tokens tokens) const {
    const std::string_view first = tokens.word();
    if (separator_ == 0) return is_told() && begins_with_name(first);
    return first.find_first_not_of("0123456789") != std::string_view::npos && first[0] != '-';
  }
  /// The line with blanks for separators and quotes, if it is of a list with such; valid until the
  /// next call. @throws InputError for a quote without its other one.
  std::string_view in_words(std::string_view line) {
    if (separator_ == 0) return line;
    row_.clear();
    std::size_t quote = 0;  // column of the one that is open
    for (std::size_t i = 0; i < line.size(); ++i) {
      const char c = line[i];
      const bool is_doubled = quote > 0 && c == '"' && line.substr(i + 1).starts_with('"');
      if (is_doubled) ++i;
      if (c == '"' && !is_doubled) quote = quote > 0 ? 0 : i + 1;
      const bool is_between = quote == 0 && c == separator_;
      row_ += is_between || (c == '"' && !is_doubled) ? ' '
              : quote > 0 && (c == ' ' || c == '\t')  ? kBlankOfName
                                                      : c;
    }
    if (quote > 0)
      input_.fail(quote, fmt::format("no quote ends {}", shown(line.substr(quote - 1))));
    return row_;
  }
  /// The word as it stands in the file, valid until the next call.
  std::string_view name_of(std::string_view word) {
    name_ = word;
    std::ranges::replace(name_, kBlankOfName, ' ');
    return name_;
  }
  /// A weight as networkx' write_weighted_edgelist has it: a number; a whole one only where the
  /// file is called an edge list.
  bool is_weight(std::string_view word) const {
    double value = 0;
    const auto read = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool is_whole = word.find_first_not_of("-0123456789") == std::string_view::npos;
    return read.ec == std::errc() && read.ptr == word.data() + word.size() &&
           std::isfinite(value) && (!is_whole || separator_ != 0 || is_told());
  }
  /// Behind an edge: "{}" or "{'weight': 2}", as networkx writes, or one weight; else it is refused.
  void skip_attributes(Tokens& tokens) const {
    Tokens rest = tokens;
    const std::string_view word = rest.word();
    if (word.starts_with('{') || (is_weight(word) && rest.done())) return;
    tokens.expect_done("the edge");
  }

  void read_first_line(Tokens& tokens) {
    Tokens ends = tokens;
    First first;
    first.a = ends.number("a vertex id");
    first.b = ends.number("a vertex id");
    first.line = input_.line();
    if (!ends.done() || has_heading_ || options_.first_line == FirstLine::edge) {
      return edges_.read_edge(tokens);
    }
    try {
      edges_.read_edge(tokens);
    } catch (const InputError& error) {
      first.problem = error.what();
      tokens = ends;
    }
    first.end = edges_.largest_end();
    edges_.forget_largest_end();
    first_ = first;
  }

  /// Header or edge, now that the graph's other lines are known.
  void decide_first_line() {
    const bool is_edge = first_->problem.empty();
    const std::uint64_t others = edges_.num_edges() - (is_edge ? 1 : 0);
    const bool wanted = options_.first_line == FirstLine::header;
    const bool fits = others == first_->b && edges_.largest_end() <= first_->a &&
                      (wanted || first_->a > 0);  // "0 0" is a loop
    if (!fits && others == first_->b && edges_.largest_end() == first_->a + 1 &&
        edges_.smallest_vertex(is_edge ? 1 : 0) > 0) {
      refuse_ids_from_one();
    }
    if (wanted && !fits) {
      input_.fail_at(first_->line, 0,
                     fmt::format("{} vertices and {} edges announced, found {} edges and ids up to "
                                 "vertex {}",
                                 first_->a, first_->b, others, edges_.largest_end()));
    }
    if (fits && is_edge && !wanted) {
      input_.fail_at(first_->line, 0,
                     fmt::format("'{0} {1}' may be an edge, or the header of a graph with {0} "
                                 "vertices and {1} edges: --first-line edge or --first-line header "
                                 "says which ({2})",
                                 first_->a, first_->b, kInAStudy));
    }
    if (fits) return edges_.first_was_header(first_->a, is_edge);
    if (!is_edge) throw InputError(first_->problem);
    edges_.note_end(first_->end, first_->line);
  }

  /// The header of ids from 1 to n would be lost, were it read as an edge of ids from 0.
  [[noreturn]] void refuse_ids_from_one() const {
    input_.fail_at(first_->line, 0,
                   fmt::format("'{0} {1}' may be the header of a graph with {0} vertices, ids 1 to "
                               "{0}, and {1} edges: --base 1 --first-line header reads it so, "
                               "--first-line edge as an edge ({2})",
                               first_->a, first_->b, kInAStudy));
  }

  EdgeCollector edges_;
  char separator_ = 0;  // between the columns; 0: blanks
  bool has_heading_ = false;
  std::string row_, name_;
  GatheredGraph named_;  // instead, of a list of names
  std::optional<First> first_;
};

void append_edge_list(OutputFile& output, const Graph& graph, unsigned base) {
  std::string& out = output.pending();
  append_all(out, "# vertices ", graph.num_vertices(), '\n');
  append_edges(output, graph, {"", " ", "\n"}, base);
}

/// Numbers or comments first; the last format asked, so that an odd line is reported by its number.
bool looks_like_edge_list(const InputHead& head) {
  const std::size_t first = head.text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return true;
  const std::string_view text = head.text.substr(first);
  return is_digit(text[0]) || is_comment(text) || text.starts_with("n ") ||
         separator_of(text.substr(0, text.find_first_of("\r\n")), false) != 0 ||
         (head.is_named_edge_list && begins_with_name(text));
}

}  // namespace

GraphFormat edge_list_format() {
  return {.name = "edgelist",
          .extensions = {".edges", ".edgelist", ".el", ".ncol", ".txt"},
          .summary =
              "one edge \"u v\", \"u,v\" or \"u;v\" per line, a weight behind it is skipped; # or "
              "% comments, "
              "\"# vertices N\" begins a graph",
          .detect = looks_like_edge_list,
          .parser = make_parser<EdgeListParser>,
          .writer = make_appending<append_edge_list>};
}

}  // namespace ar3d
