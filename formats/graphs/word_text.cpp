// The words of GML and DOT, and the graph that they gather. Nothing here recurses with the text.
#include "ar3d/formats/graphs/word_text.h"

#include "ar3d/base/error.h"
#include "ar3d/formats/text/tokens.h"

namespace ar3d {
namespace {
constexpr std::string_view kMarks = "[]{};,=:+";
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
    } else if ((rest[0] == '#' && at_line) || (is_dot_ && rest.starts_with("//"))) {
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
    if (c == '"') {
      ++next_;
      return text;
    }
    const bool is_escape = is_dot_ && c == '\\' && next_ + 1 < text_.size();
    if (is_escape && text_[next_ + 1] == '\n') {
      ++next_;
    } else if (is_escape && text_[next_ + 1] == '"') {
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

TextWord WordText::read() {
  skip_blanks();
  TextWord word{TextWord::Kind::end, "", next_};
  if (next_ == text_.size()) return word;
  const std::string_view rest = std::string_view(text_).substr(next_);
  const bool is_edge = is_dot_ && (rest.starts_with("--") || rest.starts_with("->"));
  if (is_edge || kMarks.find(rest[0]) != std::string_view::npos) {
    word = {TextWord::Kind::mark, std::string(rest.substr(0, is_edge ? 2 : 1)), next_};
    next_ += word.text.size();
  } else if (rest[0] == '"' || (is_dot_ && rest[0] == '<')) {
    ++next_;
    word.kind = TextWord::Kind::quoted;
    word.text = rest[0] == '"' ? quoted() : html();
  } else {
    const auto ends = [&](char c) {
      return is_blank({&c, 1}) || c == '\n' || c == '"' || c == '\0' ||
             kMarks.find(c) != std::string_view::npos || (is_dot_ && (c == '-' || c == '<'));
    };
    const auto end = std::find_if(rest.begin() + 1, rest.end(), ends);
    word.kind = TextWord::Kind::plain;
    word.text.assign(rest.begin(), end);
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
  places_.push_back(at);
}

Graph GatheredGraph::finish(const ReadOptions& options, bool merge,
                            const std::function<void(std::size_t, const std::string&)>& fail) {
  const auto is_loop = [](const Edge& edge) { return edge.u == edge.v; };
  const auto refuse = [&](std::size_t edge, const char* problem) {
    const auto [u, v] = edges_[edge];
    fail(places_[edge],
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
