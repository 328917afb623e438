// Reads and writes settings by name. What is not named gets its default, and an unknown name is
// refused with the nearest known one.
#include "ar3d/model/settings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "ar3d/base/error.h"
#include "ar3d/base/nearest_name.h"
#include "ar3d/base/number.h"

namespace ar3d {
namespace {

Setting parse_setting(std::string_view word) {
  const std::size_t equals = word.find('=');
  if (equals != std::string_view::npos && equals > 0) {
    const auto value = integer_of<std::int64_t>(word.substr(equals + 1));
    if (value) return {std::string(word.substr(0, equals)), *value};
  }
  throw InputError(fmt::format("'{}' is not of the form name=integer", word));
}

/// Returns what there is instead, and where it is explained.
std::string known_names(std::span<const SettingSpec> specs, std::string_view kind) {
  const char* const page = kind == "option" ? "algorithms" : "families";
  if (specs.empty()) return fmt::format("it has none; see: ar3d list {}", page);
  return fmt::format("known: {}; see: ar3d list {}", fmt::join(names_of(specs), ", "), page);
}

const Setting* find(const Settings& settings, std::string_view name) {
  const auto at = std::ranges::find(settings, name, &Setting::name);
  return at == settings.end() ? nullptr : &*at;
}

}  // namespace

Settings parse_settings(std::span<const std::string> words) {
  Settings settings;
  for (const std::string& word : words) settings.push_back(parse_setting(word));
  return settings;
}

Settings parse_settings(std::string_view text) {
  Settings settings;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(';'), text.size());
    settings.push_back(parse_setting(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return settings;
}

std::string settings_text(const Settings& settings) {
  std::string text;
  for (const auto& [name, value] : settings) {
    const fmt::format_int digits(value);
    if (!text.empty()) text += ';';
    text.append(name).append("=").append(digits.data(), digits.size());
  }
  return text;
}

Settings complete_settings(std::string_view owner, std::string_view kind,
                           std::span<const SettingSpec> specs, const Settings& given) {
  for (const Setting& setting : given) {
    if (std::ranges::find(specs, setting.name, &SettingSpec::name) == specs.end())
      throw InputError(fmt::format("{} has no {} '{}'{} ({})", owner, kind, setting.name,
                                   did_you_mean(setting.name, names_of(specs)),
                                   known_names(specs, kind)));
    if (std::ranges::count(given, setting.name, &Setting::name) > 1)
      throw InputError(fmt::format("{}: {} '{}' is given twice", owner, kind, setting.name));
  }
  Settings settings;
  for (const SettingSpec& spec : specs) {
    const Setting* found = find(given, spec.name);
    const std::int64_t value = found ? found->value : spec.default_value;
    if (value < spec.low || value > spec.high) {
      throw InputError(fmt::format("{}: {} {} = {} is outside {}..{}", owner, kind, spec.name,
                                   value, spec.low, spec.high));
    }
    settings.push_back({spec.name, value});
  }
  return settings;
}

std::int64_t value_of(const Settings& settings, std::string_view name) {
  const Setting* found = find(settings, name);
  if (found) return found->value;
  throw InternalError(fmt::format("setting '{}' was not completed", name));
}

}  // namespace ar3d
