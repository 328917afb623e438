#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/model/real_points.h"

namespace ar3d {

/// A line that is not JSON.
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
  /// What the line says, once it is parsed. @throws InputError if a key is missing or the parts do
  /// not fit.
  DrawingJsonlReader::Line finish();

  // The parser's events, by the names that nlohmann-json gives them.
  bool null();
  bool boolean(bool value);
  bool number_integer(std::int64_t value);
  bool number_unsigned(std::uint64_t value);
  bool number_float(double value, const std::string& text);
  bool string(std::string& value);
  bool binary(nlohmann::json::binary_t& value);
  bool start_object(std::size_t size);
  bool key(std::string& name);
  bool end_object();
  bool start_array(std::size_t size);
  bool end_array();
  bool parse_error(std::size_t at, const std::string& token,
                   const nlohmann::json::exception& error);

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
    unit_exponent
  };
  static constexpr int kKeys = 10;

  std::string place() const;  // "vertices[5]" for messages
  [[noreturn]] void fail(const std::string& problem) const;
  [[noreturn]] void fail_list(
      const std::string& problem);         // about the innermost open array as a whole
  bool is_point(std::size_t depth) const;  // true where [x, y, z] stands at this nesting
  void end_point();
  void end_edge();
  void take_real_number(const std::string& text);
  void refuse_missing(std::initializer_list<Key> keys) const;
  Drawing finish_drawing();
  Drawing finish_real_drawing();

  Key key_ = Key::none;
  bool inside_object_ = false;
  bool seen_[kKeys] = {};
  std::vector<std::uint64_t> items_;  // per open array: values so far
  std::int64_t numbers_[3] = {};      // of the open point, or the ends of the open edge
  BigInteger real_numbers_[3];        // of the open point, in a real type
  RealPoints real_;                   // of a drawing in a real type
  bool has_texts_ = false;            // as coordinates
  bool has_integers_ = false;         // as coordinates
  std::uint64_t n_ = 0;
  std::string algorithm_;
  std::string error_;
  Lattice lattice_;
  std::vector<Point> vertices_;
  std::int64_t largest_ = 0;  // absolute value of a vertex coordinate
  std::shared_ptr<std::vector<Edge>> edges_ = std::make_shared<std::vector<Edge>>();
  Edge ends_;
  std::vector<Point> edge_bends_;
  std::shared_ptr<StoredBends> bends_ = std::make_shared<StoredBends>();
};

}  // namespace ar3d
