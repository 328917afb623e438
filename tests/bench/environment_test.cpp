#include "ar3d/bench/measure/environment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "ar3d/bench/measure/pinning.h"

namespace ar3d {
namespace {

using ::testing::HasSubstr;
using ::testing::MatchesRegex;

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

}  // namespace
}  // namespace ar3d
