// The words of GML and DOT, and the graph that they gather. Nothing here recurses with the text.
#include "ar3d/formats/graphs/word_text.h"

#include <cctype>

#include "ar3d/base/error.h"
#include "ar3d/formats/text/tokens.h"

namespace ar3d {
namespace {
constexpr std::string_view kGmlMarks = "[]";
constexpr std::string_view kGmlEnds("[]\" \t\r\n\v\f\0", 10);
constexpr std::string_view kDotMarks = "[]{};,=:+";
}  // namespace

void WordText::fail(std::size_t at, const std::string& message) const {
  input_->fail_behind(std::string_view(text_).substr(0, at), message);
}

const TextWord& WordText::peek() {
  if (!std::exchange(is_loaded_, true)) text_ = input_->take_all();
  if (!peeked_) peeked_ = read();
  return *peeked_;
}

TextWord WordText::next() {
  TextWord word = peek();
  peeked_.reset();
  return word;
}

void WordText::expect_mark(std::string_view mark, const char* where) {
  const TextWord word = next();
  if (!word.is(mark))
    fail(word.at, fmt::format("expected {} {}, found {}", mark, where, shown(word.text)));
}

void WordText::skip_list(std::string_view open, std::string_view close) {
  for (std::size_t depth = 1; depth > 0;) {
    const TextWord word = next();
    if (word.kind == TextWord::Kind::end) fail(word.at, fmt::format("a {} is never closed", open));
    if (word.is(open)) ++depth;
    if (word.is(close)) --depth;
  }
}

void WordText::skip_blanks() {
  while (next_ < text_.size()) {
    const std::string_view rest = std::string_view(text_).substr(next_);
    const bool at_line = next_ == 0 || text_[next_ - 1] == '\n';
    if (is_blank(rest.substr(0, 1)) || rest[0] == '\n') {
      ++next_;
    } else if ((rest[0] == '#' && (at_line || is_dot_)) || (is_dot_ && rest.starts_with("//"))) {
      next_ = std::min(text_.find('\n', next_), text_.size());
    } else if (is_dot_ && rest.starts_with("/*")) {
      const std::size_t end = text_.find("*/", next_ + 2);
      if (end == std::string::npos) fail(next_, "a comment without end");
      next_ = end + 2;
    } else {
      return;
    }
  }
}

// Behind the opening quote.
std::string WordText::quoted() {
  const std::size_t begin = next_ - 1;
  std::string text;
  for (; next_ < text_.size(); ++next_) {
    const char c = text_[next_];
    if (c == '\0') fail(next_, "a byte 0 in a string, which other programs take for its end");
    if (c == '"') {
      ++next_;
      return text;
    }
    const bool is_escape = is_dot_ && c == '\\' && next_ + 1 < text_.size();
    if (is_escape && text_[next_ + 1] == '\n') {
      ++next_;
    } else if (is_escape && text_[next_ + 1] == '"') {
      text += text_[++next_];
    } else if (is_escape && text_[next_ + 1] == '\\') {  // both stay
      text += c;
      text += text_[++next_];
    } else {
      text += c;
    }
  }
  fail(begin, "a string without end");
}

// Behind the opening <.
std::string WordText::html() {
  const std::size_t begin = next_ - 1;
  std::size_t depth = 1;
  for (; next_ < text_.size(); ++next_) {
    if (text_[next_] == '<') ++depth;
    if (text_[next_] == '>' && --depth == 0) {
      ++next_;
      return text_.substr(begin + 1, next_ - begin - 2);
    }
  }
  fail(begin, "a < without its >");
}

// Letters and digits, or a number, as Graphviz cuts them ("a-1" is a and -1); but "1a" and "1.5.2",
// which it splits with a warning, are refused.
std::string_view WordText::dot_id(std::string_view rest) const {
  const auto is_letter = [](char c) {
    return c == '_' || std::isalpha(static_cast<unsigned char>(c)) != 0 || (c & 0x80) != 0;
  };
  const auto end_of = [&](std::size_t at, const auto& is_part) {
    while (at < rest.size() && is_part(rest[at])) ++at;
    return at;
  };
  if (is_letter(rest[0])) {
    return rest.substr(0, end_of(1, [&](char c) { return is_letter(c) || is_digit(c); }));
  }
  const std::size_t first = rest[0] == '-' ? 1 : 0;
  std::size_t end = end_of(first, is_digit);
  std::size_t digits = end - first;
  if (end < rest.size() && rest[end] == '.') {
    const std::size_t point = end++;
    end = end_of(end, is_digit);
    digits += end - point - 1;
  }
  if (digits == 0) fail(next_, fmt::format("{} begins no word of DOT", shown(rest.substr(0, 1))));
  if (end < rest.size() && (is_letter(rest[end]) || rest[end] == '.')) {
    fail(next_, fmt::format("{} is no number: other names that begin with a digit stand in quotes",
                            shown(rest.substr(0, end + 1))));
  }
  return rest.substr(0, end);
}

TextWord WordText::read() {
  const std::string_view marks = is_dot_ ? kDotMarks : kGmlMarks;
  skip_blanks();
  TextWord word{TextWord::Kind::end, "", next_};
  if (next_ == text_.size()) return word;
  const std::string_view rest = std::string_view(text_).substr(next_);
  const bool is_edge = is_dot_ && (rest.starts_with("--") || rest.starts_with("->"));
  if (is_edge || marks.find(rest[0]) != std::string_view::npos) {
    word = {TextWord::Kind::mark, std::string(rest.substr(0, is_edge ? 2 : 1)), next_};
    next_ += word.text.size();
  } else if (rest[0] == '"' || (is_dot_ && rest[0] == '<')) {
    ++next_;
    word.kind = TextWord::Kind::quoted;
    word.is_html = rest[0] == '<';
    word.text = word.is_html ? html() : quoted();
  } else {
    word.kind = TextWord::Kind::plain;
    word.text = is_dot_ ? dot_id(rest) : rest.substr(0, rest.find_first_of(kGmlEnds, 1));
    next_ += word.text.size();
  }
  return word;
}

Vertex GatheredGraph::vertex(std::string_view id) {
  if (const std::optional<Vertex> found = ids_.find(id)) return *found;
  texts_.emplace_back(id);
  names_.emplace_back(id);
  ids_.add(texts_.back());
  return static_cast<Vertex>(ids_.size() - 1);  // a text of 2^32 ids is too long for the memory
}

void GatheredGraph::join(Vertex u, Vertex v, std::size_t at) {
  edges_.push_back({u, v});
  positions_.push_back(at);
}

bool GatheredGraph::is_joined_to_first_edge() const {
  const auto joins = [&](const Edge& edge) {
    return std::min(edge.u, edge.v) <= std::max(edges_[0].u, edges_[0].v);
  };
  return std::any_of(edges_.begin() + 1, edges_.end(), joins);
}

void GatheredGraph::drop_first_edge() {
  GatheredGraph rest;
  for (std::size_t e = 1; e < edges_.size(); ++e) {
    const Vertex u = rest.vertex(texts_[edges_[e].u]);
    rest.join(u, rest.vertex(texts_[edges_[e].v]), positions_[e]);
  }
  *this = std::move(rest);
}

Graph GatheredGraph::finish(const ReadOptions& options, bool merge,
                            const std::function<void(std::size_t, const std::string&)>& fail) {
  const auto is_loop = [](const Edge& edge) { return edge.u == edge.v; };
  const auto refuse = [&](std::size_t edge, const char* problem) {
    const auto [u, v] = edges_[edge];
    fail(positions_[edge],
         fmt::format("edge ({}, {}) is {}", shown(texts_[u]), shown(texts_[v]), problem));
  };
  if (!options.simplify) {
    const auto loop = std::find_if(edges_.begin(), edges_.end(), is_loop);
    if (loop != edges_.end()) refuse(static_cast<std::size_t>(loop - edges_.begin()), "a loop");
  }
  if (options.simplify || merge) simplify(edges_);
  try {
    return Graph(ids_.size(), edges_);
  } catch (const EdgeError& error) {
    refuse(error.edge(), "parallel to an earlier edge");
    throw;
  }
}

std::vector<std::string> GatheredGraph::names() const {
  return telling_names({names_.begin(), names_.end()});
}

}  // namespace ar3d
