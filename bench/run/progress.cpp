#include "ar3d/bench/run/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <utility>

namespace ar3d {
namespace {

std::string duration(double seconds) {
  const auto whole = std::llround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

}  // namespace

Progress::Progress(std::FILE* out, std::string name, std::size_t total_rows, double total_work)
    : out_(out),
      terminal_(out != nullptr && isatty(fileno(out)) == 1),
      name_(std::move(name)),
      total_rows_(total_rows),
      total_work_(total_work) {}

void Progress::row_done(double work, bool ok) {
  ++rows_;
  work_ += work;
  if (!ok) ++not_ok_;
  if (out_ == nullptr) return;
  const Clock::time_point now = Clock::now();
  const auto pause = terminal_ ? std::chrono::milliseconds(200) : std::chrono::milliseconds(60000);
  if (now - last_ >= pause) print(now);
}

void Progress::print(Clock::time_point now) {
  last_ = now;
  const std::string text = line(std::chrono::duration<double>(now - start_).count());
  std::fprintf(out_, terminal_ ? "\r%s\033[K" : "%s\n", text.c_str());
  std::fflush(out_);
}

std::string Progress::line(double elapsed_s) const {
  std::string text = fmt::format("study {}: {} of {} rows", name_, rows_, total_rows_);
  if (not_ok_ > 0) text += fmt::format(" ({} not ok)", not_ok_);
  text += ", " + duration(elapsed_s);
  if (rows_ < total_rows_ && work_ > 0) {
    text += fmt::format(", about {} left", duration(elapsed_s * (total_work_ - work_) / work_));
  }
  return text;
}

void Progress::finish() {
  if (out_ == nullptr) return;
  print(Clock::now());
  if (terminal_) std::fputc('\n', out_);
  out_ = nullptr;
}

}  // namespace ar3d
