#include "ar3d/formats/drawings/drawing_events.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "ar3d/model/real_drawing.h"
#include "real_types.h"

namespace ar3d {
namespace {

constexpr const char* kKeyNames[] = {
    "",         "n",     "algorithm", "gram",      "gram_denominator",
    "vertices", "edges", "error",     "real_type", "unit_exponent"};
constexpr std::size_t kLongestNumber = 1000;  // characters of a coordinate in a real type
constexpr std::int64_t kLargestExponent = 4000;
constexpr std::uint64_t kMaxVertices = std::numeric_limits<Vertex>::max() - 1;

}  // namespace

std::string DrawingEvents::place() const {
  std::string text = kKeyNames[static_cast<int>(key_)];
  for (const std::uint64_t item : items_) text += fmt::format("[{}]", item);
  return text;
}

void DrawingEvents::fail(const std::string& problem) const {
  throw InputError(key_ == Key::none ? problem : fmt::format("{}: {}", place(), problem));
}

void DrawingEvents::fail_list(const std::string& problem) {
  items_.pop_back();
  fail(problem);
}

bool DrawingEvents::is_point(std::size_t depth) const {
  return ((key_ == Key::vertices || key_ == Key::gram) && depth == 2) ||
         (key_ == Key::edges && depth == 4);
}

bool DrawingEvents::number_integer(std::int64_t value) {
  const std::size_t depth = items_.size();
  if (key_ == Key::n && depth == 0) {
    if (value < 0 || static_cast<std::uint64_t>(value) > kMaxVertices) {
      fail(fmt::format("{} is no number of vertices", value));
    }
    n_ = static_cast<std::uint64_t>(value);
  } else if (key_ == Key::gram_denominator && depth == 0) {
    if (value < 1 || value > std::numeric_limits<std::int32_t>::max()) {
      fail(fmt::format("{} is not in 1..2^31-1", value));
    }
    lattice_.gram_denominator = static_cast<std::int32_t>(value);
  } else if (key_ == Key::unit_exponent && depth == 0) {
    if (value < -kLargestExponent || value > kLargestExponent) {
      fail(fmt::format("{} is not in {}..{}", value, -kLargestExponent, kLargestExponent));
    }
    real_.unit_exponent = static_cast<int>(value);
  } else if (is_point(depth)) {
    if (items_.back() >= 3) fail(fmt::format("unexpected fourth number {}", value));
    if (key_ != Key::gram) has_integers_ = true;
    if (value < -kMaxCoordinate || value > kMaxCoordinate) {
      fail(fmt::format("coordinate {} is out of range, the limit is {}", value, kMaxCoordinate));
    }
    numbers_[items_.back()++] = value;
  } else if (key_ == Key::edges && depth == 2 && items_.back() < 2) {
    if (value < 0 || static_cast<std::uint64_t>(value) > kMaxVertices) {
      fail(fmt::format("{} is no vertex id", value));
    }
    (items_.back()++ == 0 ? ends_.u : ends_.v) = static_cast<Vertex>(value);
  } else {
    fail(fmt::format("unexpected number {}", value));
  }
  return true;
}

bool DrawingEvents::number_unsigned(std::uint64_t value) {
  if (value > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) {
    fail(fmt::format("{} does not fit 64 bits with sign", value));
  }
  return number_integer(static_cast<std::int64_t>(value));
}

bool DrawingEvents::number_float(double, const std::string& text) {
  fail(fmt::format("expected an integer of 64 bits, found {}", shown(text)));
}

bool DrawingEvents::string(std::string& value) {
  if (key_ == Key::algorithm && items_.empty()) {
    algorithm_ = std::move(value);
  } else if (key_ == Key::error && items_.empty()) {
    error_ = std::move(value);
  } else if (key_ == Key::real_type && items_.empty()) {
    real_.type = std::move(value);
  } else if (is_point(items_.size()) && key_ != Key::gram) {
    take_real_number(value);
  } else {
    fail(fmt::format("unexpected text {}", shown(value)));
  }
  return true;
}

void DrawingEvents::take_real_number(const std::string& text) {
  if (items_.back() >= 3) fail(fmt::format("unexpected fourth number {}", shown(text)));
  const std::size_t digits = text.starts_with('-') ? 1 : 0;
  if (text.size() == digits || text.find_first_not_of("0123456789", digits) != std::string::npos) {
    fail(fmt::format("{} is no decimal integer", shown(text)));
  }
  if (text.size() > kLongestNumber) {
    fail(fmt::format("{} has more than {} characters", shown(text), kLongestNumber));
  }
  has_texts_ = true;
  BigInteger value = 0;  // read by hand: leading zeros would mean octal
  for (std::size_t i = digits; i < text.size(); ++i) value = value * 10 + (text[i] - '0');
  real_numbers_[items_.back()++] = digits == 0 ? value : BigInteger(-value);
}

bool DrawingEvents::null() { fail("unexpected null"); }
bool DrawingEvents::boolean(bool value) { fail(fmt::format("unexpected {}", value)); }
bool DrawingEvents::binary(nlohmann::json::binary_t&) { fail("unexpected binary value"); }

bool DrawingEvents::start_object(std::size_t) {
  if (inside_object_) fail("unexpected object");
  inside_object_ = true;
  return true;
}

bool DrawingEvents::key(std::string& name) {
  const auto found = std::find(std::begin(kKeyNames) + 1, std::end(kKeyNames), name);
  if (found == std::end(kKeyNames)) throw InputError(fmt::format("unknown key {}", shown(name)));
  const auto index = found - std::begin(kKeyNames);
  key_ = static_cast<Key>(index);
  if (std::exchange(seen_[index], true))
    throw InputError(fmt::format("key '{}' stands twice", name));
  return true;
}

bool DrawingEvents::end_object() {
  key_ = Key::none;
  return true;
}

bool DrawingEvents::start_array(std::size_t) {
  const std::size_t depth = items_.size();
  const bool list = key_ == Key::gram || key_ == Key::vertices || key_ == Key::edges;
  const bool fits = depth == 0   ? list
                    : depth == 1 ? true
                    : depth == 2 ? key_ == Key::edges && items_.back() == 2
                                 : depth == 3 && key_ == Key::edges;
  if (!fits)
    fail(depth == 0 && key_ == Key::none ? "expected an object, found an array"
                                         : "unexpected array");
  items_.push_back(0);
  return true;
}

bool DrawingEvents::end_array() {
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

void DrawingEvents::end_point() {
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
      const std::int64_t entry = numbers_[column];
      if (std::abs(entry) > std::numeric_limits<std::int32_t>::max()) {
        fail(fmt::format("entry {} does not fit 32 bits", entry));
      }
      lattice_.gram[row][column] = static_cast<std::int32_t>(entry);
    }
  }
}

