#include "ar3d/store/columns/former_formula.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <regex>

#include "ar3d/base/error.h"

namespace ar3d {
namespace {

template <class Integer>
Integer number(const std::ssub_match& digits, Integer otherwise) {
  if (!digits.matched) return otherwise;
  const std::string text = digits.str();
  Integer value{};
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec != std::errc()) throw InputError(fmt::format("'{}' is too large", text));
  return value;
}

// "16/3 n", "n^(5/2) + 7", "sqrt(n)", "12".
AxisBound parse_axis(const std::string& text) {
  static const std::regex shape(
      R"((?:(\d+)(?:/(\d+))? ?)?(?:(sqrt\(n\))|(n)(?:\^(?:\((\d+)/2\)|(\d+)))?)?(?: ([+-]) (\d+))?)");
  std::smatch parts;
  if (text.empty() || !std::regex_match(text, parts, shape)) {
    throw InputError(fmt::format("'{}' is no bound", text));
  }
  AxisBound axis;
  axis.numerator = number<std::int64_t>(parts[1], 1);
  axis.denominator = number<std::int64_t>(parts[2], 1);
  axis.half_power = parts[3].matched ? 1 : 0;
  if (parts[4].matched) axis.half_power = number<unsigned>(parts[5], 2);
  if (parts[6].matched) axis.half_power = 2 * std::min(1000u, number<unsigned>(parts[6], 1));
  axis.constant = number<std::int64_t>(parts[8], 0);
  if (parts[7].matched && parts[7].str() == "-") axis.constant = -axis.constant;
  if (axis.denominator == 0 || axis.half_power > 18) {
    throw InputError(fmt::format("'{}' is no bound", text));
  }
  return axis;
}

// What is before `mark`; the text goes on behind it.
std::string taken(std::string& text, const std::string& mark) {
  const std::size_t at = text.find(mark);
  std::string before = text.substr(0, at);
  text = at == std::string::npos ? "" : text.substr(at + mark.size());
  return before;
}

}  // namespace

SizeBound parse_formula(const std::string& text) {
  SizeBound bound;
  std::string rest = text;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    bound.axes[axis] = parse_axis(taken(rest, axis < 2 ? ", " : " ("));
  }
  bound.name = taken(rest, ", ");
  bound.source = rest.ends_with(')') ? rest.substr(0, rest.size() - 1) : rest;
  return bound;
}

}  // namespace ar3d
