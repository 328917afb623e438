// Lists of edges, one a line, as words or as the columns of a table (list_graph.h). A line "# vertices N"
// begins a graph with N vertices, ids from 0; a list without it is read as a whole before it is
// decided whether its ids are numbers, from which one they count, and whether its first line is an
// edge. Reference: networkx (read_edgelist) and igraph (ncol) for words, pandas (read_csv) for tables.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "ar3d/formats/graphs/list_graph.h"
#include "ar3d/formats/text/output.h"
#include "ar3d/formats/text/tokens.h"

namespace ar3d {
namespace {

constexpr const char* kCommentOrName =
    "{} is a comment or begins with a name: --from edgelist reads a comment, quotes tell a name";

class EdgeListParser final : public GraphParser {
 public:
  EdgeListParser(TextInput& input, const ReadOptions& options)
      : GraphParser(input, options),
        graph_(input, options_, shape_,
               [this](std::uint64_t line, const std::string& text) { note(line, text); }) {
    shape_.is_forced = !options.format.empty();
    shape_.is_told = shape_.is_forced || told_format(input.name()) == "edgelist";
    is_of_names_ = !shape_.is_forced && input.name().find(".ncol") != std::string::npos;
  }

  std::optional<Graph> next() override {
    graph_.begin(std::nullopt, options_.base.value_or(0), is_of_names_);
    shape_.heading.reset();
    bool has_begun = false;
    while (const std::optional<std::string_view> line = next_odd_line()) {
      if (is_blank(*line)) continue;
      if (const std::optional<SizeLine> sizes = size_line(input_, *line)) {
        if (has_begun || graph_.num_rows() > 0) {
          input_.put_back();
          break;
        }
        begin_with(*sizes);
        has_begun = true;
      } else if (is_comment(*line)) {
        read_comment(*line);
      } else {
        read_line(*line);
      }
    }
    if (!has_begun && graph_.num_rows() == 0) return std::nullopt;
    refuse_unclear_comment();
    return graph_.finish();
  }
  std::vector<std::string> names() const override { return graph_.names(); }

 private:
  void begin_with(const SizeLine& sizes) {
    if (sizes.base && options_.base && *sizes.base != *options_.base) {
      input_.fail(0, fmt::format("ids are from {}, but --base is {}", *sizes.base, *options_.base));
    }
    graph_.begin(sizes.n, sizes.base.value_or(options_.base.value_or(0)), false);
    shape_.cut = {};
    shape_.columns = 0;
  }

  /// The next line that is not read as one of many plain edges.
  std::optional<std::string_view> next_odd_line() {
    const bool is_plain = shape_.cut.separator == 0 || shape_.cut.separator == '\t';
    if (graph_.num_rows() > 0 && !graph_.is_named() && is_plain && shape_.columns <= 2 &&
        !shape_.heading) {
      graph_.read_plain_edges();
    }
    return input_.next_line();
  }

