// What a decision costs in each arithmetic (verify/predicates/choices.h), on drawings of random
// graphs, all timed in turns:
//   predicates/angle/ALGORITHM/N    up to 20,000 angles of the drawing, at bends and vertices
//   predicates/meeting/ALGORITHM/N  up to 20,000 pairs of its segments whose boxes meet
// The time is that of int128; counters: `ns`, its nanoseconds per decision by the median of the
// rounds; for every other arithmetic its time / that of int128, and `bits`, what the range check
// says the drawing's decisions need. Integers that are too narrow are left out.

#include <benchmark/benchmark.h>

#include <functional>
#include <string>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/verify/predicates/choices.h"
#include "inputs.h"
#include "precision/precision.h"
#include "turns.h"

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

using Decide = void (*)(const PredicateChoice&, const Decisions&);

void time_in_turns(benchmark::State& state, const Decisions& decisions, std::size_t count, int bits,
                   Decide decide) {
  if (bits > verify::kInt128Bits || count == 0) {
    return state.SkipWithError("int128 does not hold this drawing's decisions, or there are none");
  }
  std::vector<const PredicateChoice*> choices;
  for (const PredicateChoice& choice : verify::predicate_choices()) {
    if (may_be_timed(choice, bits)) choices.push_back(&choice);
  }
  std::size_t int128 = 0;
  std::vector<std::function<double()>> works;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (choices[i]->name == "int128") int128 = i;
    works.push_back(timed(Clock::cpu, [&, i] { decide(*choices[i], decisions); }));
  }
  Turns turns(std::move(works));
  for (auto _ : state) {
    turns.add_round();
    state.SetIterationTime(turns.last_of(int128));
  }
  const double own = turns.median_of(int128);
  state.counters["ns"] = own / static_cast<double>(count) * 1e9;
  state.counters["bits"] = bits;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    state.counters[choices[i]->name] = turns.median_of(i) / own;
  }
}

Decisions decisions_for(const Algorithm& algorithm, std::int64_t n) {
  const Graph& graph = graph_of(random_family(algorithm), static_cast<std::uint64_t>(n));
  return precision::decisions_of(draw(algorithm, graph), algorithm.guarantee, kMostDecisions);
}

const bool kRegistered = [] {
  for (const Algorithm* row : proved_algorithms()) {
    const Algorithm& algorithm = *row;
    const auto add = [&](const std::string& what, auto kernel) {
      benchmark::RegisterBenchmark((what + algorithm.name).c_str(), kernel)
          ->Arg(1000)
          ->Arg(10000)
          ->Iterations(15)
          ->UseManualTime()
          ->Unit(benchmark::kMicrosecond);
    };
    add("predicates/angle/", [&algorithm](benchmark::State& state) {
      const Decisions decisions = decisions_for(algorithm, state.range(0));
      time_in_turns(state, decisions, decisions.angles.size(), decisions.bits.angle, decide_angles);
    });
    add("predicates/meeting/", [&algorithm](benchmark::State& state) {
      const Decisions decisions = decisions_for(algorithm, state.range(0));
      time_in_turns(state, decisions, decisions.pairs.size(), decisions.bits.meeting,
                    decide_meetings);
    });
  }
  return true;
}();

}  // namespace
}  // namespace ar3d::kernels
