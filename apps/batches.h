#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ar3d/base/parallel.h"

namespace ar3d {

/// Reads items one after the other, works on many of them at once (--threads of the verb),
/// or on a single large one with all threads, and hands the results on in input order. A batch ends
/// when its weight (vertices plus edges) passes kBatchWeight, so memory stays bounded whatever the
/// input. `next()` gives std::optional<Item>; `weight(item)`; `work(item)` gives a Result and may
/// run on any thread; `emit(result)` runs on the calling thread. The first exception of work is
/// thrown again in input order.
inline constexpr std::uint64_t kBatchWeight = std::uint64_t{1} << 20;

template <class Item, class Next, class Weight, class Work, class Emit>
void in_batches(Next&& next, Weight&& weight, Work&& work, Emit&& emit) {
  using Result = decltype(work(std::declval<Item&>()));
  bool more = true;
  while (more) {
    std::vector<Item> items;
    std::exception_ptr broken_input;  // what was read before it is still worked on
    std::uint64_t total = 0;
    while (total < kBatchWeight) {
      try {
        std::optional<Item> item = next();
        if (!item) {
          more = false;
          break;
        }
        total += 64 + weight(*item);
        items.push_back(std::move(*item));
      } catch (...) {
        broken_input = std::current_exception();
        break;
      }
    }
    std::vector<std::optional<Result>> results(items.size());
    std::vector<std::exception_ptr> errors(items.size());
    for_each_in_threads(available_threads(), items.size(), [&](std::uint32_t, std::size_t i) {
      try {
        results[i] = work(items[i]);
      } catch (...) {
        errors[i] = std::current_exception();
      }
    });
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (errors[i]) std::rethrow_exception(errors[i]);
      emit(*results[i]);
    }
    if (broken_input) std::rethrow_exception(broken_input);
  }
}

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
