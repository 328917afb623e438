// Time against accuracy of the predicates: which arithmetic is beaten by none in both?
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "../inputs.h"
#include "ar3d/algorithms/catalog.h"
#include "ar3d/bench/measure/stopwatch.h"
#include "ar3d/generators/catalog.h"
#include "decisions.h"
#include "questions.h"
#include "tables.h"

namespace ar3d::precision {
namespace {

constexpr std::size_t kMost = 5000;  // questions of each kind
constexpr int kRounds = 7;

/// One arithmetic on one drawing's questions.
struct Contender {
  const verify::PredicateChoice* choice = nullptr;
  double least_s = std::numeric_limits<double>::infinity();
  std::uint64_t wrong = 0;
};

/// Integers are asked only where the range check proves them.
std::vector<Contender> contenders(int bits) {
  std::vector<Contender> all;
  for (const verify::PredicateChoice& choice : verify::predicate_choices()) {
    const bool is_integer = choice.name == "int64" || choice.name == "int128";
    if (!is_integer || choice.exact_bits >= bits) all.push_back({&choice});
  }
  return all;
}

bool is_beaten(const Contender& one, const std::vector<Contender>& all) {
  return std::any_of(all.begin(), all.end(), [&](const Contender& other) {
    return other.least_s < one.least_s && other.wrong <= one.wrong;
  });
}

void add_rows(const Algorithm& algorithm, const std::string& question, std::uint64_t n,
              std::size_t questions, const std::vector<Contender>& all,
              std::vector<std::vector<std::string>>& rows) {
  for (const Contender& one : all) {
    rows.push_back({fmt::format("`{}`", algorithm.name), fmt::format("{}", n), question,
                    one.choice->name,
                    fmt::format("{:.3g}", 1e9 * one.least_s / static_cast<double>(questions)),
                    rate(one.wrong, questions), is_beaten(one, all) ? "" : "front"});
  }
}

/// Times of all in turns, the least of several rounds. @param ask  all questions, of one choice.
template <class Ask>
void measure_times(std::vector<Contender>& all, Ask&& ask) {
  for (int round = 0; round < kRounds; ++round) {
    for (Contender& one : all) {
      const CpuStopwatch time;
      ask(*one.choice);
      one.least_s = std::min(one.least_s, time.cpu_s());
    }
  }
}

void add_angles(const Algorithm& algorithm, std::uint64_t n, const Decisions& decisions,
                std::vector<std::vector<std::string>>& rows) {
  const Guarantee& guarantee = algorithm.guarantee;
  std::vector<Angle> angles = decisions.angles;
  const std::vector<Angle> near = one_off(angles);
  angles.insert(angles.end(), near.begin(), near.end());
  std::vector<Contender> all = contenders(decisions.bits.angle);
  measure_times(all, [&](const verify::PredicateChoice& choice) {
    for (const auto& [from, at, to] : angles) {
      choice.angle(guarantee.lattice, from, at, to, guarantee.cosine);
    }
  });
  for (Contender& one : all) one.wrong = wrong_angles(*one.choice, guarantee, angles);
  add_rows(algorithm, "angle", n, angles.size(), all, rows);
}

void add_meetings(const Algorithm& algorithm, std::uint64_t n, const Decisions& decisions,
                  std::vector<std::vector<std::string>>& rows) {
  const std::vector<SegmentPair> pairs = touching(decisions.pairs);
  std::vector<Contender> all = contenders(decisions.bits.meeting);
  measure_times(all, [&](const verify::PredicateChoice& choice) {
    for (const auto& [a, b, c, d] : pairs) choice.meeting(a, b, c, d);
  });
  for (Contender& one : all) one.wrong = wrong_meetings(*one.choice, pairs);
  add_rows(algorithm, "meeting", n, pairs.size(), all, rows);
}

}  // namespace

void front_table() {
  std::vector<std::vector<std::string>> rows;
  for (const auto& [name, n] : {std::pair("diamond", 10000u), std::pair("grid", 10000u),
                                std::pair("compact", 10000u), std::pair("two-bend", 100000u)}) {
    const Algorithm& algorithm = find_algorithm(name);
    const Decisions decisions =
        decisions_of(draw(algorithm, generate(kernels::random_family(algorithm), n, 1)),
                     algorithm.guarantee, kMost);
    add_angles(algorithm, n, decisions, rows);
    add_meetings(algorithm, n, decisions, rows);
  }
  fmt::print(
      "CPU time and wrong answers of a decision, angles as drawn and one unit off, segments that "
      "touch or are one unit off; front: none is faster and at most as often wrong:\n\n");
  print_table({"algorithm", "n", "question", "arithmetic", "ns", "wrong", ""}, rows);
}

}  // namespace ar3d::precision
