#include "ar3d/verify/certificate.h"

#include <fmt/format.h>

#include <optional>

#include "ar3d/model/error.h"
#include "ar3d/verify/checks.h"
#include "ar3d/verify/contacts.h"
#include "ar3d/verify/crossings.h"
#include "ar3d/verify/findings.h"
#include "ar3d/verify/segments.h"

namespace ar3d {
namespace {

using verify::Contacts;
using verify::Findings;
using verify::Segments;

[[noreturn]] void refuse_many_directions() {
  throw InputError(
      fmt::format("the sweep takes drawings with at most {} directions of components below {}",
                  verify::kMaxDirections, verify::kMaxDirectionComponent));
}

void check_crossings(const Segments& segments, CrossingTest test, Findings& findings) {
  Contacts contacts(segments, findings);
  const bool may_sweep = test == CrossingTest::automatic || test == CrossingTest::sweep;
  const auto classes = may_sweep ? few_directions(segments) : std::nullopt;
  if (classes) {
    test_by_sweep(segments, *classes, contacts);
  } else if (test == CrossingTest::sweep) {
    refuse_many_directions();
  } else if (test == CrossingTest::all_pairs) {
    test_all_pairs(segments, contacts);
  } else {
    test_by_slabs(segments, contacts);
  }
  contacts.report();
}

/// Everything that needs differences of coordinates, hence coordinates in range.
void check_geometry(const Drawing& drawing, const Guarantee& guarantee,
                    const CertifyOptions& options, Certificate& certificate, Findings& findings) {
  const Segments segments(drawing);
  certificate.segments = segments.size();
  check_directions(segments, guarantee, findings);
  check_bend_angles(segments, guarantee, findings);
  check_vertex_angles(segments, guarantee, findings);
  check_distinct_vertices(drawing, findings);
  if (!findings.done()) check_crossings(segments, options.crossing_test, findings);
}

}  // namespace

const char* to_string(ViolationKind kind) {
  switch (kind) {
    case ViolationKind::vertex_count:
      return "vertex_count";
    case ViolationKind::edge_set:
      return "edge_set";
    case ViolationKind::lattice:
      return "lattice";
    case ViolationKind::coordinate_range:
      return "coordinate_range";
    case ViolationKind::plane:
      return "plane";
    case ViolationKind::degenerate_segment:
      return "degenerate_segment";
    case ViolationKind::direction:
      return "direction";
    case ViolationKind::bends:
      return "bends";
    case ViolationKind::bend_angle:
      return "bend_angle";
    case ViolationKind::vertex_angle:
      return "vertex_angle";
    case ViolationKind::same_point:
      return "same_point";
    case ViolationKind::vertex_on_edge:
      return "vertex_on_edge";
    case ViolationKind::crossing:
      return "crossing";
    case ViolationKind::size:
      return "size";
  }
  throw InternalError("internal error: no name for a kind of violation");
}

Certificate certify(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                    const CertifyOptions& options) {
  Findings findings(options.max_violations);
  Certificate certificate;
  check_graph(graph, drawing, findings);
  check_lattice(drawing, guarantee, findings);
  check_plane(drawing, guarantee, findings);
  check_bends(drawing, guarantee, certificate.bend_histogram, findings);
  const bool in_range = check_coordinates(drawing, findings);
  if (in_range) {
    certificate.box = bounding_box(drawing);
    if (options.check_size) check_size(graph, certificate.box, guarantee, findings);
    check_geometry(drawing, guarantee, options, certificate, findings);
  }
  certificate.complete = in_range && !findings.done();
  certificate.violations = findings.take();
  return certificate;
}

}  // namespace ar3d
