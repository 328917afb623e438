// The one reader of drawings in JSON: lines as this program writes them, and the answers of
// programs. It takes the parser's events, since the tree of a drawing takes ten times the memory of
// its line.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/formats/catalog.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/formats/text/tokens.h"
#include "ar3d/model/real_points.h"

namespace ar3d {
namespace {

constexpr const char* kKeyNames[] = {
    "",      "n",     "algorithm", "gram",          "gram_denominator", "vertices",
    "edges", "error", "real_type", "unit_exponent", "seconds",          "names"};
constexpr std::string_view kKeysOfAnswers[] = {"n", "vertices", "edges", "error", "seconds"};
constexpr std::size_t kLongestNumber = 1000;  // characters, as in proof/reader.ml
constexpr std::int64_t kLargestExponent = 4000;
constexpr std::int64_t kLargestEntry = INT32_MAX;  // of the Gram matrix
constexpr std::int64_t kMaxVertices = std::numeric_limits<Vertex>::max() - 1;

class SyntaxError : public InputError {
 public:
  SyntaxError(std::size_t at, const std::string& message) : InputError(message), column(at) {}
  std::size_t column;
};

/// Takes the parser's events of one line and builds its drawing; a state is (key, nesting inside
/// its value). Everything that does not fit throws InputError without place, so memory stays
/// proportional to the line.
class DrawingEvents {
 public:
  /// @param of_answer  the line is a program's, in any decimal numbers.
  explicit DrawingEvents(bool of_answer) : of_answer_(of_answer) {}
  /// Returns what the line says, once it is parsed. @throws InputError if a key is missing or the
  /// parts do not fit.
  DrawingJsonlReader::Line finish() {
    if (!inside_object_) throw InputError("expected an object");
    refuse_missing({Key::n});
    if (!seen(Key::error)) {
      Drawing drawing = finish_drawing();
      if (!seen(Key::names)) return drawing;
      require_one_a_vertex(names_.size(), "names");
      drawing.names = std::make_shared<const std::vector<std::string>>(std::move(names_));
      return drawing;
    }
    if (std::count(std::begin(seen_), std::end(seen_), true) != 2)
      throw InputError("a line with 'error' has no other key than 'n'");
    return UndrawnGraph{n_, std::move(error_)};
  }
  DecimalDrawing finish_answer() {
    if (!inside_object_) throw InputError("expected an object");
    if (seen(Key::error)) {
      answer_.error = error_.empty() ? "no reason given" : error_;
    } else if (!seen(Key::vertices)) {
      throw InputError("neither 'vertices' nor 'error' is in it");
    }
    if (seen(Key::edges)) answer_.edges = std::move(*edges_);
    return std::move(answer_);
  }

