#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "ar3d/model/graph.h"

namespace ar3d {

/// Numbers 0, 1, ... of nodes with texts as ids, which must outlive this. Nearly all files number
/// their nodes: ids that are the first one's prefix and a number not far beyond how many there are
/// stand in an array, any others in a hash table. At most 64 bytes per node more than that.
class NodeIds {
 public:
  /// Gives the id the next number; false if it has one.
  bool add(std::string_view id) {
    if (size_ == 0) prefix_ = id.substr(0, id.find_last_not_of("0123456789") + 1);
    if (find(id)) return false;
    const auto next = static_cast<Vertex>(size_++);
    const auto number = number_of(id);
    if (!number || *number >= kSparse * (size_ + kFew)) {
      others_.emplace(id, next);
      return true;
    }
    if (*number >= numbered_.size()) numbered_.resize(*number + 1, kNone);
    numbered_[*number] = next;
    return true;
  }
  std::optional<Vertex> find(std::string_view id) const {
    const auto number = number_of(id);
    if (number && *number < numbered_.size() && numbered_[*number] != kNone) {
      return numbered_[*number];
    }
    if (others_.empty()) return std::nullopt;
    const auto found = others_.find(id);
    return found == others_.end() ? std::nullopt : std::optional(found->second);
  }
  std::size_t size() const { return size_; }

 private:
  static constexpr Vertex kNone = std::numeric_limits<Vertex>::max();
  static constexpr std::uint64_t kSparse = 8;
  static constexpr std::uint64_t kFew = 64;

  /// k if the id is the prefix and k as it is usually written; so different ids have different
  /// ones.
  std::optional<std::uint64_t> number_of(std::string_view id) const {
    // Not starts_with(), which calls two functions: prefixes are short.
    const auto end = std::mismatch(prefix_.begin(), prefix_.end(), id.begin(), id.end()).first;
    if (end != prefix_.end()) return std::nullopt;
    id.remove_prefix(prefix_.size());
    if (id.empty() || id.size() > 10 || (id[0] == '0' && id.size() > 1)) return std::nullopt;
    std::uint64_t number = 0;
    for (const char c : id) {
      if (c < '0' || c > '9') return std::nullopt;
      number = 10 * number + static_cast<std::uint64_t>(c - '0');
    }
    return number;
  }

  std::string_view prefix_;
  std::size_t size_ = 0;
  std::vector<Vertex> numbered_;
  std::unordered_map<std::string_view, Vertex> others_;
};

}  // namespace ar3d
