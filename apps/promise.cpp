// A promise from the command line, in the words that proof/promise.ml reads.
#include "promise.h"

#include <fmt/format.h>

#include <string_view>

#include "ar3d/base/error.h"
#include "ar3d/base/number.h"
#include "options.h"

namespace ar3d {
namespace {

[[noreturn]] void refuse(const char* option, std::string_view word, const char* expected) {
  throw InputError(fmt::format("{} '{}': expected {}", option, word, expected));
}

/// The parts of a text between separators; one empty part of an empty text.
std::vector<std::string_view> parts_of(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == text.npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::optional<std::vector<std::int32_t>> small_integers(std::string_view text) {
  std::vector<std::int32_t> values;
  for (const std::string_view part : parts_of(text, ',')) {
    const auto value = integer_of<std::int32_t>(part);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

Cosine cosine_of(const std::string& word) {
  const auto parts = parts_of(word, '/');
  const auto numerator = integer_of<std::int32_t>(parts[0]);
  const auto denominator = parts.size() == 2 ? integer_of<std::int32_t>(parts[1]) : std::nullopt;
  const bool is_cosine = numerator && denominator && *denominator > 0 && *numerator <= 0 &&
                         *numerator >= -*denominator;
  if (!is_cosine) refuse("--cosine", word, "a fraction from -1/1 to 0/1, such as -1/3");
  return {*numerator, *denominator};
}

Lattice lattice_of(const std::string& word) {
  constexpr const char* kExpected = "XX,YY,ZZ[,XY,XZ,YZ][:DENOMINATOR]";
  const auto parts = parts_of(word, ':');
  const auto g = small_integers(parts[0]);
  const auto denominator = parts.size() == 2 ? integer_of<std::int32_t>(parts[1]) : 1;
  if (!g || (g->size() != 3 && g->size() != 6) || !denominator || parts.size() > 2) {
    refuse("--gram", word, kExpected);
  }
  Lattice lattice;
  for (std::size_t i = 0; i < 3; ++i) lattice.gram[i][i] = (*g)[i];
  if (g->size() == 6) {
    lattice.gram[0][1] = lattice.gram[1][0] = (*g)[3];
    lattice.gram[0][2] = lattice.gram[2][0] = (*g)[4];
    lattice.gram[1][2] = lattice.gram[2][1] = (*g)[5];
  }
  lattice.gram_denominator = *denominator;
  lattice.validate();
  return lattice;
}

std::vector<Vector> directions_of(const std::string& word) {
  std::vector<Vector> directions;
  if (word.empty()) return directions;
  for (const std::string_view part : parts_of(word, ':')) {
    const auto d = small_integers(part);
    if (!d || d->size() != 3 || *d == std::vector{0, 0, 0}) {
      refuse("--directions", word, "vectors other than 0, such as 1,1,1:1,-1,1");
    }
    directions.push_back({(*d)[0], (*d)[1], (*d)[2]});
  }
  return directions;
}

/// "16/3n", "12n^2", "726n^1/2+1800".
AxisBound axis_of(std::string_view word) {
  const auto fail = [&] { refuse("--box", word, "a size such as 16/3n, 12n^2 or 726n^1/2+1800"); };
  const std::size_t n = word.find('n');
  if (n == word.npos) fail();
  const auto factor = parts_of(word.substr(0, n), '/');
  std::string_view power = word.substr(n + 1);
  const std::size_t sign = power.find_first_of("+-");
  std::string_view constant = sign == power.npos ? "0" : power.substr(sign);
  power = power.substr(0, sign);
  if (constant.starts_with('+')) constant.remove_prefix(1);
  if (!power.empty() && !power.starts_with('^')) fail();
  const auto exponent = parts_of(power.empty() ? "1" : power.substr(1), '/');
  const bool is_half = exponent.size() == 2 && exponent[1] == "2";
  const auto numerator = integer_of<std::int32_t>(factor[0]);
  const auto denominator = factor.size() == 2 ? integer_of<std::int32_t>(factor[1]) : 1;
  const auto half_power = integer_of<std::int32_t>(exponent[0]);
  const auto added = integer_of<std::int32_t>(constant);
  if (!numerator || !denominator || !half_power || !added || factor.size() > 2) fail();
  if (exponent.size() > (is_half ? 2u : 1u) || *half_power < 0 || *half_power > 18) fail();
  const int halves = *half_power * (is_half ? 1 : 2);
  if (*numerator < 0 || *denominator <= 0 || halves > 18) fail();
  return {*numerator, *denominator, static_cast<unsigned>(halves), *added};
}

}  // namespace

void add_promise_options(CLI::App& verb, PromiseArguments& arguments) {
  CLI::Option* bends = verb.add_option("--bends", arguments.bends,
                                       "judge by a promise of these options, as ar3d_proved reads "
                                       "them, instead: most bends of an edge")
                           ->check(whole_number(0, 1000000));
  CLI::Option* cosine = verb.add_option("--cosine", arguments.cosine, "of all angles: -1/3");
  CLI::Option* exactly = verb.add_flag("--exactly", arguments.exactly, "every angle is that one");
  CLI::Option* at_least =
      verb.add_flag("--at-least", arguments.at_least, "no angle is smaller")->excludes(exactly);
  CLI::Option* gram = verb.add_option("--gram", arguments.gram,
                                      "matrix of the lattice: XX,YY,ZZ[,XY,XZ,YZ][:DENOMINATOR]");
  CLI::Option* directions =
      verb.add_option("--directions", arguments.directions, "of segments: 1,1,1:1,-1,1:…");
  CLI::Option* plane =
      verb.add_option("--plane", arguments.plane, "z=0: all vertices are in that plane")
          ->check(one_of({"z=0"}));
  CLI::Option* box =
      verb.add_option("--box", arguments.box, "most extents for n vertices: 8n,8n,12n^2+7");
  bends->needs(cosine);
  for (CLI::Option* option : {cosine, exactly, at_least, gram, directions, plane, box}) {
    option->needs(bends);
    option->default_str("");
  }
}

std::optional<Guarantee> promise_of(const PromiseArguments& arguments) {
  if (!arguments.bends) return std::nullopt;
  if (arguments.exactly == arguments.at_least) {
    throw InputError("--bends needs --exactly or --at-least");
  }
  Guarantee guarantee;
  guarantee.max_bends = *arguments.bends;
  guarantee.angle_rule = arguments.exactly ? AngleRule::exactly : AngleRule::at_least;
  guarantee.cosine = cosine_of(arguments.cosine);
  guarantee.lattice = lattice_of(arguments.gram);
  guarantee.directions = directions_of(arguments.directions);
  guarantee.vertices_in_plane = !arguments.plane.empty();
  if (arguments.box.empty()) return guarantee;
  const auto axes = parts_of(arguments.box, ',');
  if (axes.size() != 3) refuse("--box", arguments.box, "three sizes");
  for (std::size_t i = 0; i < 3; ++i) guarantee.bound.axes[i] = axis_of(axes[i]);
  guarantee.bound.name = "promised";
  return guarantee;
}

}  // namespace ar3d
