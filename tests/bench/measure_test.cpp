#include <sys/wait.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <map>
#include <new>
#include <stdexcept>
#include <string_view>

#include "ar3d/base/system_calls.h"
#include "ar3d/bench/measure/cores.h"
#include "ar3d/bench/measure/environment.h"
#include "ar3d/bench/measure/processes.h"
#include "support/test.h"

namespace ar3d::testing {
namespace {

std::map<std::string, std::string> environment() {
  std::map<std::string, std::string> values;
  for (const EnvironmentEntry& entry : capture_environment(2)) {
    EXPECT_TRUE(values.emplace(entry.name, entry.value).second) << entry.name << " twice";
    EXPECT_FALSE(entry.value.empty()) << entry.name;
  }
  return values;
}

TEST(Environment, DescribesMachineBuildAndSource) {
  const auto values = environment();
  for (const char* name : {"cpu",         "cores",        "affinity",
                           "siblings",    "caches",       "governor",
                           "turbo",       "huge_pages",   "virtualised",
                           "memory",      "kernel",       "compiler",
                           "build_type",  "flags",        "invariant_checks",
                           "build_kind",  "source_hash",  "dirty_hash",
                           "openmp",      "threads",      "hardware_counters",
                           "load_before", "library_libc", "library_hdf5"}) {
    EXPECT_TRUE(values.contains(name)) << name;
  }
  EXPECT_EQ(values.at("source_hash"), source_hash());
  EXPECT_EQ(build_summary(),
            "ar3d " + values.at("version") + " (commit " + source_hash().substr(0, 12) +
                (source_is_dirty() ? ", modified, " : ", ") + values.at("compiler") + ", " +
                values.at("build_type") + (*build_kind() == '\0' ? "" : ", ") + build_kind() + ")");
  EXPECT_THAT(values.at("flags"), HasSubstr("-std=c++20"));
  EXPECT_THAT(values.at("library_libc"), MatchesRegex("[0-9]+\\.[0-9]+"));
  EXPECT_EQ(values.at("dirty_hash").size(), source_is_dirty() ? 64u : 4u) << "SHA-256 or none";
  EXPECT_EQ(values.at("build_kind"), *build_kind() == '\0' ? std::string("none") : build_kind());
}

TEST(Environment, RecordsOnlyTheVariablesOfTheList) {
  setenv("OMP_PLACES", "cores", 1);
  setenv("SLURM_JOB_ID", "7", 1);
  setenv("AR3D_TEST_SECRET", "secret", 1);
  setenv("SLURM_JOB_ID_TOKEN", "secret", 1);
  const auto values = environment();
  for (const char* name : {"OMP_PLACES", "SLURM_JOB_ID", "AR3D_TEST_SECRET", "SLURM_JOB_ID_TOKEN"})
    unsetenv(name);
  EXPECT_EQ(values.at("OMP_PLACES"), "cores");
  EXPECT_EQ(values.at("SLURM_JOB_ID"), "7");
  for (const auto& [name, value] : values) EXPECT_NE(value, "secret") << name;
}

TEST(Environment, AffinityIsThatOfTheProcess) {
  const std::vector<int> before = allowed_cores();
  {
    const Pinning pinning(before.back());
    EXPECT_EQ(environment().at("affinity"), std::to_string(before.back()));
  }
  EXPECT_EQ(allowed_cores(), before) << "the pinning ends with its lifetime";
}

TEST(LimitedProcess, BringsBackWhatTheStepWroteAndTellsHowItEnded) {
  int value = 1;
  const auto end_of = [&](const std::function<void()>& step, std::optional<double> cpu_s = {},
                          double memory_bytes = 1e18) {
    return run_within(cpu_s, memory_bytes, bytes_in(value), step);
  };
  EXPECT_EQ(end_of([&] { value = 42; }), RunStatus::ok);
  EXPECT_EQ(value, 42);
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "no child is left";
  const auto forever = [&] {
    for (std::atomic<int> i = 0; i >= 0; i = (i + 1) & 7) value = i;
  };
  EXPECT_EQ(end_of(forever, 0.5), RunStatus::timeout);
  EXPECT_EQ(end_of([] { std::abort(); }), RunStatus::crashed);
  EXPECT_EQ(end_of([] { throw std::runtime_error("no"); }), RunStatus::crashed);
  if (std::string_view(build_kind()) == "sanitised") return;
  const auto large = [&] {
    std::vector<std::vector<char>> pieces;
    for (int i = 0; i < 64; ++i) pieces.emplace_back(std::size_t{16} << 20, 'x');
    value = static_cast<unsigned char>(pieces.back().back());
  };
  EXPECT_EQ(end_of(large, {}, 1e8), RunStatus::out_of_memory);
  EXPECT_EQ(end_of(large, {}, 4e9), RunStatus::ok);
}

TEST(ChildPrograms, AreEndedWithTheirGroupAtTheirLimit) {
  EXPECT_EQ(run_child({"sh", "-c", "sleep 7778; true"}, {.output = "/dev/null", .limit_s = 0.1}),
            128 + SIGKILL);
  EXPECT_EQ(run_child({"sh", "-c", "! pgrep -x -f 'sleep 7778'"}, {.output = "/dev/null"}), 0);
  EXPECT_EQ(run_child({"no-such-program"}, {.output = "/dev/null"}), 127);
}

int g_seen = 0;
void see(int) { ++g_seen; }

TEST(Interruption, IsNotedWhileSomebodyAsksAndForgottenAfterwards) {
  g_seen = 0;
  std::signal(SIGINT, see);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const Interruptible interruptible;
    EXPECT_FALSE(is_interrupted());
    std::raise(signal);
    EXPECT_TRUE(is_interrupted());
  }
  EXPECT_FALSE(is_interrupted());
  EXPECT_EQ(g_seen, 0);
  std::raise(SIGINT);  // does what it did before
  EXPECT_EQ(g_seen, 1);
  std::signal(SIGINT, SIG_DFL);
}

TEST(Interruption, ASecondSignalEndsTheProgramOrIsIgnored) {
  const auto interrupted_twice = [](bool ignores_second) {
    const Interruptible interruptible(ignores_second);
    std::raise(SIGTERM);
    std::raise(SIGTERM);
    std::exit(is_interrupted() ? 7 : 8);
  };
  EXPECT_EXIT(interrupted_twice(false), ::testing::KilledBySignal(SIGTERM), "");
  EXPECT_EXIT(interrupted_twice(true), ::testing::ExitedWithCode(7), "");
}

}  // namespace

}  // namespace ar3d::testing
