#pragma once

#include <span>
#include <string_view>

namespace ar3d {

/// A study that comes with the program, by name.
struct NamedStudy {
  std::string_view name;
  std::string_view description;  ///< one sentence
  std::string_view toml;
};

std::span<const NamedStudy> named_studies();

/// Null if there is none of that name.
const NamedStudy* find_named_study(std::string_view name);

}  // namespace ar3d
