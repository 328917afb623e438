#pragma once

#include <optional>
#include <string>
#include <utility>

#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"
#include "ar3d/model/guarantee.h"
#include "ar3d/verify/counting/column_proof.h"
#include "ar3d/verify/counting/counting_proof.h"
#include "ar3d/verify/examination.h"
#include "ar3d/verify/metrics/summary_pass.h"

namespace ar3d::verify {

/// One pass over the polylines for everything that is wanted: summary, hash, and what a proof by
/// counting needs. On several threads (threads_for() the edges) the proof's share of it is divided
/// among them, and summary and hash, which need the edges in order, are made beside it.
class ExaminationPass {
 public:
  ExaminationPass(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                  const ExaminationParts& parts, const CertifyOptions& options);

  void run();
  /// After run(): of the drawing.
  const DrawingSummary& summary() const { return summary_; }
  /// After run(): empty if it is not wanted.
  std::string take_hash() { return std::move(hash_); }
  /// After run(): true if the drawing is proved right up to bends, lattice and box, false if no
  /// proof is wanted or it does not hold.
  bool proof_holds();
  /// Gives up the proof's memory.
  void drop_proof();

 private:
  void prepare_proof(const Graph& graph, const Guarantee& guarantee, const CertifyOptions& options);
  void run_in_order(bool with_proof);
  void run_on_threads();

  const Drawing& drawing_;
  ExaminationParts parts_;
  std::uint32_t threads_;
  DrawingSummary summary_;
  std::string hash_;
  std::optional<CountingProof> by_planes_;
  std::optional<ColumnProof> by_columns_;
};

}  // namespace ar3d::verify
