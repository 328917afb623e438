#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "ar3d/formats/drawings/drawing_numbers.h"
#include "ar3d/formats/text/output.h"
#include "ar3d/formats/text/text_input.h"
#include "ar3d/model/drawing.h"

namespace ar3d {

/// A graph of n vertices that could not be drawn, and why.
struct UndrawnGraph {
  std::uint64_t n = 0;
  std::string error;
  friend bool operator==(const UndrawnGraph&, const UndrawnGraph&) = default;
};

/// Appends the drawing as one line of JSON:
///   {"n":N,"algorithm":"…","gram":[[…],[…],[…]],"gram_denominator":D,
///    "vertices":[[x,y,z],…],"edges":[[u,v,[[x,y,z],…]],…]}
/// with the bends of an edge in order from u to v, and "names":["…",…] before the end if the
/// vertices have names. Exact: integers only. A drawing in a real type
/// has instead of gram and gram_denominator
///   "real_type":"double","unit_exponent":E
/// and its coordinates are texts of decimal integers of any length, in units of 2^E.
void append_drawing_line(std::string& out, const Drawing& drawing);

/// Appends {"n":N,"error":"…"} as one line.
void append_error_line(std::string& out, const UndrawnGraph& undrawn);

/// Writes the drawing's line without ever holding it as a whole. @throws InputError if it cannot be
/// written.
void write_drawing_line(OutputFile& output, const Drawing& drawing);

/// Writes the positions alone, as they stand in the drawing's line: [[x,y,z],…]. @throws InputError
/// if it cannot be written.
void write_vertices(OutputFile& output, const Drawing& drawing);

/// Reads drawings, and graphs that could not be drawn, line by line.
class DrawingJsonlReader {
 public:
  using Line = std::variant<Drawing, UndrawnGraph>;

  /// @throws InputError if the file cannot be opened, is empty or holds a graph ("-" is standard
  /// input; gzip and xz are unpacked).
  explicit DrawingJsonlReader(const std::string& path) : DrawingJsonlReader(TextInput(path)) {}
  explicit DrawingJsonlReader(TextInput input);

  /// The next line that is not blank; nothing at the end. Memory: the line and its drawing.
  /// @throws InputError "FILE:LINE: message" on anything but the shape above: syntax errors,
  /// unknown, missing or repeated keys, another number of names than vertices, numbers that are not
  /// integers of 64 bits, coordinates beyond kMaxCoordinate, ids out of range, a Gram matrix that
  /// is none.
  std::optional<Line> next();

  /// "FILE:LINE" of the line just given.
  std::string where() const;

 private:
  std::unique_ptr<TextInput> input_;
};

using DecimalPoint = std::array<Decimal, 3>;

/// Holds what a program answers to a graph, in the numbers that it wrote.
struct DecimalDrawing {
  std::string error;  ///< why it draws nothing; empty: it draws
  double seconds = std::numeric_limits<double>::quiet_NaN();  ///< its own time, if it says so
  std::vector<DecimalPoint> vertices;
  std::optional<std::vector<Edge>> edges;
  std::vector<std::size_t> offsets{0};  ///< bends of edge e: bends[offsets[e]] ... [offsets[e + 1]]
  std::vector<DecimalPoint> bends;
};

/// Reads {"vertices":[[x,y,z],…],"edges":[[u,v,[[x,y,z],…]],…],"seconds":s}, or {"error":"…"}:
/// `edges`, `seconds`, the bends of an edge and z may be left out.
/// @throws InputError if it is not that, or as parse_decimal.
DecimalDrawing read_decimal_drawing(std::string_view line);

}  // namespace ar3d
