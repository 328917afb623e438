#pragma once
// What the core uses of C++20's library and libc++ 13, emscripten's, lacks: algorithms over ranges,
// numbers with a point from characters, bit_cast, atomic_ref; here for one thread. Every source of the
// page is compiled with this header in front (CMakeLists.txt); no other is.

#include <version>

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 15000
#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <string>

namespace std {  // NOLINT(cert-dcl58-cpp): names that a later version of this library has
namespace ranges {

#define AR3D_WITH_VALUE(name, call)                                                        \
  template <class Range, class Value, class Compare = less, class Projection = identity>   \
  auto name(Range&& range, const Value& value, Compare compare = {}, Projection of = {}) { \
    const auto first = std::begin(range), last = std::end(range);                          \
    return call;                                                                           \
  }
AR3D_WITH_VALUE(lower_bound,
                std::lower_bound(first, last, value, [&](const auto& a, const Value& b) {
                  return std::invoke(compare, std::invoke(of, a), b);
                }))
AR3D_WITH_VALUE(upper_bound,
                std::upper_bound(first, last, value, [&](const Value& a, const auto& b) {
                  return std::invoke(compare, a, std::invoke(of, b));
                }))
AR3D_WITH_VALUE(binary_search, std::binary_search(first, last, value, compare))
#undef AR3D_WITH_VALUE

#define AR3D_COMPARING(name)                                                                 \
  template <class Range, class Compare = less, class Projection = identity>                  \
  auto name(Range&& range, Compare compare = {}, Projection of = {}) {                       \
    return std::name(std::begin(range), std::end(range), [&](const auto& a, const auto& b) { \
      return std::invoke(compare, std::invoke(of, a), std::invoke(of, b));                   \
    });                                                                                      \
  }
AR3D_COMPARING(sort)
AR3D_COMPARING(stable_sort)
AR3D_COMPARING(is_sorted)
AR3D_COMPARING(min_element)
#undef AR3D_COMPARING

template <class Range>
auto max(Range&& range) {
  return *std::max_element(std::begin(range), std::end(range));
}

#define AR3D_ASKING(name)                                                                         \
  template <class Range, class Predicate, class Projection = identity>                            \
  auto name(Range&& range, Predicate is, Projection of = {}) {                                    \
    return std::name(std::begin(range), std::end(range),                                          \
                     [&](const auto& a) -> bool { return std::invoke(is, std::invoke(of, a)); }); \
  }
AR3D_ASKING(all_of)
AR3D_ASKING(any_of)
AR3D_ASKING(none_of)
AR3D_ASKING(find_if)
#undef AR3D_ASKING

template <class Range, class Value, class Projection = identity>
auto find(Range&& range, const Value& value, Projection of = {}) {
  return find_if(
      range, [&](const auto& a) { return a == value; }, of);
}
template <class Range, class Value, class Projection = identity>
auto count(Range&& range, const Value& value, Projection of = {}) {
  return std::count_if(std::begin(range), std::end(range),
                       [&](const auto& a) { return std::invoke(of, a) == value; });
}
template <class Range>
auto adjacent_find(Range&& range) {
  return std::adjacent_find(std::begin(range), std::end(range));
}
template <class Range, class Value>
void replace(Range&& range, const Value& old, const Value& by) {
  std::replace(std::begin(range), std::end(range), old, by);
}
template <class Range>
void reverse(Range&& range) {
  std::reverse(std::begin(range), std::end(range));
}
template <class Range, class To, class Make>
auto transform(Range&& range, To to, Make make) {
  return std::transform(std::begin(range), std::end(range), to,
                        [&](const auto& a) { return std::invoke(make, a); });
}

}  // namespace ranges

// strtod() also takes blanks, a plus and hexadecimal digits.
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const string text(first, last);
  if (text.find_first_of(" \t\n\v\f\r+xX") == 0 || text.find_first_of("xX") != string::npos) {
    return {first, errc::invalid_argument};
  }
  char* end = nullptr;
  value = strtod(text.c_str(), &end);
  return {first + (end - text.c_str()), end == text.c_str() ? errc::invalid_argument : errc()};
}

template <class To, class From>
constexpr To bit_cast(const From& from) {
  return __builtin_bit_cast(To, from);
}

template <class T>
class atomic_ref {
 public:
  explicit atomic_ref(T& value) : value_(&value) {}
  T load(memory_order) const { return *value_; }
  void store(T value, memory_order) const { *value_ = value; }
  void fetch_or(T by, memory_order) const { *value_ |= by; }
  bool compare_exchange_weak(const T&, T value, memory_order) const {
    *value_ = value;
    return true;
  }

 private:
  T* value_;
};

}  // namespace std
#endif
