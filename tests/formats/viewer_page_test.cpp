// The page that shows drawings: its data are the drawing, exactly, whatever the drawing is.
#include <fmt/format.h>
#include <zlib.h>

#include <nlohmann/json.hpp>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/formats/drawings/drawing_html.h"
#include "ar3d/formats/drawings/edge_roles.h"
#include "ar3d/generators/catalog.h"
#include "support/problem.h"
#include "support/program.h"
#include "verify/draft.h"

namespace ar3d::testing {
namespace {

Drawing drawing_of(const char* algorithm, const char* family, std::uint64_t n) {
  return draw(find_algorithm(algorithm), generate(find_family(family), n, 7));
}

std::string page_with(const Drawing& drawing, const std::string& title) {
  std::string text;
  ViewerPage page([&](std::string_view piece) { text += piece; });
  page.add(page_entry(title, drawing, nullptr, {}));
  page.finish();
  return text;
}

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t at = text.find(begin) + begin.size();
  return text.substr(at, text.find(end, at) - at);
}

std::string from_base64(const std::string& text) {
  static const std::string kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(kDigits.find(c));
    held += 6;
    if (held >= 8) bytes += static_cast<char>(bits >> (held -= 8) & 255);
  }
  return bytes;
}

std::string inflated(const std::string& bytes) {
  std::string out(1 << 22, '\0');
  uLongf size = out.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(out.data()), &size,
                       reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()),
            Z_OK);
  out.resize(size);
  return out;
}

/// Reads the numbers as docs/formats.md describes them.
class Numbers {
 public:
  explicit Numbers(std::string bytes) : bytes_(std::move(bytes)) {}
  std::uint64_t natural() {
    std::uint64_t value = 0;
    for (int shift = 0;; shift += 7) {
      const auto byte = static_cast<unsigned char>(bytes_.at(at_++));
      value |= std::uint64_t{byte & 127u} << shift;
      if (byte < 128) return value;
    }
  }
  std::int64_t integer() {
    const std::uint64_t value = natural();
    return static_cast<std::int64_t>(value >> 1) ^ -static_cast<std::int64_t>(value & 1);
  }
  Point after(Point p) {
    p.x += integer();
    p.y += integer();
    p.z += integer();
    return p;
  }
  bool at_end() const { return at_ == bytes_.size(); }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

void expect_same(const std::string& page, const Drawing& drawing) {
  Numbers numbers(inflated(from_base64(between(page, "id=\"geometry-0\">", "</script>"))));
  const EdgeRoles roles = edge_roles(drawing);
  Point p = bounding_box(drawing).low;
  for (std::size_t v = 0; v < drawing.num_vertices(); ++v) {
    p = numbers.after(p);
    ASSERT_EQ(p, drawing.vertex(static_cast<Vertex>(v)));
  }
  std::int64_t u = 0;
  std::vector<Point> points;
  for (EdgeId e = 0; e < drawing.num_edges(); ++e) {
    drawing.polyline(e, points);
    u += numbers.integer();
    ASSERT_EQ(u, static_cast<std::int64_t>(drawing.edge(e).u));
    ASSERT_EQ(u + numbers.integer(), static_cast<std::int64_t>(drawing.edge(e).v));
    ASSERT_EQ(numbers.natural(), points.size() - 2);
    ASSERT_EQ(numbers.natural(), roles.edges[e]);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      points[i - 1] = numbers.after(points[i - 1]);
      ASSERT_EQ(points[i - 1], points[i]);
    }
  }
  EXPECT_TRUE(numbers.at_end());
}

TEST(ViewerPage, HoldsTheDrawingExactly) {
  for (const char* algorithm : {"diamond", "compact"}) {
    const Drawing drawing = drawing_of(algorithm, "random-4-regular", 500);
    expect_same(page_with(drawing, "t"), drawing);
  }
  for (const char* algorithm : {"grid", "two-bend"}) {
    const Drawing drawing = drawing_of(algorithm, "random-cubic", 3000);
    expect_same(page_with(drawing, "t"), drawing);
  }
}

Drawing segment(Point a, Point b, const std::string& algorithm = "x") {
  return Draft{{a, b}, {{{0, 1}, {}}}, kCubeLattice, algorithm}.drawing();
}

