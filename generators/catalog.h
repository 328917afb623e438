#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"
#include "ar3d/model/settings.h"

namespace ar3d {

/// One row of the catalogue: a pure function (n, seed, parameters) -> Graph.
struct Family {
  std::string name;
  std::string summary;                  ///< one sentence, with the source
  std::uint32_t max_degree;             ///< of every graph of the family (with default parameters)
  bool is_random = false;               ///< false: the seed has no influence
  std::vector<SettingSpec> parameters;  ///< besides n and seed; probabilities in parts per million
  /// The family's own number of vertices for a requested n: the nearest valid one not above n, else
  /// the smallest.
  std::uint64_t (*nearest_n)(std::uint64_t requested_n, const Settings&) = nullptr;
  /// Called with nearest_n(n) == n and complete parameters.
  Graph (*generate)(std::uint64_t n, std::uint64_t seed, const Settings&) = nullptr;
  /// For pieces of lattices: the same graph in its own drawing without bends (the optimum); else
  /// null. Called as generate is.
  Drawing (*own_drawing)(std::uint64_t n, std::uint64_t seed, const Settings&) = nullptr;
};

const std::vector<Family>& families();

/// @throws InputError naming the unknown family.
const Family& find_family(std::string_view name);

/// Every family also takes the parameter `shuffle`: 1 permutes the labels of its graph at random by
/// the seed (default 0). It stands among complete parameters, as the last, only where it is 1.
bool is_shuffled(const Settings& parameters);

/// Returns whether two seeds may give different graphs.
bool depends_on_seed(const Family& family, const Settings& parameters);

/// @throws InputError on an unknown name, a name given twice or a value out of range.
Settings complete_parameters(const Family& family, const Settings& given);

/// The graph of the family with nearest_n(n) vertices. The same (family, n, seed, parameters) gives
/// the same bytes on every thread count, compiler and platform.
/// @throws InputError on bad parameters.
Graph generate(const Family& family, std::uint64_t n, std::uint64_t seed,
               const Settings& given = {});

/// Adds a row to the catalogue, for programs that bring families of their own: before anything else
/// uses it, by one thread. References to other rows stay valid.
/// @throws InputError if the name is taken or empty, or a function is missing; if there are more
/// than 1000 rows.
void register_family(Family row);

}  // namespace ar3d
