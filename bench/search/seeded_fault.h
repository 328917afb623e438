#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"
#include "ar3d/model/guarantee.h"

namespace ar3d {

/// A fault put into finished drawings on purpose, to show that hunter, shrinker and verdict catch
/// it. It shows on some graphs only, so that finding and shrinking it takes work. No algorithm
/// knows of it.
struct SeededFault {
  std::string name;
  std::string summary;
  /// The drawing with the fault; unchanged where the graph does not provoke it.
  Drawing (*plant)(const Graph&, const Drawing&, const Guarantee&) = nullptr;
};

/// All of them.
const std::vector<SeededFault>& seeded_faults();

/// @throws InputError naming the unknown fault and the known ones.
const SeededFault& find_seeded_fault(std::string_view name);

}  // namespace ar3d
