// Files, gzip, xz and memory behind one interface; packed data may not claim gigabytes for a few
// bytes.
#include <fmt/format.h>
#include <iconv.h>
#include <lzma.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/base/new_file.h"
#include "ar3d/formats/text/text_input.h"

namespace ar3d {
namespace {

constexpr std::size_t kCompressedBlock = std::size_t{1} << 16;
constexpr std::uint64_t kXzMemory = std::uint64_t{128} << 20;  // xz -9 needs 65 MiB
// A text may be this long plus so many bytes for each packed one. gzip reaches 1030 on zeros,
// graphs 5 to 100.
constexpr std::uint64_t kFreeUnpacked = std::uint64_t{16} << 20;
constexpr std::uint64_t kMostUnpackedPerByte = 200;

class FileBytes final : public ByteSource {
 public:
  explicit FileBytes(const std::string& path) : name_(display_name(path)) {
    if (path == "-") return;
    file_ = open_input(path);
    fd_ = file_.get();
    if (fd_ < 0) fail();
  }

  std::size_t read(char* to, std::size_t size) override {
    for (;;) {
      const ssize_t got = ::read(fd_, to, size);
      if (got >= 0) return static_cast<std::size_t>(got);
      if (errno != EINTR) fail();
    }
  }

  std::uint64_t bytes_left() const override {
    struct stat status {};
    if (::fstat(fd_, &status) != 0 || !S_ISREG(status.st_mode)) return 0;
    const off_t offset = ::lseek(fd_, 0, SEEK_CUR);
    if (offset < 0 || offset > status.st_size) return 0;
    return static_cast<std::uint64_t>(status.st_size - offset);
  }

 private:
  [[noreturn]] void fail() const {
    throw InputError(fmt::format("cannot read {}: {}", name_, std::strerror(errno)));
  }

  std::string name_;
  Descriptor file_;
  int fd_ = STDIN_FILENO;
};

/// Holds what gzip and xz share: compressed bytes come in blocks.
class CompressedBytes : public ByteSource {
 public:
  CompressedBytes(std::unique_ptr<ByteSource> inner, std::string name)
      : inner_(std::move(inner)), name_(std::move(name)), block_(kCompressedBlock) {}

 protected:
  std::string_view next_block() {
    const std::size_t size = inner_->read(block_.data(), block_.size());
    packed_ += size;
    return {block_.data(), size};
  }
  /// To be called with all that is unpacked: a few bytes must not claim gigabytes.
  void count_unpacked(std::size_t size) {
    unpacked_ += size;
    if (unpacked_ <= kFreeUnpacked + kMostUnpackedPerByte * packed_) return;
    fail(fmt::format("{} bytes unpack to more than {} MiB: unpack it first if that is meant",
                     packed_, unpacked_ >> 20));
  }
  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(fmt::format("{}: {}", name_, problem));
  }

 private:
  std::unique_ptr<ByteSource> inner_;
  std::string name_;
  std::vector<char> block_;
  std::uint64_t packed_ = 0;
  std::uint64_t unpacked_ = 0;
};

class GzipBytes final : public CompressedBytes {
 public:
  GzipBytes(std::unique_ptr<ByteSource> inner, const std::string& name)
      : CompressedBytes(std::move(inner), name) {
    expect(inflateInit2(&stream_, 15 + 16) == Z_OK, "zlib starts");  // 16: gzip headers only
  }
  ~GzipBytes() override { inflateEnd(&stream_); }

  std::size_t read(char* to, std::size_t size) override {
    stream_.next_out = reinterpret_cast<Bytef*>(to);
    stream_.avail_out = static_cast<uInt>(std::min<std::size_t>(size, kCompressedBlock));
    const std::size_t room = stream_.avail_out;
    while (stream_.avail_out == room) {
      if (stream_.avail_in == 0 && !refill()) break;
      if (!in_member_) begin_member();
      const int status = inflate(&stream_, Z_NO_FLUSH);
      if (status == Z_STREAM_END) {
        in_member_ = false;
      } else if (status != Z_OK && status != Z_BUF_ERROR) {
        fail(fmt::format("corrupt gzip data ({})", stream_.msg ? stream_.msg : "no reason given"));
      }
    }
    count_unpacked(room - stream_.avail_out);
    return room - stream_.avail_out;
  }

 private:
  bool refill() {
    const std::string_view block = next_block();
    if (block.empty()) {
      if (in_member_) fail("the gzip data end too early");
      return false;
    }
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(block.data()));
    stream_.avail_in = static_cast<uInt>(block.size());
    return true;
  }
  void begin_member() {  // gzip files may be written one after the other
    inflateReset(&stream_);
    in_member_ = true;
  }

  z_stream stream_{};
  bool in_member_ = true;
};

class XzBytes final : public CompressedBytes {
 public:
  XzBytes(std::unique_ptr<ByteSource> inner, const std::string& name)
      : CompressedBytes(std::move(inner), name) {
    expect(lzma_stream_decoder(&stream_, kXzMemory, LZMA_CONCATENATED) == LZMA_OK,
           "liblzma starts");
  }
  ~XzBytes() override { lzma_end(&stream_); }

