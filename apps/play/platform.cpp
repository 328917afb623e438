// What the system does elsewhere, for a page: one thread, files in memory, no packed input. It stands for
// base/parallel.cpp, base/new_file.cpp, formats/text/byte_source.cpp and formats/graphs/graphml.cpp.
#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <string>
#include <utility>

#include "ar3d/base/error.h"
#include "ar3d/base/new_file.h"
#include "ar3d/base/parallel.h"
#include "ar3d/formats/graphs/graph_format.h"
#include "ar3d/formats/text/text_input.h"

namespace ar3d {

std::uint32_t available_threads() { return 1; }

void in_threads(std::uint32_t count, const std::function<void(std::uint32_t)>& work) {
  if (count > 1) throw InputError(fmt::format("cannot start {} threads: a page has one", count));
  work(0);
}

void for_each_in_threads(std::uint32_t, std::size_t size,
                         const std::function<void(std::uint32_t, std::size_t)>& work, std::size_t) {
  for (std::size_t i = 0; i < size; ++i) work(0, i);
}

void refuse_writing(const std::string& path, int reason) {
  throw InputError(fmt::format("cannot write {}: {}", path, std::strerror(reason)));
}

void write_all(int descriptor, std::span<const char> bytes, const std::string& path) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written <= 0) refuse_writing(path, written == 0 ? EIO : errno);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

NewFile::NewFile(const std::string& path)
    : path_(path), descriptor_(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600)) {
  if (descriptor_.get() < 0) refuse_writing(path, errno);
}
NewFile::~NewFile() = default;
void NewFile::write_all(std::span<const char> bytes) {
  ar3d::write_all(descriptor_.get(), bytes, path_);
}
void NewFile::become_target() { descriptor_ = Descriptor(); }

namespace {

class TextBytes final : public ByteSource {
 public:
  explicit TextBytes(std::string text) : text_(std::move(text)) {}
  std::size_t read(char* to, std::size_t size) override {
    const std::size_t given = text_.copy(to, size, used_);
    used_ += given;
    return given;
  }
  std::uint64_t bytes_left() const override { return text_.size() - used_; }

 private:
  std::string text_;
  std::size_t used_ = 0;
};

std::unique_ptr<GraphParser> no_parser(TextInput& input, const ReadOptions&) {
  input.fail(0, "XML is not read here");
}

}  // namespace

std::unique_ptr<ByteSource> bytes_of(std::string text) {
  return std::make_unique<TextBytes>(std::move(text));
}
// The page decodes what it is given (play.js).
std::unique_ptr<ByteSource> without_mark(std::unique_ptr<ByteSource> bytes, const std::string&) {
  return bytes;
}
std::string display_name(const std::string& path) { return path == "-" ? "<stdin>" : path; }
std::unique_ptr<ByteSource> open_bytes(const std::string& path) {
  throw InputError("cannot read " + path + ": a page opens no files");
}

// The page's own reader of XML makes DOT of a GraphML file (play.js).
GraphFormat graphml_format() {
  return {.name = "graphml",
          .extensions = {".graphml", ".xml"},
          .summary = "GraphML",
          .detect = [](const InputHead& head) { return head.text.starts_with('<'); },
          .parser = no_parser,
          .writer = nullptr};
}

}  // namespace ar3d
