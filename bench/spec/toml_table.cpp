// Tables of TOML whose errors name file and line. A table knows which keys were asked for, so that
// the others can be refused.
#include "ar3d/bench/spec/toml_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "ar3d/base/error.h"
#include "ar3d/base/nearest_name.h"
#include "ar3d/base/printable.h"

namespace ar3d {
namespace {

constexpr const char* kHelp = "docs/study.md describes the keys";
}  // namespace

toml::table parse_toml(const std::string& text, const std::string& file) {
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    throw InputError(
        fmt::format("{}:{}: {}", file, error.source().begin.line, error.description()));
  }
}

void refuse_toml(const std::string& file, const toml::node& node, const std::string& message) {
  throw InputError(fmt::format("{}:{}: {}", file, node.source().begin.line, message));
}

void with_place(const std::string& file, const toml::node& node,
                const std::function<void()>& step) {
  try {
    step();
  } catch (const InputError& error) {
    refuse_toml(file, node, error.what());
  }
}

TomlTable::TomlTable(const std::string& file, const toml::node& node, const std::string& what)
    : file_(file), table_(node.as_table()), what_(what) {
  if (table_ == nullptr) refuse_toml(file, node, fmt::format("{} is not a table", what));
}

const toml::node* TomlTable::find(const std::string& key) {
  known_.insert(key);
  return table_->get(key);
}

const toml::node& TomlTable::get(const std::string& key) {
  const toml::node* node = find(key);
  if (node == nullptr) refuse_missing(key);
  return *node;
}

// A key that is missing is often there, but misspelt.
void TomlTable::refuse_missing(const std::string& key) const {
  const std::vector<std::string> others = other_keys();
  const auto misspelt =
      nearest_name(key, std::vector<std::string_view>(others.begin(), others.end()));
  if (!misspelt) refuse_toml(file_, *table_, fmt::format("{} lacks '{}' ({})", what_, key, kHelp));
  refuse_toml(
      file_, *table_->get(*misspelt),
      fmt::format("unknown key '{}' in {}; did you mean '{}'? ({})", *misspelt, what_, key, kHelp));
}

std::string TomlTable::text(const std::string& key) { return toml_text(file_, get(key), key); }

std::string TomlTable::text(const std::string& key, const std::string& otherwise) {
  const toml::node* node = find(key);
  return node == nullptr ? otherwise : toml_text(file_, *node, key);
}

std::int64_t TomlTable::integer(const std::string& key, std::int64_t low, std::int64_t high) {
  return toml_integer(file_, get(key), key, low, high);
}

std::int64_t TomlTable::integer(const std::string& key, std::int64_t low, std::int64_t high,
                                std::int64_t otherwise) {
  const toml::node* node = find(key);
  return node == nullptr ? otherwise : toml_integer(file_, *node, key, low, high);
}

double TomlTable::number(const std::string& key, double low, double high) {
  return toml_number(file_, get(key), key, low, high);
}

bool TomlTable::boolean(const std::string& key, bool otherwise) {
  const toml::node* node = find(key);
  if (node == nullptr) return otherwise;
  if (const auto* value = node->as_boolean()) return value->get();
  refuse_toml(file_, *node, fmt::format("{} is neither true nor false", key));
}

std::vector<std::string> TomlTable::other_keys() const {
  std::vector<std::string> keys;
  for (const auto& entry : *table_) {
    std::string key(entry.first.str());
    if (!known_.contains(key)) keys.push_back(std::move(key));
  }
  return keys;
}

void TomlTable::refuse_all_but(std::vector<std::string_view> keys) const {
  std::ranges::sort(keys);
  for (const std::string& key : other_keys()) {
    if (std::ranges::binary_search(keys, key)) continue;
    refuse_toml(file_, *table_->get(key),
                fmt::format("unknown key '{}' in {}{} (known: {}; {})", printable(key), what_,
                            did_you_mean(key, keys), fmt::join(keys, ", "), kHelp));
  }
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

std::string toml_text(const std::string& file, const toml::node& node, const std::string& what) {
  if (const auto* text = node.as_string()) return text->get();
  refuse_toml(file, node, fmt::format("{} is not a string", what));
}

std::int64_t toml_integer(const std::string& file, const toml::node& node, const std::string& what,
                          std::int64_t low, std::int64_t high) {
  const auto* number = node.as_integer();
  if (number == nullptr) refuse_toml(file, node, fmt::format("{} is not an integer", what));
  if (number->get() < low || number->get() > high) {
    refuse_toml(file, node,
                fmt::format("{} = {} is outside {}..{}", what, number->get(), low, high));
  }
  return number->get();
}

double toml_number(const std::string& file, const toml::node& node, const std::string& what,
                   double low, double high) {
  const std::optional<double> number = node.value<double>();  // integers too
  if (!number || !node.is_number())
    refuse_toml(file, node, fmt::format("{} is not a number", what));
  if (!(*number >= low && *number <= high)) {
    refuse_toml(file, node, fmt::format("{} = {} is outside {}..{}", what, *number, low, high));
  }
  return *number;
}

}  // namespace ar3d
