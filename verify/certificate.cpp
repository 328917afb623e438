// Certifies a drawing. One pass tries the quick proof by counting; if that does not hold, every
// check runs and names what is wrong. A drawing in a real type is measured instead of proved.
#include "ar3d/verify/certificate.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "ar3d/base/error.h"
#include "ar3d/base/nearest_name.h"
#include "ar3d/base/printable.h"
#include "ar3d/model/real_points.h"
#include "ar3d/verify/checks/checks.h"
#include "ar3d/verify/crossings/contacts.h"
#include "ar3d/verify/crossings/crossings.h"
#include "ar3d/verify/crossings/segments.h"
#include "ar3d/verify/examination.h"
#include "ar3d/verify/examination_pass.h"
#include "ar3d/verify/metrics/summary_pass.h"

namespace ar3d {
namespace {

using verify::Contacts;
using verify::Findings;
using verify::Segments;

[[noreturn]] void refuse_many_directions() {
  throw InputError(fmt::format(
      "the plane sweep takes drawings with at most {} directions of components below {}",
      verify::kMaxDirections, verify::kMaxDirectionComponent));
}

/// False if it gave up.
bool check_crossings(const Segments& segments, const CertifyOptions& options, Findings& findings) {
  const CrossingTest test = options.crossing_test;
  Contacts contacts(segments, findings, options.most_comparisons);
  const bool may_plane_sweep = test == CrossingTest::automatic || test == CrossingTest::plane_sweep;
  const auto classes = may_plane_sweep ? few_directions(segments) : std::nullopt;
  if (classes) {
    test_by_plane_sweep(segments, *classes, contacts);
  } else if (test == CrossingTest::plane_sweep) {
    refuse_many_directions();
  } else if (test == CrossingTest::all_pairs) {
    test_all_pairs(segments, contacts);
  } else {
    test_by_slabs(segments, contacts);
  }
  contacts.report();
  return !contacts.gave_up();
}

/// Do all edges have segments of positive length and no more bends than promised?
bool keeps_bends(const DrawingSummary& summary, const Guarantee& guarantee) {
  return summary.repeated_points == 0 &&
         summary.bend_histogram.size() <= std::size_t{guarantee.max_bends} + 1;
}

/// Everything that needs differences of coordinates, hence coordinates in range. False if it gave
/// up.
bool check_geometry(const Drawing& drawing, const Guarantee& guarantee,
                    const CertifyOptions& options, Findings& findings) {
  const Segments segments(drawing);
  check_directions(segments, guarantee, findings);
  check_bend_angles(segments, guarantee, findings);
  check_vertex_angles(segments, guarantee, findings);
  check_distinct_vertices(drawing, findings);
  return findings.done() || check_crossings(segments, options, findings);
}

/// Lattice, bends, range and box, without names for what is wrong.
bool keeps_places(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                  const CertifyOptions& options, const DrawingSummary& summary) {
  Findings findings(0);
  check_lattice(drawing, guarantee, findings);
  if (options.check_size) check_size(graph, summary.box, guarantee, findings);
  return findings.empty() && keeps_bends(summary, guarantee) && summary.in_range;
}

Certificate valid_certificate(const DrawingSummary& summary) {
  Certificate certificate;
  certificate.complete = true;
  certificate.box = summary.box;
  certificate.bend_histogram = summary.bend_histogram;
  certificate.segments = summary.segments;
  return certificate;
}

/// Names every violation.
Certificate certify_in_full(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                            const CertifyOptions& options, const DrawingSummary& summary) {
  Findings findings(options.max_violations);
  check_graph(graph, drawing, findings);
  check_lattice(drawing, guarantee, findings);
  check_plane(drawing, guarantee, findings);
  if (!keeps_bends(summary, guarantee)) check_bends(drawing, guarantee, findings);
  bool given_up = false;
  if (summary.in_range) {
    if (options.check_size) check_size(graph, summary.box, guarantee, findings);
    given_up = !check_geometry(drawing, guarantee, options, findings);
  } else {
    check_coordinates(drawing, findings);
  }
  Certificate certificate = valid_certificate(summary);
  certificate.given_up = given_up;
  certificate.complete = summary.in_range && !findings.done() && !given_up;
  certificate.violations = findings.take();
  if (!summary.in_range) certificate.segments = 0;
  return certificate;
}

void check_claim(const Drawing& drawing, const Guarantee& guarantee, Findings& findings) {
  if (guarantee.claim == Claim::measured) return;
  findings.add({ViolationKind::lattice,
                {},
                {},
                {},
                fmt::format("the points are in the real type {}, the guarantee speaks of a lattice",
                            drawing.real->type)});
}

void check_bends(const RealPoints& points, const Guarantee& guarantee, Findings& findings) {
  for (EdgeId e = 0; e + 1 < points.offsets.size() && !findings.done(); ++e) {
    const std::size_t bends = points.bends_of(e).size();
    if (bends <= guarantee.max_bends) continue;
    findings.add({ViolationKind::bends,
                  {},
                  {e},
                  {},
                  fmt::format("edge {} has {} bends, at most {} are promised", e, bends,
                              guarantee.max_bends)});
  }
}

/// Of a drawing in a real type. Violations are what rounding cannot excuse: another graph, too many
/// bends, and, if the guarantee is no Claim::measured, that the drawing is in a real type at all.
Examination examine_real(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                         const ExaminationParts& parts, const CertifyOptions& options) {
  Examination result;
  if (parts.hash) result.drawing_hash = drawing_hash(drawing);
  if (!parts.certificate && !parts.metrics) return result;
  result.summary = verify::measure_real(drawing);
  if (!parts.certificate) return result;
  Findings findings(options.max_violations);
  check_graph(graph, drawing, findings);
  check_claim(drawing, guarantee, findings);
  check_bends(*drawing.real, guarantee, findings);
  Certificate& certificate = result.certificate;
  certificate.measured = true;
  certificate.complete = !findings.done();
  certificate.violations = findings.take();
  certificate.box = result.summary.box;
  certificate.bend_histogram = result.summary.bend_histogram;
  certificate.segments = result.summary.segments;
  return result;
}

}  // namespace

std::string to_string(CertificateMode mode) {
  return mode == CertificateMode::exact ? "exact" : "none";
}

CertificateMode parse_certificate_mode(std::string_view text) {
  for (const CertificateMode mode : {CertificateMode::exact, CertificateMode::none}) {
    if (text == to_string(mode)) return mode;
  }
  throw InputError(fmt::format("certificate '{}' is none of exact and none{}",
                               printable(std::string(text)),
                               did_you_mean(text, {"exact", "none"})));
}

Certificate certify(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                    const CertifyOptions& options) {
  const ExaminationParts parts{.certificate = true, .metrics = false, .hash = false};
  return examine(graph, drawing, guarantee, parts, options).certificate;
}

Examination examine(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                    const ExaminationParts& parts, const CertifyOptions& options) {
  if (drawing.real) return examine_real(graph, drawing, guarantee, parts, options);
  Examination result;
  verify::ExaminationPass pass(graph, drawing, guarantee, parts, options);
  pass.run();
  result.summary = pass.summary();
  result.drawing_hash = pass.take_hash();
  if (!parts.certificate) return result;
  if (options.mode == CertificateMode::none) {
    result.certificate = valid_certificate(result.summary);
    result.certificate.mode = options.mode;
    return result;
  }
  const bool proved =
      keeps_places(graph, drawing, guarantee, options, result.summary) && pass.proof_holds();
  pass.drop_proof();
  result.certificate = proved ? valid_certificate(result.summary)
                              : certify_in_full(graph, drawing, guarantee, options, result.summary);
  return result;
}

}  // namespace ar3d
