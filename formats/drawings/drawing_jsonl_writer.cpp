#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/formats/text/numbers_text.h"
#include "ar3d/model/real_points.h"

namespace ar3d {
namespace {

std::string json_string(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void append_point(std::string& out, Point p) {
  out += '[';
  append_number(out, p.x);
  out += ',';
  append_number(out, p.y);
  out += ',';
  append_number(out, p.z);
  out += ']';
}

void append_big_point(std::string& out, const BigPoint& p) {
  out += "[\"" + p.x.str() + "\",\"" + p.y.str() + "\",\"" + p.z.str() + "\"]";
}

/// Appends [[x,y,z],…], the vertices' positions. Here and below `flush` is called after every
/// vertex and edge and may empty the text.
template <class Flush>
void append_vertices(std::string& out, const Drawing& drawing, Flush flush) {
  out += '[';
  for (std::size_t v = 0; v < drawing.num_vertices(); ++v) {
    if (v > 0) out += ',';
    if (drawing.real) {
      append_big_point(out, drawing.real->vertices[v]);
    } else {
      append_point(out, drawing.vertex(static_cast<Vertex>(v)));
    }
    flush();
  }
  out += ']';
}

/// The line of a drawing in a real type.
template <class Flush>
void append_real_line(std::string& out, const Drawing& drawing, Flush flush) {
  const RealPoints& points = *drawing.real;
  out += "{\"n\":";
  append_number(out, drawing.num_vertices());
  out += ",\"algorithm\":" + json_string(drawing.algorithm());
  out += ",\"real_type\":" + json_string(points.type) + ",\"unit_exponent\":";
  append_number(out, points.unit_exponent);
  out += ",\"vertices\":";
  append_vertices(out, drawing, flush);
  out += ",\"edges\":[";
  for (EdgeId e = 0; e < drawing.num_edges(); ++e) {
    if (e > 0) out += ',';
    out += '[';
    append_number(out, drawing.edge(e).u);
    out += ',';
    append_number(out, drawing.edge(e).v);
    out += ",[";
    bool is_first = true;
    for (const BigPoint& bend : points.bends_of(e)) {
      if (!std::exchange(is_first, false)) out += ',';
      append_big_point(out, bend);
    }
    out += "]]";
    flush();
  }
  out += "]}\n";
}

void append_head(std::string& out, const Drawing& drawing) {
  out += "{\"n\":";
  append_number(out, drawing.num_vertices());
  out += ",\"algorithm\":" + json_string(drawing.algorithm()) + ",\"gram\":[";
  for (std::size_t row = 0; row < 3; ++row) {
    const auto& entries = drawing.lattice().gram[row];
    if (row > 0) out += ',';
    append_point(out, {entries[0], entries[1], entries[2]});
  }
  out += "],\"gram_denominator\":";
  append_number(out, drawing.lattice().gram_denominator);
}

void append_edge(std::string& out, Edge ends, const std::vector<Point>& polyline) {
  out += '[';
  append_number(out, ends.u);
  out += ',';
  append_number(out, ends.v);
  out += ",[";
  for (std::size_t i = 1; i + 1 < polyline.size(); ++i) {
    if (i > 1) out += ',';
    append_point(out, polyline[i]);
  }
  out += "]]";
}

/// Appends the line.
template <class Flush>
void append_line(std::string& out, const Drawing& drawing, Flush flush) {
  if (drawing.real) return append_real_line(out, drawing, flush);
  append_head(out, drawing);
  out += ",\"vertices\":";
  append_vertices(out, drawing, flush);
  out += ",\"edges\":[";
  for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& polyline) {
    if (e > 0) out += ',';
    append_edge(out, drawing.edge(e), polyline);
    flush();
  });
  out += "]}\n";
}

}  // namespace

void append_drawing_line(std::string& out, const Drawing& drawing) {
  append_line(out, drawing, [] {});
}

void append_error_line(std::string& out, const UndrawnGraph& undrawn) {
  out += "{\"n\":";
  append_number(out, undrawn.n);
  out += ",\"error\":" + json_string(undrawn.error) + "}\n";
}

void write_vertices(OutputFile& output, const Drawing& drawing) {
  append_vertices(output.pending(), drawing, [&] { output.flush_if_full(); });
  output.flush_if_full();
}

void write_drawing_line(OutputFile& output, const Drawing& drawing) {
  append_line(output.pending(), drawing, [&] { output.flush_if_full(); });
  output.flush_if_full();
}

}  // namespace ar3d