  void read_comment(std::string_view line) {
    if (line[0] == '%' && graph_.num_rows() > 0 && !shape_.is_forced) {
      input_.fail(1,
                  fmt::format("{} below a row may be a comment or an edge: --from edgelist reads "
                              "a comment",
                              shown(line)));
    }
    if (is_of_names_) {
      input_.fail(1, fmt::format("{} begins with a name in .ncol: --from edgelist reads a comment",
                                 shown(line)));
    }
    const std::size_t word = line.find_first_not_of(" \t", 1);
    if (word == 1 && graph_.num_rows() == 0 && unclear_.text.empty()) {
      unclear_ = {std::string(line), input_.line()};
    }
    const bool is_one_word = word != std::string_view::npos && word > 1 &&
                             line.find_first_of(" \t", word) == std::string_view::npos;
    if (line[0] == '%' && !shape_.is_forced && !graph_.stated().is_konect && !graph_.has_size()) {
      const ListRow row = RowCut{}(input_, line);  // "% 0" and "% 0 {}" are edges in other programs
      if (row.size() == 2 || (row.size() == 3 && is_attribute(row[2]))) {
        input_.fail(1, fmt::format(kCommentOrName, shown(line)));
      }
    }
    if (graph_.num_rows() == 0 && !shape_.heading) {
      is_like_lgl_ = is_like_lgl_ || (input_.line() == 1 && line[0] == '#' && is_one_word);
    } else if (!has_columns(line) && !shape_.is_forced && line[0] == '#' &&
               (word == std::string_view::npos || is_one_word)) {
      if (word == std::string_view::npos) {
        input_.fail(0,
                    "a line '#' between rows: this is Trivial Graph Format (TGF), which is not "
                    "read, or an empty comment; --from edgelist reads it as an edge list");
      }
      if (is_like_lgl_) {
        input_.fail(0, fmt::format("a second line such as {}: this is LGL, which is not read; "
                                   "igraph makes GraphML of it: Graph.Read_Lgl(FILE)"
                                   ".write_graphml(OUTPUT)",
                                   shown(line)));
      }
    } else if (!shape_.is_forced && (graph_.is_named() || shape_.cut.separator != 0) &&
               (line[0] == '%' || word == 1 || has_columns(line))) {
      input_.fail(1, fmt::format(kCommentOrName, shown(line)));
    }
    graph_.stated().read(input_, line);
  }

  /// Is that comment cut into as many fields as the table has columns?
  bool has_columns(std::string_view line) const {
    const auto separators = std::ranges::count(line, shape_.cut.separator);
    return shape_.cut.separator != 0 &&
           static_cast<std::size_t>(separators) + 1 == std::max<std::size_t>(shape_.columns, 2);
  }

  /// @throws InputError if a comment above the rows of a table of names is one of its rows as well.
  void refuse_unclear_comment() {
    const auto [text, line] = std::exchange(unclear_, {});
    if (text.empty() || shape_.is_forced || shape_.cut.separator == 0 || shape_.heading) return;
    // "#0,1" above numbers is an edge that the writer has taken out.
    const bool is_of_names =
        graph_.is_named() || text[1] == shape_.cut.separator || text.find('"') != std::string::npos;
    if (!is_of_names || is_heading_of_ends(std::string_view(text).substr(1))) return;
    if (text.find(shape_.cut.separator) == std::string::npos) return;
    input_.fail_at(line, 1, fmt::format(kCommentOrName, shown(text)));
  }

  void read_line(std::string_view line) {
    if (graph_.num_rows() == 0 && shape_.columns == 0) {
      shape_.cut = cut_of(input_, line);
      shape_.columns = 0;
    }
    const ListRow row = shape_.cut(input_, line);
    if (graph_.num_rows() == 0 && !shape_.heading && read_heading(row)) return;
    const EndColumns ends = shape_.heading.value_or(kFirstColumns);
    check_columns(row, ends);
    const ListField& a = row[ends[0]];
    const ListField& b = row[ends[1]];
    for (const ListField* end : {&a, &b}) {
      if (const auto problem = end_problem(*end, shape_.is_headed_table))
        input_.fail(end->column, *problem);
    }
    refuse_row_names(row, a, b);
    graph_.add(row, a, b);
  }

