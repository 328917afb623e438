#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ar3d/formats/graphs/edge_collector.h"
#include "ar3d/formats/graphs/word_text.h"
#include "ar3d/formats/text/text_input.h"

namespace ar3d {

/// A field of a row of a list, without its quotes.
struct ListField {
  std::string text;
  std::size_t column = 1;  ///< where it begins in the line
  bool is_quoted = false;
};
using ListRow = std::vector<ListField>;

/// How the lines of a list are cut into fields, which holds for all of them.
struct RowCut {
  char separator = 0;       ///< between the fields; 0: blanks and tabs
  bool has_quotes = false;  ///< words may stand in quotes; fields between separators always may

  /// From a { at the third field or later to a } at the end of the line is one field: attributes
  /// of networkx. @throws InputError for a quote without its other one, or with a name behind it.
  ListRow operator()(const TextInput& input, std::string_view line) const;
};

/// Returns the one way in which the first row of a list can be cut: two ends, maybe with a weight
/// or attributes, or a heading. @throws InputError if there are two ways.
RowCut cut_of(const TextInput& input, std::string_view line);

/// The columns that are the ends of edges, such as source and target of a heading.
using EndColumns = std::array<std::size_t, 2>;
constexpr EndColumns kFirstColumns = {0, 1};
std::optional<EndColumns> ends_of_heading(const ListRow& row);

/// True if the line is a heading that names the ends, however it is cut.
bool is_heading_of_ends(std::string_view line);

/// A weight: any number, written as programs write them.
bool is_list_number(std::string_view text);
/// Digits without a zero in front.
bool is_whole_number(std::string_view text);
/// True for what stands behind an edge: attributes, a weight, or nothing between two separators.
bool is_attribute(const ListField& field);
/// Why that field is no end of an edge in any list; nothing if it may be one.
/// @param is_headed  in a table whose heading names the ends: brackets are those of a name.
std::optional<std::string> end_problem(const ListField& field, bool is_headed = false);

/// The counts of vertices and edges that a comment at a list's head states.
struct StatedCounts {
  struct Count {
    std::uint64_t count = 0;
    std::uint64_t line = 0;
  };
  std::optional<Count> vertices, edges;
  bool is_konect = false;    ///< its ids are from 1
  bool is_directed = false;  ///< KONECT's "asym", SNAP's "Directed graph"

  /// @throws InputError for a list of KONECT whose two sides are numbered each from 1.
  void read(const TextInput& input, std::string_view comment);
};

/// How a list is written, as far as its name, the options and its first row tell.
struct ListShape {
  bool is_forced = false;  ///< by --from
  bool is_told = false;    ///< by that, or by the file's ending
  RowCut cut;
  std::size_t columns = 0;            ///< that every row has; 0: two, maybe more
  std::optional<EndColumns> heading;  ///< that says which columns are ends
  bool is_headed_table = false;       ///< the first row of a table may be such a heading
  std::size_t type_column = std::numeric_limits<std::size_t>::max();  ///< directed or not
};

/// Gathers the rows of an edge list and decides, when all are known, what the first one is, whether
/// ids are numbers or names, from which number they count, and how many vertices there are.
class ListGraph {
 public:
  using Note = std::function<void(std::uint64_t line, const std::string& text)>;
  /// @param shape  may change as long as there is no row.
  ListGraph(TextInput& input, const ReadOptions& options, const ListShape& shape, Note note)
      : input_(&input),
        options_(options),
        shape_(&shape),
        note_(std::move(note)),
        edges_(input, options, options.base.value_or(0)) {}

  /// Begins a graph. @param n  from a size line. @param is_named  ids are names, whatever
  /// they are.
  void begin(std::optional<std::uint64_t> n, unsigned base, bool is_named);
  /// Takes a row; its ends are ends in any list. @throws InputError if they are none in this one.
  void add(const ListRow& row, const ListField& a, const ListField& b);
  /// Takes lines of two numbers as fast as they can be read.
  void read_plain_edges();
  /// Ends the graph. @throws InputError if two readings fit, or none. O(m log m).
  Graph finish();

  StatedCounts& stated() { return stated_; }
  std::uint64_t num_rows() const { return rows_; }
  bool is_named() const { return is_named_; }
  /// Has a line "# vertices N" begun the graph?
  bool has_size() const { return known_n_.has_value(); }
  std::vector<std::string> names() const { return named_.names(); }

  void note_heading(std::uint64_t line, const ListRow& row) const;

 private:
  /// The first row of a graph that no size line begins: an edge, a header "n m" or a heading.
  struct First {
    ListRow fields;
    std::uint64_t line = 0;
    std::uint64_t n = 0;  ///< both ends, if they are numbers
    std::uint64_t m = 0;
    std::string problem;         ///< why the numbers are no edge; empty: it is collected as one
    EdgeCollector::Range range;  ///< of its edge
  };

  void look_at_columns(const ListRow& row, const ListField& a, const ListField& b);
  void refuse_counted_rows() const;
  void require_names(const ListField& a, const ListField& b) const;
  void become_names(const ListField& a, const ListField& b);
  void take_numbers_as_names();
  static bool is_numbers(const First& first);
  void refuse_unclear_ends(const ListField& a, const ListField& b, std::uint64_t line) const;
  void join(const ListField& a, const ListField& b);
  void read_numbers(const ListRow& row, const ListField& a, const ListField& b);
  std::optional<std::uint64_t> number_of(const ListField& field) const;
  void add_numbers(std::uint64_t u, const ListField& a, std::uint64_t v, const ListField& b);
  void decide_heading();
  void drop_heading(const First& first);
  void decide_first_line();
  void decide_ids();
  void decide_ids_by_head(std::uint64_t n);
  void settle(std::uint64_t n, unsigned base);
  void settle_from_one(std::uint64_t n, std::uint64_t line);
  void note_missing(std::uint64_t n, std::uint64_t line) const;

  TextInput* input_;
  ReadOptions options_;  // a copy: the caller's may be a temporary
  const ListShape* shape_;
  Note note_;
  EdgeCollector edges_;
  std::optional<std::uint64_t> known_n_;  // by a size line, or settled
  std::uint64_t rows_ = 0;                // of edges, the first row among them
  std::size_t most_fields_ = 0;           // of a row behind the first one
  bool is_counted_ = false;               // the first of three columns counts the rows ...
  std::uint64_t first_count_ = 0;         // ... from here
  std::uint64_t whole_weight_line_ = 0;   // the first one with such a weight behind two words
  bool has_bare_row_ = false;             // one without
  std::optional<First> first_;
  StatedCounts stated_;
  bool is_named_ = false;
  GatheredGraph named_;  // instead of edges_, of a list of names
};

}  // namespace ar3d
