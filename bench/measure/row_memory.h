#pragma once

#include <cstdint>

namespace ar3d {

/// Whose peak memory a row can tell.
enum class MemoryScope {
  process,  ///< other rows are made at the same time: only the process's peak so far is known
  row,      ///< this row's own: the kernel's high-water mark is reset before it
  worker    ///< as row, in a process that does nothing else
};
const char* to_string(MemoryScope scope);

/// Resident memory of a row. The kernel keeps a high-water mark for the process; where no other row
/// is made beside, it is reset at will (Linux: "5" written to /proc/self/clear_refs), so that it
/// speaks of what came after. Where the kernel refuses that, the scope is `process`.
/// Cost of a call: about 1 us.
class RowMemory {
 public:
  /// To be constructed in the process that makes the rows.
  explicit RowMemory(MemoryScope scope);
  ~RowMemory();
  RowMemory(const RowMemory&) = delete;
  RowMemory& operator=(const RowMemory&) = delete;

  MemoryScope scope() const { return scope_; }

  /// Begins a row: gives what earlier rows have freed back to the system (if it is much), resets
  /// the mark. @return resident bytes now; -1 in scope process.
  std::int64_t begin_row();
  /// Forgets the peak so far; without effect in scope process.
  void restart();
  /// Largest resident size in bytes since the last restart or begin_row, or of the process so far.
  std::int64_t peak_bytes() const;

 private:
  MemoryScope scope_;
  int clear_refs_ = -1;     ///< descriptor of /proc/self/clear_refs
  std::int64_t floor_ = 0;  ///< getrusage gives at least this, whatever has been reset
  std::int64_t first_base_ = 0;
};

}  // namespace ar3d
