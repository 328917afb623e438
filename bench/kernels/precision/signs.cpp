// Where rounding gives the wrong sign: which positions around a point where two segments touch.
#include <fmt/format.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdlib>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/base/ieee_arithmetic.h"
#include "ar3d/base/new_file.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/predicates/meeting.h"
#include "precision.h"

namespace ar3d::precision {
namespace {

using Exact = boost::multiprecision::int256_t;

constexpr int kWindow = 64;                         // positions per side
constexpr std::size_t kPairs = 200, kMost = 20000;  // looked at
constexpr double kCell = 4;                         // pixels

/// The sign that decides first whether two segments can meet, by the formula of meeting_kind(): on
/// which side of the first segment does the second one pass?
template <class Number>
int side(const SegmentPair& pair) {
  using verify::meeting::converted;
  using verify::meeting::cross;
  using verify::meeting::difference;
  const auto a = converted<Number>(pair[0]), b = converted<Number>(pair[1]);
  const auto c = converted<Number>(pair[2]), d = converted<Number>(pair[3]);
  const auto normal = cross(difference(b, a), difference(d, c));
  const auto between = difference(c, a);
  const Number value = normal[0] * between[0] + normal[1] * between[1] + normal[2] * between[2];
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// The signs of a window of positions of d, in x and y around the first end of the first segment,
/// where the two segments touch: exact, and in a type.
struct SignMap {
  std::string title;
  std::vector<int> exact, seen;  ///< by row, then column
  std::size_t wrong() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) count += exact[i] != seen[i];
    return count;
  }
  /// Does each side have an eighth of the window? Else the segments stay in one plane, or nearly.
  bool is_divided() const {
    const auto share = [&](int sign) {
      return 8 * std::count(exact.begin(), exact.end(), sign) >=
             static_cast<std::ptrdiff_t>(exact.size());
    };
    return share(1) && share(-1);
  }
};

template <class Number>
SignMap map_of(const SegmentPair& pair, std::int64_t step, std::string title) {
  SignMap map{std::move(title), {}, {}};
  for (int row = 0; row < kWindow; ++row) {
    for (int column = 0; column < kWindow; ++column) {
      SegmentPair moved = pair;
      moved[3] = pair[0] + Vector{(column - kWindow / 2) * step, (kWindow / 2 - row) * step, 0};
      map.exact.push_back(side<Exact>(moved));
      map.seen.push_back(side<Number>(moved));
    }
  }
  return map;
}

std::vector<SegmentPair> pairs_of(std::uint64_t n) {
  const Algorithm& algorithm = find_algorithm("two-bend");
  auto pairs = decisions_of(draw(algorithm, generate(find_family("random-cubic"), n, 1)),
                            algorithm.guarantee, kMost)
                   .pairs;
  std::vector<SegmentPair> some;  // evenly
  const std::size_t stride = std::max<std::size_t>(1, pairs.size() / kPairs);
  for (std::size_t i = 0; i < pairs.size(); i += stride) some.push_back(pairs[i]);
  return some;
}

/// All coordinates times the power of two that brings the largest to nearly 2^bits.
SegmentPair scaled(SegmentPair pair, int bits) {
  std::int64_t largest = 1;
  for (const Point& p : pair) {
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  std::int64_t factor = 1;
  while (largest * factor < (std::int64_t{1} << (bits - 1))) factor *= 2;
  for (Point& p : pair) p = {factor * p.x, factor * p.y, factor * p.z};
  return pair;
}

/// The maps of one type over the pairs of segments of one kind: in one plane or nearly so for the
/// whole window, or with two sides. @return the worst, and of all maps the wrong signs and all.
template <class Number>
std::tuple<SignMap, std::uint64_t, std::uint64_t> worst_map(const std::vector<SegmentPair>& pairs,
                                                            int bits, std::int64_t step,
                                                            bool is_divided,
                                                            const std::string& title) {
  SignMap worst;
  std::uint64_t wrong = 0, all = 0;
  for (const SegmentPair& pair : pairs) {
    SignMap map = map_of<Number>(bits == 0 ? pair : scaled(pair, bits), step, title);
    if (map.is_divided() != is_divided) continue;
    wrong += map.wrong();
    all += map.exact.size();
    if (worst.exact.empty() || map.wrong() > worst.wrong()) worst = std::move(map);
  }
  return {std::move(worst), wrong, all};
}

const char* colour(int exact, int seen) {
  if (exact != seen) return "#000";
  return exact > 0 ? "#9ecae9" : exact < 0 ? "#fdd0a2" : "#fff";
}

/// Cells of one colour beside one another are one rectangle.
std::string map_svg(const SignMap& map, double left) {
  std::string svg = fmt::format(
      "<text x='{}' y='14' font-size='12' font-family='sans-serif'>{}: {} of {} wrong"
      "</text>\n",
      left, map.title, map.wrong(), map.exact.size());
  for (int row = 0; row < kWindow; ++row) {
    for (int column = 0, end = 0; column < kWindow; column = end) {
      const auto at = [&](int i) {
        const auto index = static_cast<std::size_t>(row) * kWindow + static_cast<std::size_t>(i);
        return colour(map.exact[index], map.seen[index]);
      };
      for (end = column + 1; end < kWindow && at(end) == at(column);) ++end;
      svg += fmt::format("<path fill='{}' d='M{} {}h{}v{}h-{}z'/>\n", at(column),
                         left + kCell * column, 22 + kCell * row, kCell * (end - column), kCell,
                         kCell * (end - column));
    }
  }
  return svg;
}

void write_maps(const std::vector<SignMap>& maps, const std::string& path) {
  const double side = kCell * kWindow, width = (side + 20) * static_cast<double>(maps.size());
  std::string svg = fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0} {1}' width='{0}' height='{1}'>\n"
      "<rect width='{0}' height='{1}' fill='#fff'/>\n",
      width, side + 30);
  for (std::size_t i = 0; i < maps.size(); ++i) {
    svg += map_svg(maps[i], 10 + (side + 20) * static_cast<double>(i));
  }
  svg += "</svg>\n";
  NewFile file(path);
  file.write_all(svg);
  if (!file.become_new_target()) throw InputError(path + " exists already");
}

