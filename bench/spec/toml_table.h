#pragma once

// Reads a TOML table strictly: what is no key of it is named before what is missing, every error
// names file, line and value.

#include <toml++/toml.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ar3d {

/// @throws InputError "file:line: message" on a syntax error.
toml::table parse_toml(const std::string& text, const std::string& file);

/// @throws InputError "file:line: message" with the line of the node.
[[noreturn]] void refuse_toml(const std::string& file, const toml::node& node,
                              const std::string& message);

/// Runs `step`; an InputError of it gets file and line of the node in front.
void with_place(const std::string& file, const toml::node& node, const std::function<void()>& step);

class TomlTable {
 public:
  /// @throws InputError if the node is not a table; `what` names it for people.
  TomlTable(const std::string& file, const toml::node& node, const std::string& what);

  /// @throws InputError naming the first key that is none of these, and the nearest of them. To be
  /// called before any key is asked for.
  void refuse_all_but(std::vector<std::string_view> keys) const;

  bool has(const std::string& key) const { return table_->contains(key); }
  /// Returns the node of a key, or null; the key counts as known from now on.
  const toml::node* find(const std::string& key);
  /// @throws InputError if the key is missing, naming one that looks like it.
  const toml::node& get(const std::string& key);

  std::string text(const std::string& key);
  std::string text(const std::string& key, const std::string& otherwise);
  std::int64_t integer(const std::string& key, std::int64_t low, std::int64_t high);
  std::int64_t integer(const std::string& key, std::int64_t low, std::int64_t high,
                       std::int64_t otherwise);
  double number(const std::string& key, double low, double high);
  bool boolean(const std::string& key, bool otherwise);

  /// Returns the keys that nobody has asked for yet, in order of name.
  std::vector<std::string> other_keys() const;

  const toml::node& node() const { return *table_; }

 private:
  [[noreturn]] void refuse_missing(const std::string& key) const;

  std::string file_;
  const toml::table* table_ = nullptr;
  std::string what_;
  std::set<std::string> known_;
};

/// Returns the nodes of an array, or the node itself if it is none.
std::vector<const toml::node*> one_or_many(const toml::node& node);

std::string toml_text(const std::string& file, const toml::node& node, const std::string& what);
/// Returns what `parse` makes of the node's text. @throws InputError "file:line: message" if the
/// node is no text or `parse` throws one.
template <class Parse>
auto toml_parsed(const std::string& file, const toml::node& node, const std::string& what,
                 const Parse& parse) {
  const std::string text = toml_text(file, node, what);
  std::optional<decltype(parse(text))> value;
  with_place(file, node, [&] { value = parse(text); });
  return *value;
}

/// @throws InputError if it is no integer in [low, high].
std::int64_t toml_integer(const std::string& file, const toml::node& node, const std::string& what,
                          std::int64_t low, std::int64_t high);
/// @throws InputError if it is no integer or floating-point number in [low, high].
double toml_number(const std::string& file, const toml::node& node, const std::string& what,
                   double low, double high);

}  // namespace ar3d