  std::size_t read(char* to, std::size_t size) override {
    stream_.next_out = reinterpret_cast<std::uint8_t*>(to);
    stream_.avail_out = size;
    while (stream_.avail_out == size && !finished_) {
      if (stream_.avail_in == 0 && !at_end_) refill();
      const lzma_ret status = lzma_code(&stream_, at_end_ ? LZMA_FINISH : LZMA_RUN);
      if (status == LZMA_STREAM_END) {
        finished_ = true;
      } else if (status != LZMA_OK) {
        fail(problem(status));
      }
    }
    count_unpacked(size - stream_.avail_out);
    return size - stream_.avail_out;
  }

 private:
  void refill() {
    const std::string_view block = next_block();
    at_end_ = block.empty();
    stream_.next_in = reinterpret_cast<const std::uint8_t*>(block.data());
    stream_.avail_in = block.size();
  }
  static std::string problem(lzma_ret status) {
    if (status == LZMA_BUF_ERROR) return "the xz data end too early";
    if (status == LZMA_MEMLIMIT_ERROR) return "the xz data need more than 128 MiB to unpack";
    return fmt::format("corrupt xz data (liblzma status {})", static_cast<int>(status));
  }

  lzma_stream stream_ = LZMA_STREAM_INIT;
  bool at_end_ = false;
  bool finished_ = false;
};

/// UTF-16 with its mark as UTF-8; nothing if it is not that.
std::optional<std::string> utf8_of_utf16(std::string_view text) {
  const iconv_t converter = iconv_open("UTF-8", "UTF-16");
  // NOLINTNEXTLINE(performance-no-int-to-ptr): how iconv_open tells an error
  expect(converter != reinterpret_cast<iconv_t>(-1), "iconv knows UTF-16");
  std::string result(text.size() / 2 * 3 + 4, '\0');  // at most 3 bytes for a unit of 2
  char* from = const_cast<char*>(text.data());
  char* to = result.data();
  std::size_t from_left = text.size();
  std::size_t to_left = result.size();
  const bool good =
      iconv(converter, &from, &from_left, &to, &to_left) != static_cast<std::size_t>(-1);
  iconv_close(converter);
  if (!good) return std::nullopt;
  result.resize(result.size() - to_left);
  return result;
}

/// Bytes in memory, and those behind them if there are any.
class ReadAhead final : public ByteSource {
 public:
  explicit ReadAhead(std::string head, std::unique_ptr<ByteSource> rest = nullptr)
      : head_(std::move(head)), rest_(std::move(rest)) {}
  std::size_t read(char* to, std::size_t size) override {
    if (used_ == head_.size() && rest_ != nullptr) return rest_->read(to, size);
    const std::size_t given = head_.copy(to, size, used_);
    used_ += given;
    return given;
  }
  std::uint64_t bytes_left() const override {
    return head_.size() - used_ + (rest_ != nullptr ? rest_->bytes_left() : 0);
  }

 private:
  std::string head_;
  std::size_t used_ = 0;
  std::unique_ptr<ByteSource> rest_;
};

/// The first bytes, fewer than `size` only at the end.
std::string read_head(ByteSource& bytes, std::size_t size) {
  std::string head;
  char block[4096];
  while (head.size() < size) {
    const std::size_t got = bytes.read(block, std::min(size - head.size(), sizeof block));
    if (got == 0) break;
    head.append(block, got);
  }
  return head;
}

}  // namespace

std::unique_ptr<ByteSource> without_mark(std::unique_ptr<ByteSource> bytes,
                                         const std::string& name) {
  std::string head = read_head(*bytes, 3);
  if (head.starts_with("\xff\xfe") || head.starts_with("\xfe\xff")) {
    head += read_head(*bytes, std::numeric_limits<std::size_t>::max());
    std::optional<std::string> text = utf8_of_utf16(head);
    if (!text) throw InputError(name + ": the text is no UTF-16, as its first bytes say");
    return bytes_of(std::move(*text));
  }
  if (head.starts_with("\xef\xbb\xbf")) return bytes;
  return std::make_unique<ReadAhead>(std::move(head), std::move(bytes));
}

std::string display_name(const std::string& path) { return path == "-" ? "<stdin>" : path; }

std::unique_ptr<ByteSource> open_bytes(const std::string& path) {
  using namespace std::string_view_literals;
  auto file = std::make_unique<FileBytes>(path);
  const std::string magic = read_head(*file, 6);
  auto bytes = std::make_unique<ReadAhead>(magic, std::move(file));
  if (magic.starts_with("\x1f\x8b"sv)) {
    return std::make_unique<GzipBytes>(std::move(bytes), display_name(path));
  }
  if (magic == "\xfd\x37zXZ\0"sv) {
    return std::make_unique<XzBytes>(std::move(bytes), display_name(path));
  }
  return bytes;
}

std::unique_ptr<ByteSource> bytes_of(std::string text) {
  return std::make_unique<ReadAhead>(std::move(text));
}

}  // namespace ar3d
