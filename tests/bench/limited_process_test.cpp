#include "ar3d/bench/measure/limited_process.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "ar3d/bench/measure/environment.h"

namespace ar3d {
namespace {

StepEnd end_of(const StepLimits& limits, const std::function<void(int&)>& step, int& value) {
  return run_within(limits, {reinterpret_cast<char*>(&value), sizeof value}, [&] { step(value); });
}

TEST(LimitedProcess, BringsBackWhatTheStepWrote) {
  int value = 1;
  EXPECT_EQ(end_of(
                {}, [](int& to) { to = 42; }, value),
            StepEnd::done);
  EXPECT_EQ(value, 42);
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "no child is left";
}

TEST(LimitedProcess, TellsHowAStepEnded) {
  int value = 1;
  const auto forever = [](int& to) {
    for (std::atomic<int> i = 0; i >= 0; i = (i + 1) & 7) to = i;
  };
  EXPECT_EQ(end_of({.cpu_s = 0.5, .memory_bytes = {}}, forever, value), StepEnd::out_of_time);
  const auto crashes = [](int&) { std::abort(); };
  EXPECT_EQ(end_of({}, crashes, value), StepEnd::failed);
  const auto throws = [](int&) { throw std::runtime_error("no"); };
  EXPECT_EQ(end_of({}, throws, value), StepEnd::failed);
  if (std::string_view(build_kind()) == "sanitised") return;
  const auto large = [](int& to) {
    std::vector<std::vector<char>> pieces;
    for (int i = 0; i < 64; ++i) pieces.emplace_back(std::size_t{16} << 20, 'x');
    to = static_cast<unsigned char>(pieces.back().back());
  };
  EXPECT_EQ(end_of({.cpu_s = {}, .memory_bytes = 1e8}, large, value), StepEnd::out_of_memory);
  EXPECT_EQ(end_of({.cpu_s = {}, .memory_bytes = 4e9}, large, value), StepEnd::done);
}

}  // namespace
}  // namespace ar3d