  /// True if the first row is a heading and no edge; else it may still be one.
  bool read_heading(const ListRow& row) {
    const std::optional<EndColumns> known = ends_of_heading(row);
    shape_.is_headed_table = known && shape_.cut.separator != 0;
    shape_.columns = shape_.cut.separator != 0 ? row.size() : 0;
    const bool may_be_edge = row.size() == 2 || (row.size() == 3 && is_attribute(row[2]));
    if (may_be_edge || !known || options_.first_line == FirstLine::edge) return false;
    shape_.heading = known;
    shape_.columns = row.size();
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (row[i].text == "Type" || row[i].text == "type") shape_.type_column = i;
    }
    graph_.note_heading(input_.line(), row);
    return true;
  }
  void check_columns(const ListRow& row, EndColumns ends) {
    const bool is_short = row.size() < 2 || row.size() <= std::max(ends[0], ends[1]);
    if (is_short) {
      input_.fail(0, "expected two ends of an edge, found the end of the line");
    }
    if (shape_.columns > 0 && row.size() != shape_.columns &&
        !(row.size() > 2 && row.back().text.starts_with('{'))) {
      input_.fail(0, fmt::format("{} fields, but {} in the first row", row.size(), shape_.columns));
    }
    if (shape_.heading) {
      if (shape_.type_column < row.size() && plain_type(row[shape_.type_column].text) == 'd' &&
          !options_.undirected) {
        input_.fail(row[shape_.type_column].column,
                    "directed edges are not read (--undirected drops directions)");
      }
      return;
    }
    if (row.size() > 3 && shape_.cut.separator != 0) {
      input_.fail(0, fmt::format("{} columns and no heading that says which two are the ends of "
                                 "edges: 'source' and 'target' do",
                                 row.size()));
    }
    if (row.size() > 2) check_attributes(row);
  }
  static char plain_type(const std::string& text) {
    return text.empty() ? ' ' : static_cast<char>(text[0] | 0x20);
  }
  void check_attributes(const ListRow& row) {
    // Three ids or a weight? Only a list that is called one, or a table, has whole weights.
    const bool may_be_whole =
        shape_.cut.separator != 0 || shape_.is_told || graph_.stated().is_konect;
    const bool is_whole = row[2].text.find_first_not_of("-0123456789") == std::string::npos;
    const bool is_good = is_attribute(row[2]) && (may_be_whole || !is_whole);
    const bool has_time = graph_.stated().is_konect && row.size() == 4 && is_attribute(row[3]);
    if (is_good && (row.size() == 3 || has_time)) return;
    const ListField& odd = row[is_good ? 3 : 2];
    input_.fail(odd.column, fmt::format("unexpected {} after the edge", shown(odd.text)));
  }
  /// "1",0,1 of R: the row's name, and behind it the edge.
  void refuse_row_names(const ListRow& row, const ListField& a, const ListField& b) const {
    if (shape_.heading || row.size() < 3 || !a.is_quoted || b.is_quoted) return;
    if (!is_whole_number(a.text) || !is_whole_number(b.text)) return;
    input_.fail(a.column, fmt::format("\"{}\" may be the name of a row and no end of an edge: a "
                                      "heading 'source' and 'target' tells",
                                      a.text));
  }

  ListShape shape_;
  bool is_of_names_ = false;  // by the ending: ids are names whatever they are
  struct {
    std::string text;
    std::uint64_t line = 0;
  } unclear_;  // the first comment whose mark stands at a word, above all rows
  bool is_like_lgl_ = false;
  ListGraph graph_;
};

void append_edge_list(OutputFile& output, const Graph& graph, unsigned base) {
  append_all(output.pending(), "# vertices ", graph.num_vertices(), base == 1 ? " from 1\n" : "\n");
  append_edges(output, graph, {"", " ", "\n"}, base);
}

/// Numbers, quotes, a heading, or whatever the ending calls an edge list; the last format asked, so
/// that an odd line is reported by its number.
bool looks_like_edge_list(const InputHead& head) {
  const std::string_view line = head.body.substr(0, head.body.find_first_of("\r\n"));
  if (is_blank(line) || head.ending == "edgelist") return true;
  const char first = line[line.find_first_not_of(" \t")];
  return is_digit(first) || first == '-' || first == '"' || is_heading_of_ends(line);
}

}  // namespace

GraphFormat edge_list_format() {
  return {.name = "edgelist",
          .extensions = {".edges", ".edgelist", ".el", ".txt"},
          .summary =
              "one edge \"u v\", \"u,v\" or \"u;v\" per line, a weight behind it is skipped; "
              "tables by their headings; # or % comments, \"# vertices N\" begins a graph",
          .detect = looks_like_edge_list,
          .parser = make_parser<EdgeListParser>,
          .writer = make_appending<append_edge_list>};
}

}  // namespace ar3d
