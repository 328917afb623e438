// Certifies a drawing. One pass tries the quick proof by counting; if that does not hold, every
// check runs and names what is wrong. A drawing in a real type is measured instead of proved.
#include "ar3d/verify/certificate.h"

#include <chrono>

#include "ar3d/base/parallel.h"
#include "ar3d/model/real_points.h"
#include "ar3d/verify/checks/checks.h"
#include "ar3d/verify/counting/counting_proof.h"
#include "ar3d/verify/crossings/contacts.h"
#include "ar3d/verify/examination.h"
#include "ar3d/verify/metrics/summary_pass.h"

namespace ar3d {
namespace {

using verify::Contacts;
using verify::Findings;
using verify::Segments;

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// One pass over the polylines for everything that is wanted: summary, hash, and what a proof by
/// counting needs. On several threads (threads_for() the edges) the proof's share of it is divided
/// among them, and summary and hash, which need the edges in order, are made beside it.
class ExaminationPass {
 public:
  ExaminationPass(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                  const ExaminationParts& parts, const CertifyOptions& options)
      : drawing_(drawing), parts_(parts), threads_(threads_for(drawing.num_edges())) {
    if (!parts.certificate || options.crossing_test != CrossingTest::automatic ||
        options.mode != CertificateMode::exact || options.most_comparisons != 0) {
      return;
    }
    if (guarantee.directions.empty()) {
      by_columns_.emplace(graph, drawing_, guarantee);
    } else {
      by_planes_.emplace(graph, drawing_, guarantee,
                         verify::CountingSizes{.memory = options.proof_bytes, .threads = threads_});
    }
  }

  void run() {
    const double begin = now_s();
    const bool on_threads = by_planes_ && threads_ > 1;
    on_threads ? run_on_threads() : run_in_order(true);
    certify_s_ = now_s() - begin - (on_threads ? 0 : metrics_s_);
  }
  /// After run(): wall time of what the proof alone needs, and of summary and hash. On several
  /// threads one is made beside the other.
  double certify_s() const { return certify_s_; }
  double metrics_s() const { return metrics_s_; }
  /// After run(): of the drawing.
  const DrawingSummary& summary() const { return summary_; }
  /// After run(): empty if it is not wanted.
  std::string take_hash() { return std::move(hash_); }
  /// After run(): true if the drawing is proved right up to bends, lattice and box, false if no
  /// proof is wanted or it does not hold.
  bool proof_holds() {
    return (by_planes_ && by_planes_->holds(summary_)) || (by_columns_ && by_columns_->holds());
  }

 private:
  /// By blocks of polylines, so that what is timed takes longer than reading the clock.
  void run_in_order(bool with_proof) {
    double begin = now_s();
    verify::SummaryPass summary(drawing_, parts_.metrics);
    std::optional<DrawingHash> hash;
    if (parts_.hash) hash.emplace(drawing_);
    metrics_s_ = now_s() - begin;
    const auto visit = [&](EdgeId first, std::span<const std::vector<Point>> polylines) {
      begin = now_s();
      for (const auto& points : polylines) summary.add(points);
      for (EdgeId e = first; hash && e < first + polylines.size(); ++e) {
        hash->add(drawing_.edge(e), polylines[e - first]);
      }
      metrics_s_ += now_s() - begin;
      for (EdgeId e = first; with_proof && e < first + polylines.size(); ++e) {
        if (by_planes_) by_planes_->add(drawing_.edge(e), polylines[e - first]);
        if (by_columns_) by_columns_->add(drawing_.edge(e), polylines[e - first]);
      }
    };
    for_each_polyline_block(drawing_, 0, drawing_.num_edges(), visit);
    begin = now_s();
    summary_ = summary.finish();
    if (hash) hash_ = hash->digest();
    metrics_s_ += now_s() - begin;
  }

