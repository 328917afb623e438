#include "ar3d/bench/spec/size_function.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>
#include <string_view>

#include "ar3d/base/error.h"

namespace ar3d {
namespace {

struct Unit {
  std::string_view name;
  double size;
};

constexpr Unit kTimes[] = {{"ns", 1e-9}, {"us", 1e-6}, {"ms", 1e-3},
                           {"s", 1},     {"min", 60},  {"h", 3600}};
constexpr Unit kMemories[] = {
    {"B", 1},        {"kB", 1e3},        {"MB", 1e6},          {"GB", 1e9},
    {"KiB", 1024.0}, {"MiB", 1048576.0}, {"GiB", 1073741824.0}};

}  // namespace

// Reads the text from left to right.
class SizeFunctionReader {
 public:
  SizeFunctionReader(const std::string& text, std::span<const Unit> units)
      : text_(text), units_(units), rest_(text_) {}

  SizeFunction read() {
    SizeFunction function;
    do {
      function.terms_.push_back(term());
    } while (take("+"));
    if (!rest_.empty()) refuse(fmt::format("'{}' is not understood", rest_));
    return function;
  }

 private:
  SizeFunction::Term term() {
    SizeFunction::Term term;
    term.coefficient = number() * unit();
    if (!take("*")) return term;
    if (word() != "n") refuse("only n may follow '*'");
    term.exponent = take("^") ? number() : 1;
    return term;
  }

  double number() {
    skip_spaces();
    double value = 0;
    const auto parsed = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (parsed.ec != std::errc() || !std::isfinite(value) || value < 0) {
      refuse(fmt::format("a number is expected at '{}'", rest_));
    }
    rest_.remove_prefix(static_cast<std::size_t>(parsed.ptr - rest_.data()));
    return value;
  }

  double unit() {
    const std::string name = word();
    std::string known;
    for (const Unit& unit : units_) {
      if (unit.name == name) return unit.size;
      known += fmt::format("{}{}", known.empty() ? "" : ", ", unit.name);
    }
    refuse(fmt::format("'{}' is not a unit ({})", name, known));
  }

  std::string word() {
    skip_spaces();
    std::size_t length = 0;
    while (length < rest_.size() && std::isalpha(static_cast<unsigned char>(rest_[length])) != 0) {
      ++length;
    }
    std::string word(rest_.substr(0, length));
    rest_.remove_prefix(length);
    return word;
  }

  bool take(std::string_view sign) {
    skip_spaces();
    if (!rest_.starts_with(sign)) return false;
    rest_.remove_prefix(sign.size());
    skip_spaces();
    return true;
  }

  void skip_spaces() { rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size())); }

  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError(fmt::format("'{}': {}", text_, why));
  }

  const std::string text_;
  const std::span<const Unit> units_;
  std::string_view rest_;
};

SizeFunction SizeFunction::time(const std::string& text) {
  return SizeFunctionReader(text, kTimes).read();
}

SizeFunction SizeFunction::memory(const std::string& text) {
  return SizeFunctionReader(text, kMemories).read();
}

double SizeFunction::operator()(std::uint64_t n) const {
  double sum = 0;
  for (const Term& term : terms_) {
    sum += term.coefficient * std::pow(static_cast<double>(n), term.exponent);
  }
  return sum;
}

bool SizeFunction::is_constant() const {
  return std::all_of(terms_.begin(), terms_.end(), [](const Term& t) { return t.exponent == 0; });
}

}  // namespace ar3d
