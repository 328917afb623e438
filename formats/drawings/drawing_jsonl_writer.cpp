// Appends by hand instead of through a JSON library: a drawing of 10^7 edges is written without
// ever being one text.
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/formats/text/output.h"
#include "ar3d/model/real_points.h"

namespace ar3d {
namespace {

std::string json_string(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void append_point(std::string& out, Point p) { append_all(out, '[', p.x, ',', p.y, ',', p.z, ']'); }

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

void append_head(std::string& out, const Drawing& drawing) {
  append_all(out, "{\"n\":", drawing.num_vertices(),
             ",\"algorithm\":", json_string(drawing.algorithm()));
  if (drawing.real) {
    append_all(out, ",\"real_type\":", json_string(drawing.real->type),
               ",\"unit_exponent\":", drawing.real->unit_exponent);
    return;
  }
  const char* separator = ",\"gram\":[";
  for (const auto& row : drawing.lattice().gram) {
    out += std::exchange(separator, ",");
    append_point(out, {row[0], row[1], row[2]});
  }
  append_all(out, "],\"gram_denominator\":", drawing.lattice().gram_denominator);
}

template <class AppendPoint, class Points>
void append_edge(std::string& out, Edge ends, const Points& bends, AppendPoint append) {
  append_all(out, '[', ends.u, ',', ends.v, ",[");
  const char* separator = "";
  for (const auto& bend : bends) {
    out += std::exchange(separator, ",");
    append(out, bend);
  }
  out += "]]";
}

/// Appends the line.
template <class Flush>
void append_line(std::string& out, const Drawing& drawing, Flush flush) {
  append_head(out, drawing);
  out += ",\"vertices\":";
  append_vertices(out, drawing, flush);
  out += ",\"edges\":[";
  const auto begin_edge = [&](EdgeId e) {
    if (e == 0) return;
    flush();
    out += ',';
  };
  if (drawing.real) {
    for (EdgeId e = 0; e < drawing.num_edges(); ++e) {
      begin_edge(e);
      append_edge(out, drawing.edge(e), drawing.real->bends_of(e), append_big_point);
    }
  } else {
    for_each_polyline(drawing, [&](EdgeId e, std::span<const Point> polyline) {
      begin_edge(e);
      append_edge(out, drawing.edge(e), polyline.subspan(1, polyline.size() - 2), append_point);
    });
  }
  out += ']';
  const char* separator = ",\"names\":[";
  for (std::size_t v = 0; drawing.names && v < drawing.names->size(); ++v) {
    append_all(out, std::exchange(separator, ","), json_string((*drawing.names)[v]));
    flush();
  }
  out += drawing.names && !drawing.names->empty() ? "]}\n" : "}\n";
}

}  // namespace

void append_drawing_line(std::string& out, const Drawing& drawing) {
  append_line(out, drawing, [] {});
}

void append_error_line(std::string& out, const UndrawnGraph& undrawn) {
  append_all(out, "{\"n\":", undrawn.n, ",\"error\":", json_string(undrawn.error), "}\n");
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