  void run_on_threads() {
    const bool is_ordered = parts_.metrics || parts_.hash;
    std::vector<verify::SummaryPass> summaries;  // of the threads
    for (std::uint32_t t = 0; t < threads_ && !is_ordered; ++t) summaries.emplace_back(drawing_);
    const std::size_t m = drawing_.num_edges(), n = is_ordered ? 0 : drawing_.num_vertices();
    const std::size_t of_edges = blocks_below(m);
    for_each_in_threads(
        threads_, 1 + of_edges + blocks_below(n), [&](std::uint32_t thread, std::size_t i) {
          if (i == 0) {
            if (is_ordered) run_in_order(false);
            return;
          }
          const bool takes_edges = i <= of_edges;
          const auto range = takes_edges ? block_below(m, i - 1) : block_below(n, i - 1 - of_edges);
          const auto [begin, end] = std::pair<std::uint32_t, std::uint32_t>(range);
          if (!takes_edges) return summaries[thread].add_vertices(begin, end);
          for_each_polyline(drawing_, begin, end, [&](EdgeId e, const std::vector<Point>& points) {
            by_planes_->add(drawing_.edge(e), points, thread);
            if (!is_ordered) summaries[thread].add(points);
          });
        });
    if (is_ordered) return;
    for (std::size_t t = 1; t < summaries.size(); ++t) summaries[0].absorb(summaries[t]);
    summary_ = summaries[0].finish();
  }

  const Drawing& drawing_;
  ExaminationParts parts_;
  std::uint32_t threads_;
  DrawingSummary summary_;
  std::string hash_;
  double certify_s_ = 0, metrics_s_ = 0;
  std::optional<verify::CountingProof> by_planes_;
  std::optional<verify::ColumnProof> by_columns_;
};

/// False if it gave up.
bool check_crossings(const Segments& segments, const CertifyOptions& options, Findings& findings) {
  const bool is_oracle = options.crossing_test == CrossingTest::all_pairs;
  Contacts contacts(
      segments, findings,
      options.most_comparisons == 0 && !is_oracle ? kMostComparisons : options.most_comparisons);
  contacts.compares = options.compares;
  if (is_oracle) {
    test_all_pairs(segments, contacts);
  } else {
    test_by_halving(segments, contacts);
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
  findings.add(ViolationKind::lattice, {}, {}, {},
               "the points are in the real type {}, the guarantee speaks of a lattice",
               drawing.real->type);
}

void check_bends(const RealPoints& points, const Guarantee& guarantee, Findings& findings) {
  for (EdgeId e = 0; e + 1 < points.offsets.size() && !findings.done(); ++e) {
    const std::size_t bends = points.bends_of(e).size();
    if (bends <= guarantee.max_bends) continue;
    findings.add(ViolationKind::bends, {}, {e}, {}, "edge {} has {} bends, at most {} are promised",
                 e, bends, guarantee.max_bends);
  }
}

/// Examines a drawing in a real type. Violations are what rounding cannot excuse: another graph,
/// too many bends, and, if the guarantee is no Claim::measured, that the drawing is in a real type
/// at all.
Examination examine_real(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                         const ExaminationParts& parts, const CertifyOptions& options) {
  Examination result;
  const double begin = now_s();
  if (parts.hash) result.drawing_hash = drawing_hash(drawing);
  result.metrics_s = now_s() - begin;
  if (!parts.certificate && !parts.metrics) return result;
  result.summary = verify::measure_real(drawing);
  result.certify_s = now_s() - begin - result.metrics_s;
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

Certificate certify(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                    const CertifyOptions& options) {
  const ExaminationParts parts{.certificate = true, .metrics = false, .hash = false};
  return examine(graph, drawing, guarantee, parts, options).certificate;
}

Examination examine(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                    const ExaminationParts& parts, const CertifyOptions& options) {
  if (drawing.real) return examine_real(graph, drawing, guarantee, parts, options);
  Examination result;
  std::optional<ExaminationPass> pass(std::in_place, graph, drawing, guarantee, parts, options);
  pass->run();
  result.summary = pass->summary();
  result.drawing_hash = pass->take_hash();
  result.certify_s = pass->certify_s();
  result.metrics_s = pass->metrics_s();
  if (!parts.certificate) return result;
  if (options.mode == CertificateMode::none) {
    result.certificate = valid_certificate(result.summary);
    result.certificate.mode = options.mode;
    return result;
  }
  const double begin = now_s();
  const bool proved =
      keeps_places(graph, drawing, guarantee, options, result.summary) && pass->proof_holds();
  pass.reset();  // the proof's memory
  result.certificate = proved ? valid_certificate(result.summary)
                              : certify_in_full(graph, drawing, guarantee, options, result.summary);
  result.certify_s += now_s() - begin;
  return result;
}

}  // namespace ar3d
