// Step 1.9. Parity classes with few equal neighbours in the two orders, which is a maximum cut of
// a graph of degree at most 4. Simulated annealing (Kirkpatrick, Gelatt and Vecchi 1983) with a
// linear schedule; probabilities are integers out of 65536, so every platform draws the same. Each
// round costs O(n), and memory is read in the green order. Idea: not in the paper, which has even
// coordinates only.
#include <array>

#include "ar3d/algorithms/diamond/parity.h"
#include "ar3d/base/random.h"

namespace ar3d::diamond {
namespace {

constexpr unsigned kPasses = 40;
constexpr std::uint64_t kSeed =
    0x6469616d6f6e64;  // any fixed number: the same drawing for the same graph

/// The neighbours of each vertex in the red order; vertices named by their indices in the green
/// order, where the neighbours of i are i - 1 and i + 1.
using RedNeighbours = std::vector<std::array<std::uint32_t, 2>>;

RedNeighbours red_neighbours(const Items& green, const Items& red) {
  const std::size_t n = green.vertex.size();
  std::vector<std::uint32_t> index(n);
  for (std::uint32_t i = 0; i < n; ++i) index[green.vertex[i]] = i;
  RedNeighbours result(n, {kNone, kNone});
  for (std::size_t i = 1; i < n; ++i) {
    const std::uint32_t a = index[red.vertex[i - 1]];
    const std::uint32_t b = index[red.vertex[i]];
    result[a][1] = b;
    result[b][0] = a;
  }
  return result;
}

/// Annealing with probabilities in 1/65536, so that no floating point is involved.
class Annealing {
 public:
  explicit Annealing(const RedNeighbours& red)
      : red_(red), parity_(red.size()), random_(kSeed, red.size()) {
    for (std::size_t i = 0; i < parity_.size(); ++i) parity_[i] = i & 1;
  }

  /// Flips each vertex if that does not make more pairs equal, else with probability (chance /
  /// 65536)^increase.
  void pass(std::uint32_t chance) {
    for (std::size_t i = 0; i < parity_.size(); ++i) {
      const int increase = flip_increase(i);
      if (increase <= 0 || accept(chance, increase)) parity_[i] ^= 1;
    }
  }

  const std::vector<std::uint8_t>& parity() const { return parity_; }

 private:
  int flip_increase(std::size_t i) const {
    int increase = 0;
    const auto count = [&](std::size_t j) { increase += parity_[i] == parity_[j] ? -1 : 1; };
    if (i > 0) count(i - 1);
    if (i + 1 < parity_.size()) count(i + 1);
    for (const std::uint32_t j : red_[i]) {
      if (j != kNone) count(j);
    }
    return increase;
  }

  bool accept(std::uint64_t chance, int increase) {
    std::uint64_t power = chance;
    for (int k = 1; k < increase; ++k) power = power * chance >> 16;
    return (random_.next32() & 0xffff) < power;
  }

  const RedNeighbours& red_;
  std::vector<std::uint8_t> parity_;  // by index in the green order
  RandomStream random_;
};

}  // namespace

std::int64_t equal_neighbours(const Items& green, const Items& red,
                              const std::vector<std::uint8_t>& parity) {
  std::int64_t equal = 0;
  for (const auto* order : {&green.vertex, &red.vertex}) {
    for (std::size_t i = 1; i < order->size(); ++i) {
      equal += parity[(*order)[i - 1]] == parity[(*order)[i]];
    }
  }
  return equal;
}

std::vector<std::uint8_t> annealed_parity(const Items& green, const Items& red) {
  const RedNeighbours neighbours = red_neighbours(green, red);
  Annealing annealing(neighbours);
  const auto by_vertex = [&] {
    std::vector<std::uint8_t> parity(green.vertex.size());
    for (std::size_t i = 0; i < parity.size(); ++i) parity[green.vertex[i]] = annealing.parity()[i];
    return parity;
  };
  const std::vector<std::uint8_t> start = by_vertex();
  for (unsigned k = 0; k < kPasses; ++k) {
    const std::uint32_t left = kPasses - 1 - k;  // from 0.46 down to 0
    annealing.pass(30000 * left / (kPasses - 1));
  }
  std::vector<std::uint8_t> end = by_vertex();
  return equal_neighbours(green, red, end) < equal_neighbours(green, red, start) ? end : start;
}

}  // namespace ar3d::diamond
