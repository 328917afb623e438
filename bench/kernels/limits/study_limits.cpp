// Rows of a study per second of wall time, everything on (certificate, metrics, hashes), by number
// of workers.
#include <fmt/format.h>

#include <stdexcept>

#include "../turns.h"
#include "ar3d/bench/plan/plan.h"
#include "ar3d/bench/run/session.h"
#include "limit.h"

namespace ar3d::kernels {
namespace {

constexpr int kRows = 2000;

class Valid final : public RowSink {
 public:
  void add(std::size_t, const RunRecord& run) override {
    if (run.status != RunStatus::ok) throw std::runtime_error("a row failed: " + run.message);
  }
};

void measure_rows(const RunSize& scale, std::vector<Limit>& limits) {
  const StudyPlan plan = plan_study(
      parse_study(fmt::format("study = \"limits\"\n[[sweep]]\nfamilies = \"random-cubic\"\n"
                              "sizes = {}\nalgorithms = \"grid\"\ninstances = {}\n",
                              scale.n, kRows),
                  "limits.toml"));
  const auto with_workers = [&](int workers) {
    return [&, workers] {
      Valid sink;
      SessionPolicy policy;
      policy.workers = workers;
      run_session(plan, policy, sink);
    };
  };
  Turns turns({timed(Clock::wall, with_workers(1)), timed(Clock::wall, with_workers(2))});
  turns.run(scale.repetitions);
  limits[0].measured = turns.median_of(0) / turns.median_of(1);
  limits[0].remark = fmt::format("{:.0f} and {:.0f} rows per second", kRows / turns.median_of(0),
                                 kRows / turns.median_of(1));
}

}  // namespace

std::vector<LimitGroup> study_groups() {
  return {{"study/rows",
           1000,
           {{"rows of `grid`, random cubic, 2 workers", "1 worker", at_least(1.95)}},
           measure_rows}};
}

std::vector<LimitGroup> layout_groups() {
  return {{"layouts",
           100'000,
           {{"layouts of other programs in three dimensions", "ours", at_least(1)}},
           [](const RunSize&, std::vector<Limit>&) {
             throw NotMeasured("a study of minutes to hours, docs/performance.md");
           }}};
}

}  // namespace ar3d::kernels
