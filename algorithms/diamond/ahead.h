#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace ar3d::diamond {

/// How many places ahead something is asked for when an order is known whose places in memory are
/// in no order.
inline constexpr std::size_t kAhead = 16;

/// Calls visit(i, array[order[i]]) for i = begin, ..., end - 1, and asks for elements ahead, beyond
/// `end` too: the next range is often next.
template <class Order, class Array, class Visit>
void for_each_ahead(const Order& order, Array& array, std::size_t begin, std::size_t end,
                    Visit visit) {
  constexpr int kWritten = std::is_const_v<Array> ? 0 : 1;
  const std::size_t known = order.size() < kAhead ? 0 : order.size() - kAhead;
  std::size_t i = begin;
  for (const std::size_t stop = std::min(end, known); i < stop; ++i) {
    __builtin_prefetch(&array[order[i + kAhead]], kWritten);
    visit(i, array[order[i]]);
  }
  for (; i < end; ++i) visit(i, array[order[i]]);
}

}  // namespace ar3d::diamond