TEST(ViewerPage, HoldsCoordinatesFarFromTheOrigin) {
  const Drawing far = segment({kMaxCoordinate, -kMaxCoordinate, 0},
                              {kMaxCoordinate - kMaxPageExtent, -kMaxCoordinate, 5});
  const std::string page = page_with(far, "t");
  expect_same(page, far);
  const auto about = nlohmann::json::parse(between(page, "id=\"about-0\">", "</script>"));
  EXPECT_EQ(about["low"][1], std::to_string(-kMaxCoordinate)) << "a text: exact in JavaScript";
}

TEST(ViewerPage, RefusesWhatItCannotShowExactly) {
  EXPECT_EQ(problem([&] {
              page_with(segment({0, 0, 0}, {0, kMaxPageExtent + 1, 0}), "f:3");
            }),
            "f:3: an extent of 4503599627370497, html holds at most 4503599627370496 (2^52)");
}

TEST(ViewerPage, PackedTextUnpacksToItself) {
  std::string text;
  for (int i = 0; i < 30000; ++i) text += fmt::format("{} </script>\n", i * 7919 % 10007);
  for (const std::string& one : {std::string(), std::string("a"), std::string("ab"), text}) {
    const std::string packed = packed_text(one);
    EXPECT_EQ(packed.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                                       "0123456789+/="),
              std::string::npos);
    EXPECT_EQ(inflated(from_base64(packed)), one);
  }
}

TEST(ViewerPage, IsNotEndedByNames) {
  const std::string hostile = "</script><script>alert(1)</script><!--";
  const std::string page = page_with(segment({}, {1, 0, 0}, hostile), hostile);
  EXPECT_EQ(page.find("alert(1)</script>"), std::string::npos);
  const auto about = nlohmann::json::parse(between(page, "id=\"about-0\">", "</script>"));
  EXPECT_EQ(about["algorithm"], hostile);
  EXPECT_EQ(about["title"], hostile);
}

std::vector<std::size_t> counts(const EdgeRoles& roles) {
  std::vector<std::size_t> count(roles.roles.size());
  for (const std::uint8_t role : roles.edges) ++count.at(role);
  return count;
}

TEST(EdgeRoles, EveryEdgeOfADrawingHasOne) {
  for (const char* algorithm : {"diamond", "compact"}) {
    const auto count = counts(edge_roles(drawing_of(algorithm, "random-4-regular", 400)));
    EXPECT_GT(count[0], 100u);
    EXPECT_GT(count[1], 100u);
    EXPECT_EQ(count[2], 0u);
  }
  const auto right_and_left = counts(edge_roles(drawing_of("compact-120", "random-cubic", 400)));
  EXPECT_GT(right_and_left[0], 100u);
  EXPECT_GT(right_and_left[1], 100u);
  EXPECT_EQ(right_and_left[2], 0u);
  const auto grid = counts(edge_roles(drawing_of("grid", "random-cubic", 400)));
  for (const std::size_t label : {0u, 1u, 2u}) EXPECT_GT(grid[label], 50u);
  EXPECT_EQ(grid[4], 0u);
  const auto types = counts(edge_roles(drawing_of("two-bend", "random-cubic", 400)));
  EXPECT_EQ(types[0] + types[1] + types[2], 600u);
  EXPECT_NEAR(static_cast<double>(types[0]), 600 * 4 / 9.0, 60) << "docs/theorem2.md: 4/9 are AA";
}

TEST(GrowthOrder, TellsTheVerticesApart) {
  for (const char* algorithm : {"diamond", "grid", "two-bend", "two-bend-109"}) {
    const Drawing drawing = drawing_of(algorithm, "random-cubic", 300);
    const auto weights = growth_order(drawing).second;
    std::vector<std::int64_t> keys;
    for (std::size_t v = 0; v < 300; ++v) {
      const Point p = drawing.vertex(static_cast<Vertex>(v));
      keys.push_back(weights[0] * p.x + weights[1] * p.y + weights[2] * p.z);
    }
    std::sort(keys.begin(), keys.end());
    EXPECT_EQ(std::adjacent_find(keys.begin(), keys.end()), keys.end()) << algorithm;
  }
}

}  // namespace
}  // namespace ar3d::testing
