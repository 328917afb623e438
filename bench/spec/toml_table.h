#pragma once

// Reads TOML tables strictly: what is no key is named before what is missing, every error names
// file, line and value.

#include <toml++/toml.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace ar3d {

/// @throws InputError "file:line: message" on a syntax error.
toml::table parse_toml(const std::string& text, const std::string& file);

/// Is what a text that options are short for is parsed as: it has lines that the user never saw, so that
/// messages name none.
inline constexpr const char* kOptionsFile = "--graphs";

/// Returns "file:line: " of a node; "--graphs: " of one of options.
std::string toml_location(const toml::node& node);

/// @throws InputError "file:line: message" with the line of the node.
[[noreturn]] void refuse_toml(const toml::node& node, const std::string& message);

/// Runs `step`; an InputError of it gets file and line of the node in front.
void with_location(const toml::node& node, const std::function<void()>& step);

/// Reads the value of a key. @param key  names it for people.
using TomlReader = std::function<void(const toml::node& value, const std::string& key)>;

/// Describes a key that a table may have.
struct TomlKey {
  std::string name;
  TomlReader read;
  bool required = false;
};

/// Reads the keys of a table in this order. @param what  names the table for people.
/// @param other  reads all other keys, at last; empty: there may be none.
/// @throws InputError if the node is no table; naming the first key that is none of these, and the
/// nearest of them; naming a required key that is missing, and one that looks like it.
void read_toml_table(const toml::node& node, const std::string& what,
                     const std::vector<TomlKey>& keys, const TomlReader& other = {});

/// Returns true if the node is a table with that key.
bool has_toml_key(const toml::node& node, const std::string& key);

/// Calls use(table) for every table of a key: one table, or those of an array.
void for_each_table(toml::table& study, const std::string& key,
                    const std::function<void(toml::table&)>& use);
/// Returns a specification as text.
std::string toml_text_of(const toml::node& study);

/// Returns the nodes of an array, or the node itself if it is none.
std::vector<const toml::node*> one_or_many(const toml::node& node);
/// Returns the same. @throws InputError if there are none.
std::vector<const toml::node*> toml_list(const toml::node& node, const std::string& what);

std::string toml_text(const toml::node& node, const std::string& what);
/// @throws InputError if it is no integer in [low, high].
std::int64_t toml_integer(const toml::node& node, const std::string& what, std::int64_t low,
                          std::int64_t high);
/// @throws InputError if it is no integer or floating-point number in [low, high].
double toml_number(const toml::node& node, const std::string& what, double low, double high);

// What reads a value into a variable, which outlives the reading.
TomlReader into(std::string& to);
TomlReader into(bool& to);
template <class Integer>
TomlReader into(Integer& to, std::int64_t low, std::int64_t high) {
  return [&to, low, high](const toml::node& node, const std::string& key) {
    to = static_cast<Integer>(toml_integer(node, key, low, high));
  };
}
/// @param to  a double, or one that may be missing.
template <class Number>
TomlReader number_into(Number& to, double low, double high) {
  return [&to, low, high](const toml::node& node, const std::string& key) {
    to = toml_number(node, key, low, high);
  };
}
/// Takes what `parse` makes of a text; an InputError of it gets file and line.
template <class Value, class Parse>
TomlReader parsed_into(Value& to, const Parse& parse) {
  return [&to, parse](const toml::node& node, const std::string& key) {
    const std::string text = toml_text(node, key);
    with_location(node, [&] { to = parse(text); });
  };
}

}  // namespace ar3d
