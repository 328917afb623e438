#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"

namespace ar3d {

/// One integer parameter of a family besides n and seed (probabilities are in parts per million).
struct ParameterSpec {
  std::string name;
  std::int64_t low = 0;
  std::int64_t high = 0;
  std::int64_t default_value = 0;
  std::string description;
};

struct ParameterValue {
  std::string name;
  std::int64_t value = 0;
  friend bool operator==(const ParameterValue&, const ParameterValue&) = default;
};
using ParameterValues = std::vector<ParameterValue>;

/// One row of the catalogue: a pure function (n, seed, parameters) -> Graph.
struct Family {
  std::string name;
  std::string summary;       ///< one sentence, with the source
  std::uint32_t max_degree;  ///< of every graph of the family (with default parameters)
  bool is_random = false;    ///< false: the seed has no influence
  std::vector<ParameterSpec> parameters;
  /// The family's own number of vertices for a wanted n: the nearest valid one not above n, else
  /// the smallest.
  std::uint64_t (*nearest_n)(std::uint64_t wanted_n, const ParameterValues&) = nullptr;
  /// Called with nearest_n(n) == n and complete parameters.
  Graph (*generate)(std::uint64_t n, std::uint64_t seed, const ParameterValues&) = nullptr;
  /// For pieces of lattices: the same graph in its own drawing without bends (the optimum); else
  /// null. Called as generate is.
  Drawing (*own_drawing)(std::uint64_t n, std::uint64_t seed, const ParameterValues&) = nullptr;
};

const std::vector<Family>& families();

/// @throws InputError naming the unknown family.
const Family& find_family(std::string_view name);

/// Every family also takes the parameter `shuffle`: 1 permutes the labels of its graph at random by
/// the seed (default 0). It stands among complete parameters, as the last, only where it is 1.
bool is_shuffled(const ParameterValues& parameters);

/// Whether two seeds may give different graphs.
bool depends_on_seed(const Family& family, const ParameterValues& parameters);

/// @throws InputError on an unknown name, a name given twice or a value out of range.
ParameterValues complete_parameters(const Family& family, const ParameterValues& given);

/// The graph of the family with nearest_n(n) vertices. The same (family, n, seed, parameters) gives
/// the same bytes on every thread count, compiler and platform.
/// @throws InputError on bad parameters.
Graph generate(const Family& family, std::uint64_t n, std::uint64_t seed,
               const ParameterValues& given = {});

}  // namespace ar3d
