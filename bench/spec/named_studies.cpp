#include "ar3d/bench/spec/named_studies.h"

#include <algorithm>

#include "ar3d_named_studies.h"

namespace ar3d {

std::span<const NamedStudy> named_studies() { return kNamedStudies; }

const NamedStudy* find_named_study(std::string_view name) {
  const auto at = std::find_if(std::begin(kNamedStudies), std::end(kNamedStudies),
                               [&](const NamedStudy& study) { return study.name == name; });
  return at == std::end(kNamedStudies) ? nullptr : &*at;
}

}  // namespace ar3d
