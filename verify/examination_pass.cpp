// Computes every polyline once and hands it to all who want it: summary, hash and proof by
// counting. Sums of doubles and hashes need the order of edges, so one thread makes them beside the
// proof.
#include "ar3d/verify/examination_pass.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "ar3d/base/parallel.h"

namespace ar3d::verify {

ExaminationPass::ExaminationPass(const Graph& graph, const Drawing& drawing,
                                 const Guarantee& guarantee, const ExaminationParts& parts,
                                 const CertifyOptions& options)
    : drawing_(drawing), parts_(parts), threads_(threads_for(drawing.num_edges())) {
  if (parts.certificate && options.crossing_test == CrossingTest::automatic &&
      options.mode == CertificateMode::exact && options.most_comparisons == 0) {
    prepare_proof(graph, guarantee, options);
  }
}

void ExaminationPass::prepare_proof(const Graph& graph, const Guarantee& guarantee,
                                    const CertifyOptions& options) {
  if (guarantee.directions.empty()) {
    by_columns_.emplace(graph, drawing_, guarantee);
    return;
  }
  CountingSizes sizes;
  sizes.memory = options.proof_bytes;
  sizes.threads = threads_;
  by_planes_.emplace(graph, drawing_, guarantee, sizes);
}

void ExaminationPass::run() { by_planes_&& threads_ > 1 ? run_on_threads() : run_in_order(true); }

void ExaminationPass::run_in_order(bool with_proof) {
  SummaryPass summary(drawing_, parts_.metrics);
  std::optional<DrawingHash> hash;
  if (parts_.hash) hash.emplace(drawing_);
  for_each_polyline(drawing_, [&](EdgeId e, const std::vector<Point>& points) {
    summary.add(points);
    if (hash) hash->add(drawing_.edge(e), points);
    if (!with_proof) return;
    if (by_planes_) by_planes_->add(drawing_.edge(e), points);
    if (by_columns_) by_columns_->add(drawing_.edge(e), points);
  });
  summary_ = summary.finish();
  if (hash) hash_ = hash->digest();
}

void ExaminationPass::run_on_threads() {
  const bool is_ordered = parts_.metrics || parts_.hash;
  std::vector<SummaryPass> summaries;  // of the threads
  for (std::uint32_t t = 0; t < threads_ && !is_ordered; ++t) summaries.emplace_back(drawing_);
  const IndexRanges edges(drawing_.num_edges());
  const IndexRanges vertices(is_ordered ? 0 : drawing_.num_vertices());
  for_each_in_threads(
      threads_, 1 + edges.count() + vertices.count(), [&](std::uint32_t thread, std::size_t i) {
        if (i == 0) {
          if (is_ordered) run_in_order(false);
          return;
        }
        const bool takes_edges = i <= edges.count();
        const auto range = takes_edges ? edges[i - 1] : vertices[i - 1 - edges.count()];
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

bool ExaminationPass::proof_holds() {
  return (by_planes_ && by_planes_->holds(summary_)) || (by_columns_ && by_columns_->holds());
}

void ExaminationPass::drop_proof() {
  by_planes_.reset();
  by_columns_.reset();
}

}  // namespace ar3d::verify