  // The parser's events, by the names that nlohmann-json gives them.
  bool null() { fail("unexpected null"); }
  bool boolean(bool value) { fail(fmt::format("unexpected {}", value)); }
  bool number_integer(std::int64_t value) {
    if (of_answer_) return take_decimal(std::to_string(value));
    const std::size_t depth = items_.size();
    if (key_ == Key::n && depth == 0) {
      if (value < 0 || value > kMaxVertices)
        fail(fmt::format("{} is no number of vertices", value));
      n_ = static_cast<std::uint64_t>(value);
    } else if (key_ == Key::gram_denominator && depth == 0) {
      lattice_.gram_denominator = static_cast<std::int32_t>(in_range(value, 1, kLargestEntry));
    } else if (key_ == Key::unit_exponent && depth == 0) {
      real_.unit_exponent = static_cast<int>(in_range(value, -kLargestExponent, kLargestExponent));
    } else if (is_point(depth)) {
      if (items_.back() >= 3) fail(fmt::format("unexpected fourth number {}", value));
      if (key_ != Key::gram) has_integers_ = true;
      if (value < -kMaxCoordinate || value > kMaxCoordinate) {
        fail(fmt::format("coordinate {} is out of range, the limit is {}", value, kMaxCoordinate));
      }
      numbers_[items_.back()++] = value;
    } else if (key_ == Key::edges && depth == 2 && items_.back() < 2) {
      (items_.back()++ == 0 ? ends_.u : ends_.v) = checked_vertex(value);
    } else {
      fail(fmt::format("unexpected number {}", value));
    }
    return true;
  }
  bool number_unsigned(std::uint64_t value) {
    if (of_answer_) return take_decimal(std::to_string(value));
    if (!std::in_range<std::int64_t>(value))
      fail(fmt::format("{} does not fit 64 bits with sign", value));
    return number_integer(static_cast<std::int64_t>(value));
  }
  bool number_float(double, const std::string& text) {
    if (of_answer_) return take_decimal(text);
    fail(fmt::format("expected an integer of 64 bits, found {}", shown(text)));
  }
  bool string(std::string& value) {
    if (key_ == Key::algorithm && items_.empty()) {
      algorithm_ = std::move(value);
    } else if (key_ == Key::error && items_.empty()) {
      error_ = std::move(value);
    } else if (key_ == Key::real_type && items_.empty()) {
      real_.type = std::move(value);
    } else if (key_ == Key::names && items_.size() == 1) {
      names_.push_back(std::move(value));
      ++items_.back();
    } else if (is_point(items_.size()) && key_ != Key::gram && !of_answer_) {
      take_real_number(value);
    } else {
      fail(fmt::format("unexpected text {}", shown(value)));
    }
    return true;
  }
  bool binary(nlohmann::json::binary_t&) { fail("unexpected binary value"); }
  bool start_object(std::size_t) {
    if (inside_object_) fail("unexpected object");
    inside_object_ = true;
    return true;
  }
  bool key(std::string& name) {
    const auto found = std::find(std::begin(kKeyNames) + 1, std::end(kKeyNames), name);
    const bool in_answers = std::ranges::find(kKeysOfAnswers, name) != std::end(kKeysOfAnswers);
    if (found == std::end(kKeyNames) || (of_answer_ ? !in_answers : name == "seconds")) {
      throw InputError(fmt::format("unknown key {}", shown(name)));
    }
    key_ = static_cast<Key>(found - std::begin(kKeyNames));
    if (std::exchange(seen_[static_cast<int>(key_)], true))
      throw InputError(fmt::format("key '{}' stands twice", name));
    return true;
  }
  bool end_object() {
    key_ = Key::none;
    return true;
  }
  bool start_array(std::size_t) {
    const std::size_t depth = items_.size();
    const bool list = key_ == Key::gram || key_ == Key::vertices || key_ == Key::edges;
    const bool fits = depth == 0   ? list || key_ == Key::names
                      : depth == 1 ? list
                      : depth == 2 ? key_ == Key::edges && items_.back() == 2
                                   : depth == 3 && key_ == Key::edges;
    if (!fits)
      fail(depth == 0 && key_ == Key::none ? "expected an object, found an array"
                                           : "unexpected array");
    items_.push_back(0);
    return true;
  }
  bool end_array() {
    const std::size_t depth = items_.size();
    if (is_point(depth)) end_point();
    if (key_ == Key::edges && depth == 2) end_edge();
    if (key_ == Key::gram && depth == 1 && items_.back() != 3) {
      fail_list(fmt::format("{} rows instead of 3", items_.back()));
    }
    items_.pop_back();
    if (!items_.empty()) ++items_.back();
    return true;
  }
  bool parse_error(std::size_t at, const std::string& token,
                   const nlohmann::json::exception& error) {
    if (error.id == 406 && !of_answer_) return number_float(0, token);  // no double holds it
    std::string reason =
        error.what();  // "[json.exception.…] parse error at line 1, column 5: syntax error …"
    const std::size_t position_end = reason.find(": ");
    if (position_end != std::string::npos) reason.erase(0, position_end + 2);
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    throw SyntaxError(at, reason);
  }

 private:
  enum class Key {
    none,
    n,
    algorithm,
    gram,
    gram_denominator,
    vertices,
    edges,
    error,
    real_type,
    unit_exponent,
    seconds,
    names
  };