void DrawingEvents::end_edge() {
  if (items_.back() != 3) fail_list("an edge is [u, v, [bends]]");
  edges_->push_back(ends_);
  real_.offsets.push_back(real_.bends.size());
  bends_->add_edge(edge_bends_);
  edge_bends_.clear();
}

bool DrawingEvents::parse_error(std::size_t at, const std::string&,
                                const nlohmann::json::exception& error) {
  std::string reason =
      error.what();  // "[json.exception.…] parse error at line 1, column 5: syntax error …"
  const std::size_t place_end = reason.find(": ");
  if (place_end != std::string::npos) reason.erase(0, place_end + 2);
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  throw SyntaxError(at, reason);
}

void DrawingEvents::refuse_missing(std::initializer_list<Key> keys) const {
  for (const Key key : keys) {
    const int index = static_cast<int>(key);
    if (!seen_[index]) throw InputError(fmt::format("key '{}' is missing", kKeyNames[index]));
  }
}

Drawing DrawingEvents::finish_real_drawing() {
  refuse_missing({Key::algorithm, Key::real_type, Key::unit_exponent, Key::vertices, Key::edges});
  if (seen_[static_cast<int>(Key::gram)] || seen_[static_cast<int>(Key::gram_denominator)]) {
    throw InputError("a drawing in a real type has no 'gram' and no 'gram_denominator'");
  }
  if (has_integers_) throw InputError("coordinates in a real type are texts of decimal integers");
  if (real_.vertices.size() != n_) {
    throw InputError(fmt::format("n is {}, but there are {} vertices", n_, real_.vertices.size()));
  }
  require_values_of_type(real_);
  return real_drawing(std::move(algorithm_), std::move(edges_), std::move(real_));
}

Drawing DrawingEvents::finish_drawing() {
  if (seen_[static_cast<int>(Key::real_type)] || seen_[static_cast<int>(Key::unit_exponent)]) {
    return finish_real_drawing();
  }
  refuse_missing({Key::algorithm, Key::gram, Key::gram_denominator, Key::vertices, Key::edges});
  if (has_texts_) throw InputError("coordinates are integers, but for those in a real type");
  if (vertices_.size() != n_) {
    throw InputError(fmt::format("n is {}, but there are {} vertices", n_, vertices_.size()));
  }
  lattice_.validate();
  Coordinates coordinates(vertices_.size(), largest_);
  for (std::size_t v = 0; v < vertices_.size(); ++v) coordinates.set(v, vertices_[v]);
  return Drawing(std::move(algorithm_), lattice_, std::move(coordinates), std::move(edges_),
                 std::move(bends_));
}

DrawingJsonlReader::Line DrawingEvents::finish() {
  if (!inside_object_) throw InputError("expected an object");
  if (!seen_[static_cast<int>(Key::n)]) throw InputError("key 'n' is missing");
  if (!seen_[static_cast<int>(Key::error)]) return finish_drawing();
  if (std::count(std::begin(seen_), std::end(seen_), true) != 2) {
    throw InputError("a line with 'error' has no other key than 'n'");
  }
  return UndrawnGraph{n_, std::move(error_)};
}

}  // namespace ar3d
