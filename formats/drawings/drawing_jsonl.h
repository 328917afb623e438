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

/// digits * 10^exponent, the digits without trailing zeros; 0 is 0 * 10^0.
struct Decimal {
  std::int64_t digits = 0;
  int exponent = 0;
};

/// Reads a number as JSON writes it, exactly.
/// @throws InputError naming it if it has more than 18 significant digits or an exponent beyond
/// 1000.
Decimal parse_decimal(const std::string& text);

/// The number in units of 10^unit. @pre unit <= number.exponent, unless it is 0.
/// @throws InputError if that passes kMaxCoordinate.
std::int64_t scaled(const Decimal& number, int unit);

/// @throws InputError if the type is none of float, double, binary80, binary128 and reference,
/// or naming the first vertex, else the first bend in order of edges, with a coordinate that needs
/// more significant bits than the type has (24, 53, 64, 113, 237).
void require_values_of_type(const RealPoints& points);

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
