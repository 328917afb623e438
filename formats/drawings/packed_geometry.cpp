// Differences of successive points as integers of 7 bits a byte, deflated: a tenth of the same
// numbers as JSON.
#include "ar3d/formats/drawings/packed_geometry.h"

#define ZLIB_CONST  // zlib does not change what it reads
#include <zlib.h>

#include <array>
#include <vector>

#include "ar3d/base/error.h"

namespace ar3d {
namespace {

using Put = std::function<void(std::string_view)>;

/// Bytes in, base64 out; whole groups of three bytes at a time.
class Base64 {
 public:
  explicit Base64(const Put& put) : put_(put) {}

  void add(const unsigned char* bytes, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      group_ = group_ << 8 | bytes[i];
      if (++held_ == 3) emit(4);
    }
    pass_on(kBlock);
  }
  void finish() {
    const int held = held_;
    for (; held_ > 0 && held_ < 3; ++held_) group_ <<= 8;
    if (held > 0) emit(held + 1);
    if (held > 0) text_.append(static_cast<std::size_t>(3 - held), '=');
    pass_on(1);
  }

 private:
  static constexpr std::size_t kBlock = std::size_t{1} << 16;

  void emit(int digits) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (int i = 0; i < digits; ++i) text_ += kDigits[group_ >> (18 - 6 * i) & 63];
    group_ = 0;
    held_ = 0;
  }
  void pass_on(std::size_t least) {
    if (text_.size() < least) return;
    put_(text_);
    text_.clear();
  }

  const Put& put_;
  std::uint32_t group_ = 0;
  int held_ = 0;
  std::string text_;
};

/// Bytes in, deflated base64 out.
class Deflated {
 public:
  explicit Deflated(const Put& put) : base64_(put) {
    expect(deflateInit(&zip_, Z_DEFAULT_COMPRESSION) == Z_OK, "zlib starts");
  }
  Deflated(const Deflated&) = delete;
  Deflated& operator=(const Deflated&) = delete;
  ~Deflated() { deflateEnd(&zip_); }

  void add(std::string_view bytes) { deflate_all(bytes, Z_NO_FLUSH); }
  void finish() {
    deflate_all({}, Z_FINISH);
    base64_.finish();
  }

 private:
  static constexpr std::size_t kBlock = std::size_t{1} << 16;

  /// @param bytes  fewer than 2^32.
  void deflate_all(std::string_view bytes, int flush) {
    zip_.next_in = reinterpret_cast<const Bytef*>(bytes.data());
    zip_.avail_in = static_cast<uInt>(bytes.size());
    do {
      zip_.next_out = out_.data();
      zip_.avail_out = static_cast<uInt>(out_.size());
      deflate(&zip_, flush);
      base64_.add(out_.data(), out_.size() - zip_.avail_out);
    } while (zip_.avail_out == 0);
  }

  Base64 base64_;
  z_stream zip_{};
  std::vector<unsigned char> out_ = std::vector<unsigned char>(kBlock);  // a stack may be small
};

/// Whole numbers in, deflated base64 out.
class PackedNumbers {
 public:
  explicit PackedNumbers(const Put& put) : out_(put) {}

  void add(std::uint64_t value) {
    for (; value >= 128; value >>= 7) bytes_.push_back(static_cast<char>(value | 128));
    bytes_.push_back(static_cast<char>(value));
    if (bytes_.size() >= kBlock) pass_on();
  }
  void add_signed(std::int64_t value) {
    add(static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63));
  }
  void add_vector(Vector d) {
    add_signed(d.x);
    add_signed(d.y);
    add_signed(d.z);
  }
  void finish() {
    pass_on();
    out_.finish();
  }

 private:
  static constexpr std::size_t kBlock = std::size_t{1} << 16;

  void pass_on() {
    out_.add(bytes_);
    bytes_.clear();
  }

  Deflated out_;
  std::string bytes_;
};

std::int64_t number(Vertex v) { return static_cast<std::int64_t>(v); }

}  // namespace

void write_packed_geometry(const Drawing& drawing, const EdgeRoles& roles, Point low,
                           const Put& put) {
  PackedNumbers out(put);
  Point last = low;
  for (std::size_t v = 0; v < drawing.num_vertices(); ++v) {
    const Point p = drawing.vertex(static_cast<Vertex>(v));
    out.add_vector(p - last);
    last = p;
  }
  std::int64_t last_u = 0;
  for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& points) {
    const Edge ends = drawing.edge(e);
    out.add_signed(number(ends.u) - last_u);
    last_u = number(ends.u);
    out.add_signed(number(ends.v) - last_u);
    out.add(points.size() - 2);
    out.add(roles.edges[e]);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) out.add_vector(points[i] - points[i - 1]);
  });
  out.finish();
}

std::string packed_text(std::string_view text) {
  constexpr std::size_t kPiece = std::size_t{1} << 30;
  std::string packed;
  const Put put = [&](std::string_view piece) { packed += piece; };
  Deflated out(put);
  for (; text.size() > kPiece; text.remove_prefix(kPiece)) out.add(text.substr(0, kPiece));
  out.add(text);
  out.finish();
  return packed;
}

}  // namespace ar3d
