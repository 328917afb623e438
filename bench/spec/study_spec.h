#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/bench/spec/measures.h"
#include "ar3d/generators/catalog.h"

namespace ar3d {

/// A family with complete parameters.
struct FamilyChoice {
  const Family* family = nullptr;
  Settings parameters;
};

/// An algorithm with complete options.
struct AlgorithmChoice {
  const Algorithm* algorithm = nullptr;
  Settings options;
};

/// What an include or exclude entry says: an empty name matches all.
struct CellPattern {
  std::string family;
  std::string algorithm;
  std::uint64_t from = 0;
  std::uint64_t to = ~std::uint64_t{0};
  bool matches(const std::string& family_name, const std::string& algorithm_name,
               std::uint64_t n) const;
};

/// families x sizes x instances x algorithms x repetitions, less what include and exclude drop.
struct Sweep {
  std::vector<FamilyChoice> families;
  std::vector<std::uint64_t> sizes;  ///< increasing
  std::vector<AlgorithmChoice> algorithms;
  std::uint32_t instances = 1;       ///< where the graph depends on the seed; others have one
  std::uint32_t repetitions = 1;     ///< of every drawing in the metrics phase
  TimedRepetitions timed;            ///< of every drawing in the timing phase; none by default
  Batches strong;                    ///< of every drawing, shared by threads; none by default
  Batches weak;                      ///< of every drawing, shared by threads; none by default
  Batches strong_ranks;              ///< of every drawing, shared by ranks; none by default
  Batches weak_ranks;                ///< of every drawing, shared by ranks; none by default
  std::vector<CellPattern> include;  ///< if not empty, a cell has to match one of these
  std::vector<CellPattern> exclude;
};

struct StudySpec {
  std::string name;
  std::string description;
  std::uint64_t seed = 0;
  std::vector<Sweep> sweeps;
  std::map<std::string, std::uint64_t> max_n;  ///< algorithm -> largest n it is given
  TimingRules timing;
  Budget budget;
  std::string text;  ///< the verbatim TOML
};

/// Reads a specification; docs/study.md describes the keys.
/// @param file  for messages.
/// @throws InputError "file:line: message" naming the value: syntax, unknown key, family,
/// algorithm, option or
///   parameter, value out of range, empty list.
StudySpec parse_study(const std::string& text, const std::string& file);

/// A named study, or else the TOML file at that path.
/// @throws InputError naming the file, or the known studies if there is no such file.
StudySpec load_study(const std::string& name_or_path);

/// "ar3d-<name>.h5".
std::string default_results_path(const StudySpec& spec);

}  // namespace ar3d
