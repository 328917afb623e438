#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace ar3d {

/// Represents the files of a verb, read one after the other as if they were one.
template <class Reader>
class SeveralInputs {
 public:
  /// Opens the first. @pre paths is not empty. @throws InputError as open.
  SeveralInputs(std::vector<std::string> paths,
                std::function<std::unique_ptr<Reader>(const std::string&)> open)
      : paths_(std::move(paths)), open_(std::move(open)), reader_(open_(paths_.front())) {}

  /// Returns the next item of the file, or of the next one; nothing at the end of the last.
  auto next() {
    for (;;) {
      auto item = reader_->next();
      if (item || at_ + 1 == paths_.size()) return item;
      reader_ = open_(paths_[++at_]);
    }
  }
  /// Returns the reader of the item just given.
  Reader& reader() { return *reader_; }

 private:
  std::vector<std::string> paths_;
  std::function<std::unique_ptr<Reader>(const std::string&)> open_;
  std::unique_ptr<Reader> reader_;
  std::size_t at_ = 0;
};

}  // namespace ar3d
