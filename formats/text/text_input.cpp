// Lines from large blocks. Whole blocks of lines are given away at once, which is what makes plain
// lines fast.
#include "ar3d/formats/text/text_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "ar3d/base/error.h"

namespace ar3d {
namespace {
constexpr std::size_t kLeastBlock = std::size_t{1} << 6;
constexpr std::size_t kFirstBlock = std::size_t{1} << 12;  // enough for a small file
constexpr std::size_t kBlock = std::size_t{1} << 18;
constexpr std::size_t kShownBytes = 40;
constexpr std::size_t kSlack = 8;  // readable behind the text
}  // namespace

TextInput::TextInput(std::string name, std::unique_ptr<ByteSource> bytes)
    : name_(std::move(name)), bytes_(without_mark(std::move(bytes), name_)) {
  make_room(std::clamp<std::uint64_t>(bytes_->bytes_left() + 1, kLeastBlock, kFirstBlock));
}

std::size_t TextInput::room() const { return buffer_.size() - kSlack; }

void TextInput::make_room(std::size_t bytes) {
  buffer_.resize(bytes + kSlack);
  std::fill(buffer_.end() - kSlack, buffer_.end(), '\0');
}

bool TextInput::read_block() {
  if (at_end_) return false;
  if (end_ == room() && end_ < kBlock) make_room(kBlock);
  if (begin_ > 0 && end_ == room()) {  // drop the lines already given
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    dropped_ += begin_;
    next_ -= begin_;
    end_ -= begin_;
    whole_end_ -= std::min(whole_end_, begin_);
    begin_ = 0;
  }
  if (end_ == room()) {  // a long line: less is copied than by doubling if the text goes on
    make_room(room() + std::clamp<std::uint64_t>(bytes_->bytes_left(), room(), 7 * room()));
  }
  const std::size_t got = bytes_->read(buffer_.data() + end_, room() - end_);
  const std::size_t newline = std::string_view(buffer_.data() + end_, got).rfind('\n');
  if (newline != std::string_view::npos) whole_end_ = end_ + newline + 1;
  end_ += got;
  at_end_ = got == 0;
  return !at_end_;
}

std::optional<std::string_view> TextInput::next_line() {
  begin_ = next_;
  const char* newline = nullptr;
  std::size_t searched = next_;
  for (;;) {
    newline =
        static_cast<const char*>(std::memchr(buffer_.data() + searched, '\n', end_ - searched));
    if (newline != nullptr) break;
    const std::size_t pending = end_ - begin_;
    if (!read_block()) break;
    searched = begin_ + pending;
  }
  if (newline == nullptr && begin_ == end_) return std::nullopt;
  ++line_;
  std::size_t stop = newline ? static_cast<std::size_t>(newline - buffer_.data()) : end_;
  next_ = newline ? stop + 1 : stop;
  if (stop > begin_ && buffer_[stop - 1] == '\r') --stop;
  return std::string_view(buffer_.data() + begin_, stop - begin_);
}

void TextInput::put_back() {
  expect(next_ > begin_, "only the line just given can be put back");
  next_ = begin_;
  --line_;
}

void TextInput::take(std::size_t bytes, std::uint64_t lines) {
  next_ += bytes;
  begin_ = next_;
  line_ += lines;
}

std::string_view TextInput::look_ahead(std::size_t wanted) {
  begin_ = next_;
  while (end_ - next_ < wanted && read_block()) {
  }
  return {buffer_.data() + next_, end_ - next_};
}

std::string_view TextInput::look_ahead_line() {
  begin_ = next_;
  for (;;) {
    const std::string_view text(buffer_.data() + next_, end_ - next_);
    if (text.find('\n') != std::string_view::npos || text.size() >= kBlock || !read_block()) {
      return {buffer_.data() + next_, end_ - next_};
    }
  }
}

std::string TextInput::take_all() {
  std::string text(look_ahead(std::numeric_limits<std::size_t>::max()));
  take(text.size(), 1);
  return text;
}

void TextInput::fail_behind(std::string_view before, const std::string& message) const {
  const auto lines = static_cast<std::uint64_t>(std::count(before.begin(), before.end(), '\n'));
  fail_at(lines + 1, before.size() - (before.rfind('\n') + 1) + 1, message);
}

void TextInput::fail(std::size_t column, const std::string& message) const {
  fail_at(line_, column, message);
}

void TextInput::fail_at(std::uint64_t line, std::size_t column, const std::string& message) const {
  if (column == 0) throw InputError(fmt::format("{}:{}: {}", name_, line, message));
  throw InputError(fmt::format("{}:{}:{}: {}", name_, line, column, message));
}

std::string shown(std::string_view text) {
  std::string result = "'";
  for (const char c : text.substr(0, kShownBytes)) {
    if (c >= ' ' && c <= '~') {
      result += c;
    } else {
      result += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    }
  }
  return result + (text.size() > kShownBytes ? "'…" : "'");
}

}  // namespace ar3d
