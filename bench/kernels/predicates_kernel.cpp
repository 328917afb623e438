// What a decision costs in each arithmetic (verify/predicates/choices.h), on drawings of random
// graphs:
//   predicates/angle/ARITHMETIC/ALGORITHM/N    up to 20,000 angles of the drawing, at bends and
//                                              vertices
//   predicates/meeting/ARITHMETIC/ALGORITHM/N  up to 20,000 pairs of its segments whose boxes meet
// Counter `bits`: what the range check says the drawing's decisions need. Integers that are too
// narrow are not timed.

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <utility>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/verify/predicates/choices.h"
#include "inputs.h"
#include "precision/precision.h"

namespace ar3d::kernels {
namespace {

using precision::Decisions;
using verify::PredicateChoice;

constexpr std::size_t kMostDecisions = 20000;

void decide_angles(const PredicateChoice& choice, const Decisions& decisions) {
  std::size_t equal = 0;
  for (const auto& [from, at, to] : decisions.angles) {
    equal += choice.angle(decisions.lattice, from, at, to, decisions.cosine) == 0;
  }
  benchmark::DoNotOptimize(equal);
}

void decide_meetings(const PredicateChoice& choice, const Decisions& decisions) {
  std::size_t meetings = 0;
  for (const auto& [a, b, c, d] : decisions.pairs) {
    meetings += choice.meeting(a, b, c, d) != verify::MeetingKind::nothing;
  }
  benchmark::DoNotOptimize(meetings);
}

/// Integers that do not hold the drawing's values would wrap.
bool may_be_timed(const PredicateChoice& choice, int bits) {
  return bits <= choice.exact_bits || (choice.name != "int64" && choice.name != "int128");
}

const Decisions& decisions_of(const Algorithm& algorithm, std::int64_t n) {
  static std::map<std::pair<std::string, std::int64_t>, Decisions> kept;
  const std::pair wanted(algorithm.name, n);
  if (const auto found = kept.find(wanted); found != kept.end()) return found->second;
  const Graph& graph = graph_of(random_family(algorithm), static_cast<std::uint64_t>(n));
  return kept
      .emplace(wanted,
               precision::decisions_of(draw(algorithm, graph), algorithm.guarantee, kMostDecisions))
      .first->second;
}

using Decide = void (*)(const PredicateChoice&, const Decisions&);

void time_decisions(benchmark::State& state, const Algorithm& algorithm,
                    const PredicateChoice& choice, bool angles) {
  const Decisions& decisions = decisions_of(algorithm, state.range(0));
  const std::size_t count = angles ? decisions.angles.size() : decisions.pairs.size();
  const int bits = angles ? decisions.bits.angle : decisions.bits.meeting;
  const Decide decide = angles ? decide_angles : decide_meetings;
  if (bits > verify::kInt128Bits || count == 0) {
    return state.SkipWithError("int128 does not hold this drawing's decisions, or there are none");
  }
  if (!may_be_timed(choice, bits)) return state.SkipWithError("too narrow for this drawing");
  for (auto _ : state) decide(choice, decisions);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
  state.counters["bits"] = bits;
}

const bool kRegistered = [] {
  for (const Algorithm* row : proved_algorithms()) {
    for (const PredicateChoice& choice : verify::predicate_choices()) {
      for (const bool angles : {true, false}) {
        const std::string what = angles ? "predicates/angle/" : "predicates/meeting/";
        benchmark::RegisterBenchmark((what + std::string(choice.name) + "/" + row->name).c_str(),
                                     [row, &choice, angles](benchmark::State& state) {
                                       time_decisions(state, *row, choice, angles);
                                     })
            ->Arg(1000)
            ->Arg(10000)
            ->Unit(benchmark::kMicrosecond);
      }
    }
  }
  return true;
}();

}  // namespace
}  // namespace ar3d::kernels