std::vector<SignMap> position_maps() {
  const std::vector<SegmentPair> pairs = pairs_of(10000);
  std::vector<std::vector<std::string>> rows;
  std::vector<SignMap> maps;
  const auto add = [&]<class Number>(Number, const std::string& type, int bits, std::int64_t step) {
    std::vector<std::string> row{
        type, bits == 0 ? "as drawn, steps of 1" : fmt::format("2^{}, steps of {}", bits, step)};
    for (const bool is_divided : {true, false}) {
      auto [worst, wrong, all] = worst_map<Number>(
          pairs, bits, step, is_divided, type + (is_divided ? ", two sides" : ", one plane"));
      row.push_back(rate(wrong, all));
      row.push_back(fmt::format("{} of {}", worst.wrong(), worst.exact.size()));
      if (worst.wrong() > 0) maps.push_back(std::move(worst));
    }
    rows.push_back(std::move(row));
  };
  add(0.0F, "float", 0, 1);
  add(0.0, "double", 0, 1);
  add(0.0, "double", 60, 16);
  add(0.0L, kLongDouble, 60, 16);
  fmt::print(
      "Wrong signs of the side on which one segment passes another, for {1} pairs of segments of "
      "`two-bend`, n = 10000. An end takes {0} x {0} positions around the point where they touch, "
      "a window. Two sides: at least an eighth of it is on each. One plane: otherwise.\n\n",
      kWindow, pairs.size());
  print_table(
      {"type", "coordinates", "two sides: wrong", "worst pair", "one plane: wrong", "worst pair"},
      rows);
  return maps;
}

}  // namespace

void sign_tables(const std::string& picture) {
  const std::vector<SignMap> maps = position_maps();
  if (!picture.empty()) write_maps(maps, picture);
}

}  // namespace ar3d::precision
