#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ar3d {

/// One integer that a family of graphs or an algorithm can be asked for by name, as a study, the
/// command line and the docs see it.
struct SettingSpec {
  std::string name;
  std::int64_t low = 0;  ///< low <= value <= high
  std::int64_t high = 0;
  std::int64_t default_value = 0;
  std::string description;
};

/// A value for one of them.
struct Setting {
  std::string name;
  std::int64_t value = 0;
  friend bool operator==(const Setting&, const Setting&) = default;
};
/// Options of an algorithm or parameters of a family; what is not named keeps its default.
using Settings = std::vector<Setting>;

/// Reads words "name=integer". @throws InputError naming the word.
Settings parse_settings(std::span<const std::string> words);
/// Reads "a=1;b=2"; empty: none. @throws InputError naming the word.
Settings parse_settings(std::string_view text);
/// Writes "a=1;b=2".
std::string settings_text(const Settings& settings);

/// The values of all specs in their order, defaults filled in.
/// @param owner,kind  whose settings they are, for messages: "algorithm grid" and "option", "family
/// cycle" and "parameter".
/// @throws InputError on an unknown name, a name given twice or a value out of range.
Settings complete_settings(std::string_view owner, std::string_view kind,
                           std::span<const SettingSpec> specs, const Settings& given);

/// The value of a setting among complete ones. @throws InternalError if it is missing.
std::int64_t value_of(const Settings& settings, std::string_view name);

}  // namespace ar3d
