// What the rows of an edge list mean can be said when all are known: a first row of names may be a
// heading, one of numbers a header "n m"; ids may be names, or numbers from 0 or from 1. Two readings
// that fit are refused with the options that choose, and what is assumed is noted.
#include "ar3d/formats/graphs/list_graph.h"

#include "ar3d/base/error.h"

namespace ar3d {
namespace {

constexpr const char* kInAStudy = "in a study the keys base and first_line";
constexpr const char* kBothBases =
    "no line names vertex 0, nor some others: --base 1 reads ids from 1, --base 0 keeps a vertex 0 "
    "without an edge (in a study the key base)";

}  // namespace

void ListGraph::begin(std::optional<std::uint64_t> n, unsigned base, bool is_named) {
  edges_.begin(n, base);
  known_n_ = n;
  first_.reset();
  named_ = GatheredGraph();
  is_named_ = is_named;
  stated_ = StatedCounts();
  rows_ = 0;
  most_fields_ = 0;
  is_counted_ = has_bare_row_ = false;
  whole_weight_line_ = 0;
}

void ListGraph::read_plain_edges() {
  const std::uint64_t plain =
      edges_.read_plain_edges(*input_, "", std::numeric_limits<std::uint64_t>::max());
  has_bare_row_ = has_bare_row_ || plain > 0;
  rows_ += plain;
}

void ListGraph::add(const ListRow& row, const ListField& a, const ListField& b) {
  look_at_columns(row, a, b);
  if (!is_named_ && !(is_whole_number(a.text) && is_whole_number(b.text))) {
    if (rows_ == 0 && !known_n_ &&
        !shape_->heading) {  // kept until the other rows have shown what it is
      first_ = First{row, input_->line(), 0, 0, {}, {}};
      rows_ = 1;
      return require_names(a, b);
    }
    become_names(a, b);
  }
  if (is_named_) {
    join(a, b);
  } else {
    read_numbers(row, a, b);
  }
  ++rows_;
}

void ListGraph::note_heading(std::uint64_t line, const ListRow& row) const {
  if (most_fields_ > row.size()) {
    input_->fail_at(line, 0,
                    fmt::format("a heading of {} fields above rows of {}: are these names "
                                "of rows (R's row.names = FALSE leaves them out)?",
                                row.size(), most_fields_));
  }
  const auto [source, target] = shape_->heading.value_or(kFirstColumns);
  note_(line, fmt::format("'{} {}' is a heading, no edge", row[source].text, row[target].text));
}

void ListGraph::look_at_columns(const ListRow& row, const ListField& a, const ListField& b) {
  most_fields_ = rows_ == 0 ? 0 : std::max(most_fields_, row.size());
  if (shape_->cut.separator == 0) {
    if (row.size() < 3 || !is_list_number(row[2].text)) has_bare_row_ = true;
    const bool has_whole = row.size() == 3 && is_whole_number(row[2].text);
    if (has_whole && whole_weight_line_ == 0) whole_weight_line_ = input_->line();
  }
  const bool is_count = row.size() == 3 && is_whole_number(a.text) && is_whole_number(row[2].text);
  if (rows_ == 0) first_count_ = is_count ? number_of(a).value_or(2) : 2;
  is_counted_ = is_count && shape_->cut.separator != 0 && (rows_ == 0 || is_counted_) &&
                first_count_ <= 1 && !shape_->heading && number_of(a) == first_count_ + rows_ &&
                b.text != row[2].text;
}

/// 0,1,2 and 1,2,3: edges (0, 1), (1, 2) with weights, or the edges (1, 2), (2, 3) in numbered rows?
void ListGraph::refuse_counted_rows() const {
  if (!is_counted_ || rows_ < 2) return;
  input_->fail(0,
               "the first of three columns may count the rows or be an end of an edge: a heading "
               "such as 'source target weight' tells");
}

/// Names stand only where the file says so: quotes, separators, a heading, --from or the ending.
void ListGraph::require_names(const ListField& a, const ListField& b) const {
  const ListField& name = is_whole_number(a.text) ? b : a;
  if (shape_->is_told || shape_->cut.separator != 0 || name.is_quoted || shape_->heading ||
      (first_ && ends_of_heading(first_->fields))) {
    return;
  }
  input_->fail(name.column, fmt::format("expected a vertex id, found {}", shown(name.text)));
}

/// All ids are names from here on, those read before, too.
void ListGraph::become_names(const ListField& a, const ListField& b) {
  require_names(a, b);
  const ListField& name = is_whole_number(a.text) ? b : a;
  if (known_n_ || options_.base) {
    input_->fail(name.column, fmt::format("expected a vertex id, found {}", shown(name.text)));
  }
  const bool is_mixed = edges_.num_edges() > 0 || (first_ && !first_->problem.empty());
  if (is_mixed) {
    note_(input_->line(), fmt::format("ids are names, as {} is no number", shown(name.text)));
  }
  take_numbers_as_names();
}

void ListGraph::take_numbers_as_names() {
  is_named_ = true;
  const bool is_first_apart = first_ && !is_numbers(*first_);
  if (is_first_apart) {
    refuse_unclear_ends(first_->fields[0], first_->fields[1], first_->line);
    const Vertex u = named_.vertex(first_->fields[0].text);
    named_.join(u, named_.vertex(first_->fields[1].text), first_->line);
  } else if (first_ && !first_->problem.empty()) {
    throw InputError(first_->problem);
  }
  for (std::size_t e = 0; e < edges_.num_edges(); ++e) {
    const Vertex u = named_.vertex(fmt::format("{}", edges_.edges()[e].u));
    named_.join(u, named_.vertex(fmt::format("{}", edges_.edges()[e].v)), edges_.line_of(e));
  }
  if (!is_first_apart) first_.reset();
}

bool ListGraph::is_numbers(const First& first) {
  return is_whole_number(first.fields[0].text) && is_whole_number(first.fields[1].text);
}

/// @throws InputError for an end that may be two, or be followed by a comment.
void ListGraph::refuse_unclear_ends(const ListField& a, const ListField& b,
                                    std::uint64_t line) const {
  for (const ListField* end : {&a, &b}) {
    if (end->is_quoted || shape_->heading || shape_->is_headed_table) continue;
    const std::size_t odd = end->text.find_first_of(",;#");
    if (odd == std::string::npos) continue;
    const bool is_cut = end->text[odd] == '#' || odd == 0 || odd + 1 == end->text.size();
    if (is_cut) {
      input_->fail_at(
          line, end->column,
          fmt::format("{} may be a name or not all of it be one: quotes tell", shown(end->text)));
    }
  }
}

void ListGraph::join(const ListField& a, const ListField& b) {
  refuse_unclear_ends(a, b, input_->line());
  const Vertex u = named_.vertex(a.text);
  named_.join(u, named_.vertex(b.text), input_->line());
}

void ListGraph::read_numbers(const ListRow& row, const ListField& a, const ListField& b) {
  const auto u = number_of(a);
  const auto v = number_of(b);
  if (!u || !v) {  // too large for an index, not for a name
    take_numbers_as_names();
    note_(input_->line(),
          fmt::format("ids are names, as {} is no 32-bit number", shown(u ? b.text : a.text)));
    return join(a, b);
  }
  const bool may_be_header = rows_ == 0 && !known_n_ && !shape_->heading && row.size() == 2 &&
                             !a.is_quoted && !b.is_quoted && options_.first_line != FirstLine::edge;
  if (!may_be_header) return add_numbers(*u, a, *v, b);
  First first{row, input_->line(), *u, *v, {}, {}};
  try {
    add_numbers(*u, a, *v, b);
  } catch (const InputError& error) {
    first.problem = error.what();
  }
  first.range = edges_.range();
  edges_.forget_range();
  first_ = first;
}

/// The number, or nothing if it does not fit a list whose ids may be names as well.
std::optional<std::uint64_t> ListGraph::number_of(const ListField& field) const {
  const bool is_name_too = !known_n_ && !options_.base;
  if (field.text.size() > 19) {
    if (is_name_too) return std::nullopt;
    input_->fail(field.column,
                 fmt::format("a vertex id {} does not fit 64 bits", shown(field.text)));
  }
  const std::uint64_t id = std::stoull(field.text);
  if (is_name_too && id >= std::numeric_limits<Vertex>::max() - 1) return std::nullopt;
  return id;
}

void ListGraph::add_numbers(std::uint64_t u, const ListField& a, std::uint64_t v,
                            const ListField& b) {
  const Vertex from = edges_.vertex_of(u, a.column);
  const Vertex to = edges_.vertex_of(v, b.column);
  if (from == to && !options_.simplify) {
    input_->fail(b.column, fmt::format("edge ({0}, {0}) is a loop", u));
  }
  edges_.add(from, to);
}

Graph ListGraph::finish() {
  refuse_counted_rows();
  if (first_ && is_numbers(*first_) && !is_named_) decide_first_line();
  if (first_ && !is_numbers(*first_)) decide_heading();
  if (whole_weight_line_ > 0 && has_bare_row_) {  // 0 1 2 and 3 4
    input_->fail_at(
        whole_weight_line_, 0,
        "a whole number behind the two ends, but not in every line: is it a weight, or is "
        "a line break missing?");
  }
  if (stated_.is_directed && !options_.undirected) {
    input_->fail_at(1, 0, "directed edges are not read (--undirected drops directions)");
  }
  if (stated_.edges && stated_.edges->count != rows_) {
    input_->fail_at(
        stated_.edges->line, 0,
        fmt::format("{} edges stated, found {} lines of edges", stated_.edges->count, rows_));
  }
  if (!is_named_ && !known_n_) decide_ids();
  if (!is_named_) return edges_.finish();
  if (stated_.vertices && stated_.vertices->count != named_.num_vertices()) {
    input_->fail_at(stated_.vertices->line, 0,
                    fmt::format("{} vertices stated, but the edges have {} names",
                                stated_.vertices->count, named_.num_vertices()));
  }
  return named_.finish(options_, false, [&](std::size_t at, const std::string& why) {
    input_->fail_at(at, 0, why);
  });
}

/// The first row has a name: an edge, or a heading above numbers or names?
void ListGraph::decide_heading() {
  const First first = *std::exchange(first_, std::nullopt);
  const bool is_above_numbers = !is_named_;
  const bool has_number =
      is_whole_number(first.fields[0].text) || is_whole_number(first.fields[1].text);
  const bool is_edge = (first.fields.size() > 2 && !first.fields[2].text.empty()) ||
                       (is_above_numbers && has_number);
  const bool wants_edge = options_.first_line == FirstLine::edge;
  const bool wants_heading = options_.first_line == FirstLine::header;
  if (is_above_numbers) {
    if (rows_ > 1 && !wants_edge && !is_edge) {
      return drop_heading(first);
    }
    first_ = first;
    if (options_.base) {
      input_->fail_at(first.line, first.fields[0].column,
                      fmt::format("expected a vertex id, found {}", shown(first.fields[0].text)));
    }
    take_numbers_as_names();
    first_.reset();
  }
  const bool is_alone = named_.num_edges() == 1;
  const bool is_joined = named_.is_joined_to_first_edge();
  if (wants_heading ||
      (!wants_edge && !is_edge && !is_joined && !is_alone && ends_of_heading(first.fields))) {
    named_.drop_first_edge();
    return drop_heading(first);
  }
  const bool is_known = ends_of_heading(first.fields).has_value();
  if (wants_edge || shape_->is_forced) return;
  if ((is_edge || is_joined) && !(is_alone && is_known)) return;
  if (is_alone && !is_known && (shape_->cut.separator != 0 || shape_->cut.has_quotes)) return;
  const std::string words = fmt::format("'{} {}'", first.fields[0].text, first.fields[1].text);
  if (is_alone) {
    input_->fail_at(first.line, 0,
                    fmt::format("{} alone may be a message and no edge: --from "
                                "edgelist reads it as one",
                                words));
  }
  input_->fail_at(first.line, 0,
                  fmt::format("{} may be a heading or an edge: no other line has one of these "
                              "names; --first-line header or --first-line edge says which ({})",
                              words, kInAStudy));
}

void ListGraph::drop_heading(const First& first) {
  note_heading(first.line, first.fields);
  --rows_;
}

/// Header or edge, now that the graph's other lines are known.
void ListGraph::decide_first_line() {
  const First first = *std::exchange(first_, std::nullopt);
  const bool is_edge = first.problem.empty();
  const std::uint64_t others = edges_.num_edges() - (is_edge ? 1 : 0);
  const bool wanted = options_.first_line == FirstLine::header;
  const EdgeCollector::Range range = edges_.range();  // of the others
  const bool fits_from_zero = range.end <= first.n;
  const bool fits_from_one =
      !options_.base && range.end == first.n + 1 && range.smallest > 0 && range.end > 1;
  const bool fits = others == first.m && (fits_from_zero || fits_from_one) &&
                    (wanted || first.n > 0);  // "0 0" is a loop
  if (wanted && !fits) {
    input_->fail_at(first.line, 0,
                    fmt::format("{} vertices and {} edges announced, found {} edges and ids up to "
                                "vertex {}",
                                first.n, first.m, others, range.end));
  }
  if (fits && is_edge && !wanted) {
    input_->fail_at(first.line, 0,
                    fmt::format("'{0} {1}' may be an edge, or the header of a graph with {0} "
                                "vertices and {1} edges: {2}--first-line edge or {2}--first-line "
                                "header says which ({3})",
                                first.n, first.m, fits_from_one ? "--base 1 " : "", kInAStudy));
  }
  if (!fits) {
    if (!is_edge) throw InputError(first.problem);
    edges_.note(first.range);
    return;
  }
  if (is_edge) edges_.drop_first_edge();
  --rows_;
  note_(first.line, fmt::format("'{} {}' is a header: vertices and edges", first.n, first.m));
  stated_.vertices = {first.n, first.line};
  if (options_.base) settle(first.n, *options_.base);
}

void ListGraph::settle(std::uint64_t n, unsigned base) {
  known_n_ = n;
  edges_.settle(n, base);
}

/// How many vertices, and from which id on, in a list that no size line begins.
void ListGraph::decide_ids() {
  const EdgeCollector::Range range = edges_.range();
  if (range.end == 0) return settle(stated_.vertices ? stated_.vertices->count : 0, 0);
  if (options_.base) {
    const std::uint64_t n = stated_.vertices ? stated_.vertices->count : range.end;
    if (range.end > n) {
      input_->fail_at(stated_.vertices->line, 0,
                      fmt::format("{} vertices stated, but ids go up to {}", n,
                                  range.end - 1 + *options_.base));
    }
    if (stated_.vertices) settle(n, *options_.base);
    return note_missing(n, stated_.vertices ? stated_.vertices->line : 0);
  }
  if (stated_.vertices) return decide_ids_by_head(stated_.vertices->count);
  const std::uint64_t most = 2 * edges_.num_edges();
  const std::uint64_t named = range.end > 2 * most ? 0 : edges_.num_named();
  const std::uint64_t from_one = range.smallest > 0 ? 1 : 0;
  if (2 * named < range.end - from_one) {
    take_numbers_as_names();
    note_(0, fmt::format("ids up to {} are names: as numbers they would leave most vertices "
                         "without an edge",
                         range.end - 1));
    return;
  }
  if (stated_.is_konect) return settle_from_one(range.end - 1, 1);
  if (from_one == 1 && named == range.end - 1) return settle_from_one(named, 0);
  if (from_one == 1) input_->fail(0, kBothBases);
  note_missing(range.end, 0);
}

void ListGraph::note_missing(std::uint64_t n, std::uint64_t line) const {
  edges_.checked_n();  // not more than the text accounts for
  const std::uint64_t named = edges_.num_named();
  if (named < n) note_(line, fmt::format("{} of {} vertices are in no line", n - named, n));
}

void ListGraph::settle_from_one(std::uint64_t n, std::uint64_t line) {
  settle(n, 1);
  note_(line, fmt::format("ids are from 1 to {}", n));
}

void ListGraph::decide_ids_by_head(std::uint64_t n) {
  const EdgeCollector::Range range = edges_.range();
  const std::uint64_t line = stated_.vertices->line;
  const bool fits_from_zero = range.end <= n && !stated_.is_konect;
  const bool fits_from_one = range.smallest > 0 && range.end <= n + 1;
  if (fits_from_zero && fits_from_one) input_->fail(0, kBothBases);
  if (!fits_from_zero && !fits_from_one) {
    if (range.end <= 4 * edges_.num_edges() && edges_.num_named() != n) {
      input_->fail_at(line, 0,
                      fmt::format("{} vertices stated, but ids go up to {}", n, range.end - 1));
    }
    take_numbers_as_names();
    return note_(line, fmt::format("ids up to {} of {} vertices are names", range.end - 1, n));
  }
  if (fits_from_one) settle_from_one(n, line);
  if (fits_from_zero) settle(n, 0);
  note_missing(n, line);
}

}  // namespace ar3d
