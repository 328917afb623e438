#pragma once

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>

namespace ar3d {

/// Tells people how far a study is: one line, rewritten in place on a terminal, a new line a
/// minute elsewhere. Not thread-safe.
class Progress {
 public:
  /// @param out  null: silent.  @param total_work  in any unit that is proportional to time.
  Progress(std::FILE* out, std::string name, std::size_t total_rows, double total_work);
  ~Progress() { finish(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void row_done(double work, bool ok);
  /// Ends the line on a terminal. Called once more by the destructor, then without effect.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  void print(Clock::time_point now);
  std::string line(double elapsed_s) const;

  std::FILE* out_ = nullptr;
  bool terminal_ = false;
  std::string name_;
  std::size_t total_rows_ = 0;
  double total_work_ = 0;
  std::size_t rows_ = 0;
  std::size_t not_ok_ = 0;
  double work_ = 0;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

}  // namespace ar3d