  /// "vertices[5]" for messages.
  std::string path() const {
    std::string text = kKeyNames[static_cast<int>(key_)];
    for (const std::uint64_t item : items_) text += fmt::format("[{}]", item);
    return text;
  }
  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(key_ == Key::none ? problem : fmt::format("{}: {}", path(), problem));
  }
  /// About the innermost open array as a whole.
  [[noreturn]] void fail_list(const std::string& problem) {
    items_.pop_back();
    fail(problem);
  }
  std::int64_t in_range(std::int64_t value, std::int64_t least, std::int64_t most) const {
    if (value < least || value > most) fail(fmt::format("{} is not in {}..{}", value, least, most));
    return value;
  }
  /// True where [x, y, z] stands at this nesting.
  bool is_point(std::size_t depth) const {
    return ((key_ == Key::vertices || key_ == Key::gram) && depth == 2) ||
           (key_ == Key::edges && depth == 4);
  }
  void end_point() {
    if (of_answer_) {
      if (items_.back() < 2) fail_list(fmt::format("{} numbers instead of 2 or 3", items_.back()));
      if (items_.back() == 2) decimals_[2] = {};
      (key_ == Key::edges ? answer_.bends : answer_.vertices).push_back(decimals_);
      return;
    }
    if (items_.back() != 3) fail_list(fmt::format("{} numbers instead of 3", items_.back()));
    const Point p{numbers_[0], numbers_[1], numbers_[2]};
    if (has_texts_ && key_ != Key::gram) {
      auto& list = key_ == Key::edges ? real_.bends : real_.vertices;
      list.push_back({real_numbers_[0], real_numbers_[1], real_numbers_[2]});
      return;
    }
    if (key_ == Key::edges) {
      edge_bends_.push_back(p);
    } else if (key_ == Key::vertices) {
      vertices_.push_back(p);
      largest_ = std::max({largest_, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    } else {
      const std::uint64_t row = items_.front();
      if (row >= 3) fail_list("unexpected fourth row");
      for (std::size_t column = 0; column < 3; ++column) {
        lattice_.gram[row][column] =
            static_cast<std::int32_t>(in_range(numbers_[column], -kLargestEntry, kLargestEntry));
      }
    }
  }
  void end_edge() {
    if (items_.back() < (of_answer_ ? 2u : 3u)) fail_list("an edge is [u, v, [bends]]");
    edges_->push_back(ends_);
    answer_.offsets.push_back(answer_.bends.size());
    real_.offsets.push_back(real_.bends.size());
    bends_->add_edge(edge_bends_);
    edge_bends_.clear();
  }
  void take_real_number(const std::string& text) {
    if (items_.back() >= 3) fail(fmt::format("unexpected fourth number {}", shown(text)));
    const std::size_t digits = text.starts_with('-') ? 1 : 0;
    if (text.size() == digits ||
        text.find_first_not_of("0123456789", digits) != std::string::npos) {
      fail(fmt::format("{} is no decimal integer", shown(text)));
    }
    if (text.size() > kLongestNumber)
      fail(fmt::format("{} has more than {} characters", shown(text), kLongestNumber));
    has_texts_ = true;
    BigInteger value = 0;  // read by hand: leading zeros would mean octal
    for (std::size_t i = digits; i < text.size(); ++i) value = value * 10 + (text[i] - '0');
    real_numbers_[items_.back()++] = digits == 0 ? value : BigInteger(-value);
  }
  /// Takes the numbers as they are written: a double would round them.
  bool take_decimal(const std::string& text) {
    const std::size_t depth = items_.size();
    if (is_point(depth)) {
      if (items_.back() >= 3) fail(fmt::format("unexpected fourth number {}", text));
      decimals_[items_.back()++] = parse_decimal(text);
    } else if (key_ == Key::edges && depth == 2 && items_.back() < 2) {
      const Decimal id = parse_decimal(text);
      if (id.exponent < 0) fail(fmt::format("{} is no vertex id", text));
      (items_.back()++ == 0 ? ends_.u : ends_.v) = checked_vertex(scaled(id, 0));
    } else if (key_ == Key::seconds && depth == 0) {
      answer_.seconds = std::strtod(text.c_str(), nullptr);
      if (!std::isfinite(answer_.seconds) || answer_.seconds < 0) fail(text + " is no time");
    } else if (key_ != Key::n || depth != 0) {
      fail(fmt::format("unexpected number {}", text));
    }
    return true;
  }
  Vertex checked_vertex(std::int64_t id) const {
    if (id < 0 || id > kMaxVertices) fail(fmt::format("{} is no vertex id", id));
    return static_cast<Vertex>(id);
  }
  bool seen(Key key) const { return seen_[static_cast<int>(key)]; }
  void refuse_missing(std::initializer_list<Key> keys) const {
    for (const Key key : keys) {
      if (seen(key)) continue;
      throw InputError(fmt::format("key '{}' is missing", kKeyNames[static_cast<int>(key)]));
    }
  }
  void require_one_a_vertex(std::size_t count, const char* what) const {
    if (count == n_) return;
    throw InputError(fmt::format("n is {}, but there are {} {}", n_, count, what));
  }
  Drawing finish_drawing() {
    if (seen(Key::real_type) || seen(Key::unit_exponent)) return finish_real_drawing();
    refuse_missing({Key::algorithm, Key::gram, Key::gram_denominator, Key::vertices, Key::edges});
    if (has_texts_) throw InputError("coordinates are integers, except those in a real type");
    require_one_a_vertex(vertices_.size(), "vertices");
    lattice_.validate();
    Coordinates coordinates(vertices_.size(), largest_);
    for (std::size_t v = 0; v < vertices_.size(); ++v) coordinates.set(v, vertices_[v]);
    return Drawing(std::move(algorithm_), lattice_, std::move(coordinates), std::move(edges_),
                   std::move(bends_));
  }
  Drawing finish_real_drawing() {
    refuse_missing({Key::algorithm, Key::real_type, Key::unit_exponent, Key::vertices, Key::edges});
    if (seen(Key::gram) || seen(Key::gram_denominator)) {
      throw InputError("a drawing in a real type has no 'gram' and no 'gram_denominator'");
    }
    if (has_integers_) throw InputError("coordinates in a real type are texts of decimal integers");
    require_one_a_vertex(real_.vertices.size(), "vertices");
    require_values_of_type(real_);
    return real_drawing(std::move(algorithm_), std::move(edges_), std::move(real_));
  }

  bool of_answer_;
  Key key_ = Key::none;
  bool inside_object_ = false;
  bool seen_[std::size(kKeyNames)] = {};
  std::vector<std::uint64_t> items_;  // per open array: values so far
  std::int64_t numbers_[3] = {};      // of the open point, or the ends of the open edge
  BigInteger real_numbers_[3];        // of the open point, in a real type
  RealPoints real_;                   // of a drawing in a real type
  DecimalPoint decimals_;             // of the open point of an answer
  DecimalDrawing answer_;
  bool has_texts_ = false;     // as coordinates
  bool has_integers_ = false;  // as coordinates
  std::uint64_t n_ = 0;
  std::string algorithm_;
  std::string error_;
  std::vector<std::string> names_;
  Lattice lattice_;
  std::vector<Point> vertices_;
  std::int64_t largest_ = 0;  // absolute value of a vertex coordinate
  std::shared_ptr<std::vector<Edge>> edges_ = std::make_shared<std::vector<Edge>>();
  Edge ends_;
  std::vector<Point> edge_bends_;
  std::shared_ptr<StoredBends> bends_ = std::make_shared<StoredBends>();
};

// The library takes NUL for the end of its input.
void parse_line(std::string_view line, DrawingEvents& events) {
  const std::size_t nul = line.find('\0');
  if (nul != line.npos) throw SyntaxError(nul + 1, "a NUL byte");
  nlohmann::json::sax_parse(line.begin(), line.end(), &events);
}

}  // namespace

DecimalDrawing read_decimal_drawing(std::string_view line) {
  DrawingEvents events(true);
  try {
    parse_line(line, events);
  } catch (const SyntaxError& error) {
    throw InputError(fmt::format("column {}: no JSON: {}", error.column, error.what()));
  }
  return events.finish_answer();
}

DrawingJsonlReader::DrawingJsonlReader(TextInput input)
    : input_(std::make_unique<TextInput>(std::move(input))) {
  const std::string_view head = input_->look_ahead_line();
  if (head.empty()) {
    throw InputError(fmt::format("{}: empty file: no drawing in it", input_->name()));
  }
  if (!head.starts_with('{')) refuse_graph(*input_);
}

std::optional<DrawingJsonlReader::Line> DrawingJsonlReader::next() {
  while (const std::optional<std::string_view> line = input_->next_line()) {
    if (is_blank(*line)) continue;
    try {
      DrawingEvents events(false);
      parse_line(*line, events);
      return events.finish();
    } catch (const SyntaxError& error) {
      input_->fail(error.column, error.what());
    } catch (const InputError& error) {
      input_->fail(0, error.what());
    }
  }
  return std::nullopt;
}

std::string DrawingJsonlReader::where() const {
  return fmt::format("{}:{}", input_->name(), input_->line());
}

}  // namespace ar3d
