// Tables of TOML whose errors name file and line. Their keys are a list, so that others can be
// refused.
#include "ar3d/bench/spec/toml_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "ar3d/base/error.h"
#include "ar3d/base/nearest_name.h"
#include "ar3d/base/printable.h"

namespace ar3d {
namespace {

constexpr const char* kHelp = "docs/study.md describes the keys";

template <class Number>
void require_range(const toml::node& node, const std::string& what, Number number, Number low,
                   Number high) {
  if (number >= low && number <= high) return;
  refuse_toml(node, fmt::format("{} = {} is outside {}..{}", what, number, low, high));
}

}  // namespace

toml::table parse_toml(const std::string& text, const std::string& file) {
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    throw InputError(
        fmt::format("{}:{}: {}", file, error.source().begin.line, error.description()));
  }
}

std::string toml_location(const toml::node& node) {
  const toml::source_region& source = node.source();
  const std::string file = source.path ? *source.path : "";
  if (file == kOptionsFile) return file + ": ";
  return fmt::format("{}:{}: ", file, source.begin.line);
}

void refuse_toml(const toml::node& node, const std::string& message) {
  throw InputError(toml_location(node) + message);
}

void with_location(const toml::node& node, const std::function<void()>& step) {
  try {
    step();
  } catch (const InputError& error) {
    refuse_toml(node, error.what());
  }
}

void read_toml_table(const toml::node& node, const std::string& what,
                     const std::vector<TomlKey>& keys, const TomlReader& other) {
  const toml::table* const table = node.as_table();
  if (table == nullptr) refuse_toml(node, fmt::format("{} is not a table", what));
  std::vector<std::string_view> known = names_of(keys), others;
  std::ranges::sort(known);
  for (const auto& entry : *table) {
    const std::string_view name = entry.first.str();
    if (std::ranges::binary_search(known, name)) continue;
    others.push_back(name);
    if (other) continue;
    refuse_toml(entry.second,
                fmt::format("unknown key '{}' in {}{} (known: {}; {})", printable(name), what,
                            did_you_mean(name, known), fmt::join(known, ", "), kHelp));
  }
  for (const TomlKey& key : keys) {
    if (const toml::node* const value = table->get(key.name)) {
      key.read(*value, key.name);
    } else if (key.required) {  // a key that is missing is often there, but misspelt
      const auto misspelt = nearest_name(key.name, others);
      if (!misspelt) refuse_toml(node, fmt::format("{} lacks '{}' ({})", what, key.name, kHelp));
      refuse_toml(*table->get(*misspelt),
                  fmt::format("unknown key '{}' in {}; did you mean '{}'? ({})", *misspelt, what,
                              key.name, kHelp));
    }
  }
  for (const std::string_view name : others) other(*table->get(name), std::string(name));
}

bool has_toml_key(const toml::node& node, const std::string& key) {
  return node.is_table() && node.as_table()->contains(key);
}

void for_each_table(toml::table& study, const std::string& key,
                    const std::function<void(toml::table&)>& use) {
  toml::node* const node = study.get(key);
  if (node == nullptr) return;
  if (toml::table* const table = node->as_table()) use(*table);
  if (toml::array* const list = node->as_array()) {
    for (toml::node& entry : *list) {
      if (toml::table* const table = entry.as_table()) use(*table);
    }
  }
}

std::string toml_text_of(const toml::node& study) {
  std::ostringstream text;
  study.visit([&](const auto& node) { text << node; });
  return text.str() + "\n";
}

std::vector<const toml::node*> one_or_many(const toml::node& node) {
  std::vector<const toml::node*> nodes;
  if (const toml::array* array = node.as_array()) {
    for (const toml::node& entry : *array) nodes.push_back(&entry);
  } else {
    nodes.push_back(&node);
  }
  return nodes;
}

std::vector<const toml::node*> toml_list(const toml::node& node, const std::string& what) {
  std::vector<const toml::node*> nodes = one_or_many(node);
  if (nodes.empty()) refuse_toml(node, fmt::format("{} is empty", what));
  return nodes;
}

std::string toml_text(const toml::node& node, const std::string& what) {
  if (const auto* text = node.as_string()) return text->get();
  refuse_toml(node, fmt::format("{} is not a string", what));
}

std::int64_t toml_integer(const toml::node& node, const std::string& what, std::int64_t low,
                          std::int64_t high) {
  const auto* number = node.as_integer();
  if (number == nullptr) refuse_toml(node, fmt::format("{} is not an integer", what));
  require_range(node, what, number->get(), low, high);
  return number->get();
}

double toml_number(const toml::node& node, const std::string& what, double low, double high) {
  // Integers too, and those that no double is equal to.
  const auto* const integer = node.as_integer();
  const auto number =
      integer != nullptr ? static_cast<double>(integer->get()) : node.value<double>();
  if (!number || !node.is_number()) refuse_toml(node, fmt::format("{} is not a number", what));
  require_range(node, what, *number, low, high);
  return *number;
}

TomlReader into(std::string& to) {
  return [&to](const toml::node& node, const std::string& key) { to = toml_text(node, key); };
}

TomlReader into(bool& to) {
  return [&to](const toml::node& node, const std::string& key) {
    if (!node.is_boolean()) refuse_toml(node, fmt::format("{} is neither true nor false", key));
    to = node.as_boolean()->get();
  };
}

}  // namespace ar3d
