#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ar3d/formats/graphs/graph_format.h"
#include "ar3d/formats/graphs/node_ids.h"

namespace ar3d {

/// A word of a text of GML or DOT.
struct TextWord {
  enum class Kind { end, plain, quoted, mark };
  Kind kind = Kind::end;
  std::string text;      ///< without quotes; a mark is one of [ ] { } ; , = : + and, in DOT, -- ->
  std::size_t at = 0;    ///< byte of the text
  bool is_html = false;  ///< stood in < and >
  bool is(std::string_view mark) const { return kind == Kind::mark && text == mark; }
  bool is_name() const { return kind == Kind::plain || kind == Kind::quoted; }
};

/// The rest of an input, held whole, as words. Blanks, lines that begin with #, and in DOT comments
/// as in C++ are read over. Memory: twice the text.
class WordText {
 public:
  /// @param is_dot  strings may hold \" and are joined by a \ at a line's end; <…> is a string.
  WordText(TextInput& input, bool is_dot) : input_(&input), is_dot_(is_dot) {}

  /// The word to come. @throws InputError on a string or comment without end.
  const TextWord& peek();
  TextWord next();
  /// The next word, which has to be that mark. @throws InputError if it is another.
  void expect_mark(std::string_view mark, const char* where);
  /// Reads on behind the mark that closes what has just been opened by `open`.
  void skip_list(std::string_view open, std::string_view close);
  /// @throws InputError "FILE:LINE:COLUMN: message" for that byte of the text.
  [[noreturn]] void fail(std::size_t at, const std::string& message) const;

 private:
  void skip_blanks();
  TextWord read();
  std::string quoted();
  std::string html();
  std::string_view dot_id(std::string_view rest) const;

  TextInput* input_;
  bool is_dot_;
  bool is_loaded_ = false;
  std::string text_;
  std::size_t next_ = 0;
  std::optional<TextWord> peeked_;
};

/// Gathers a graph whose vertices have texts as ids and, maybe, names.
class GatheredGraph {
 public:
  GatheredGraph() = default;
  /// The vertex of that id; a new one if there is none.
  Vertex vertex(std::string_view id);
  std::optional<Vertex> find(std::string_view id) const { return ids_.find(id); }
  const std::string& id(Vertex v) const { return texts_[v]; }
  /// A name to show instead of the id.
  void set_name(Vertex v, std::string name) { names_[v] = std::move(name); }
  /// An edge that stands at that byte.
  void join(Vertex u, Vertex v, std::size_t at);
  std::size_t num_vertices() const { return ids_.size(); }
  std::size_t num_edges() const { return edges_.size(); }
  /// Has another edge one of the ends of the first one?
  bool is_joined_to_first_edge() const;
  /// Takes the first edge back, and its ends, which must be in no other.
  void drop_first_edge();
  /// @param fail  throws InputError for a loop or a parallel edge, unless they are dropped, with
  /// its place. @param merge  parallel edges are one.
  Graph finish(const ReadOptions& options, bool merge,
               const std::function<void(std::size_t at, const std::string&)>& fail);
  /// Returns the vertices' names; empty if they say no more than numbers from 0, or n and these.
  std::vector<std::string> names() const;

 private:
  std::deque<std::string> texts_;  // of the ids
  std::deque<std::string> names_;
  NodeIds ids_;
  std::vector<Edge> edges_;
  std::vector<std::size_t> positions_;
};

}  // namespace ar3d
