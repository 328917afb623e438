#pragma once

#include <cstdint>
#include <exception>
#include <optional>
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

}  // namespace ar3d
