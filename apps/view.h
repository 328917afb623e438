#pragma once

#include <string>

#include "ar3d/formats/drawings/catalog.h"
#include "ar3d/formats/drawings/drawing_html.h"
#include "ar3d/model/graph.h"

namespace ar3d {

struct Algorithm;

/// Writes an HTML page that shows the drawings, each judged on the graph that it draws against the
/// guarantee of `algorithm`, or, if that is empty, of the algorithm that the drawing names.
/// @throws InputError if it cannot be written, or the drawings are too large for a page.
void write_viewer_page(const NextDrawing& next, const std::string& path,
                       const std::string& algorithm = {});

/// Returns the graph that a drawing itself claims to show. @throws InputError if its edges are no
/// simple graph's.
Graph claimed_graph(const Drawing& drawing);

/// Returns the vertices and edges of a drawing; 0 if there is none (batches.h).
std::uint64_t weight_of(const DrawingJsonlReader::Line& line);

/// Returns the algorithm of that name, or null: drawings may be of others, too.
const Algorithm* known_algorithm(const std::string& name);

/// Returns what a page says of a drawing, judged on the graph `given` (null: the one that it
/// claims) against the guarantee of `algorithm`; null: nothing is judged.
PageVerdict page_verdict(const Drawing& drawing, const Algorithm* algorithm,
                         const Graph* given = nullptr);

/// Adds the drawing format that needs more than formats/ may include: the viewer's page, which
/// judges what it shows. To be called once, before the verbs are.
void register_program_formats();

}  // namespace ar3d
