// Records the machine, the build and the settings that influence speed. Of the environment only
// known variables are recorded.
#include "ar3d/bench/measure/environment.h"

#include <fmt/format.h>
#include <gnu/libc-version.h>
#include <sys/utsname.h>
#include <toml++/toml.h>
#include <xxhash.h>

#include <algorithm>
#include <boost/version.hpp>
#include <fstream>
#include <iterator>
#include <thread>

#include "ar3d/base/error.h"
#include "ar3d/base/system_calls.h"
#include "ar3d/bench/measure/cores.h"
#include "ar3d/bench/measure/instruments.h"
#include "ar3d/store/hdf5/results_file.h"
#include "ar3d_build_info.h"

namespace ar3d {
namespace {

constexpr const char* kAbsent = "absent";

std::string first_line(const std::string& path) {
  std::ifstream in(path);
  std::string line;
  return std::getline(in, line) ? line : kAbsent;
}

// "L1 Data 32K, L2 Unified 1024K, ..."
std::string caches() {
  std::string text;
  for (int index = 0; index < 8; ++index) {
    const std::string folder = fmt::format("/sys/devices/system/cpu/cpu0/cache/index{}/", index);
    const std::string size = first_line(folder + "size");
    if (size == kAbsent) break;
    text += fmt::format("{}L{} {} {}", text.empty() ? "" : ", ", first_line(folder + "level"),
                        first_line(folder + "type"), size);
  }
  return text.empty() ? kAbsent : text;
}

// "0,1,5": the cores that this process may run on.
std::string affinity() {
  const std::vector<int> cores = allowed_cores();
  return cores.empty() ? kAbsent : fmt::format("{}", fmt::join(cores, ","));
}

std::string kernel() {
  utsname name{};
  if (uname(&name) != 0) return kAbsent;
  return fmt::format("{} {} {}", name.sysname, name.release, name.machine);
}

// "no", or "yes" and what the virtual machine calls itself.
std::string virtualised() {
  const std::string flags = proc_value("/proc/cpuinfo", "flags");
  if (flags == kAbsent) return kAbsent;
  if (flags.find(" hypervisor") == std::string::npos) return "no";
  const std::string vendor = first_line("/sys/class/dmi/id/sys_vendor");
  return vendor == kAbsent ? "yes" : "yes, " + vendor;
}

// "on", "off" or absent.
std::string turbo() {
  const std::string boost = first_line("/sys/devices/system/cpu/cpufreq/boost");
  if (boost != kAbsent) return boost == "1" ? "on" : "off";
  const std::string none = first_line("/sys/devices/system/cpu/intel_pstate/no_turbo");
  return none == kAbsent ? kAbsent : none == "0" ? "on" : "off";
}

// Variables that steer OpenMP, the allocator and the linker, and where a batch system has put us;
// nothing else of the environment is recorded.
void add_variables(std::vector<EnvironmentEntry>& entries) {
  constexpr std::string_view kPrefixes[] = {"OMP_",
                                            "GOMP_",
                                            "KMP_",
                                            "MALLOC_",
                                            "GLIBC_",
                                            "LD_PRELOAD=",
                                            "SLURM_JOB_ID=",
                                            "SLURM_NTASKS=",
                                            "SLURM_CPUS_PER_TASK=",
                                            "SLURM_ARRAY_TASK_ID=",
                                            "OMPI_COMM_WORLD_SIZE=",
                                            "OMPI_COMM_WORLD_RANK="};
  for (char** variable = environ; variable != nullptr && *variable != nullptr; ++variable) {
    const std::string_view text(*variable);
    const bool listed = std::any_of(std::begin(kPrefixes), std::end(kPrefixes),
                                    [&](std::string_view p) { return text.starts_with(p); });
    const std::size_t equals = text.find('=');
    if (text == "GOMP_SPINCOUNT=20000") continue;  // what base/parallel.cpp sets
    if (!listed || equals == std::string_view::npos) continue;
    entries.push_back({std::string(text.substr(0, equals)), std::string(text.substr(equals + 1))});
  }
}

std::string dotted(unsigned major, unsigned minor, unsigned patch) {
  return fmt::format("{}.{}.{}", major, minor, patch);
}

void add_libraries(std::vector<EnvironmentEntry>& entries) {
  const unsigned xxhash = XXH_versionNumber();
  entries.push_back({"library_libc", gnu_get_libc_version()});
  entries.push_back({"library_hdf5", hdf5_version()});
  entries.push_back(
      {"library_fmt", dotted(FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)});
  entries.push_back({"library_boost", dotted(BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000,
                                             BOOST_VERSION % 100)});
  entries.push_back({"library_xxhash", dotted(xxhash / 10000, xxhash / 100 % 100, xxhash % 100)});
  entries.push_back(
      {"library_tomlplusplus", dotted(TOML_LIB_MAJOR, TOML_LIB_MINOR, TOML_LIB_PATCH)});
}

}  // namespace

std::string proc_value(const std::string& path, const std::string& key) {
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(key)) continue;
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos) continue;
    const std::size_t start = line.find_first_not_of(" \t", colon + 1);
    return start == std::string::npos ? "" : line.substr(start);
  }
  return kAbsent;
}

std::string source_hash() { return AR3D_SOURCE_HASH; }

bool source_is_dirty() { return AR3D_SOURCE_DIRTY != 0; }

std::string dirty_hash() { return AR3D_DIRTY_HASH; }

std::string load_average() {
  const std::string line = first_line("/proc/loadavg");
  std::size_t end = 0;
  for (int field = 0; field < 3 && end != std::string::npos; ++field) end = line.find(' ', end + 1);
  return line.substr(0, end);
}

const char* build_kind() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return "sanitised";
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
  return "sanitised";
#endif
#endif
#ifndef NDEBUG
  return "debug";
#else
  return "";
#endif
}

std::string build_summary() {
  const std::string kind = build_kind();
  return fmt::format("ar3d {} (commit {:.12}{}, {}, {}{}{})", AR3D_VERSION, AR3D_SOURCE_HASH,
                     source_is_dirty() ? ", modified" : "", AR3D_COMPILER, AR3D_BUILD_TYPE,
                     kind.empty() ? "" : ", ", kind);
}

std::vector<EnvironmentEntry> capture_environment(int threads) {
  std::vector<EnvironmentEntry> entries = {
      {"cpu", proc_value("/proc/cpuinfo", "model name")},
      {"cores", fmt::format("{}", std::thread::hardware_concurrency())},
      {"affinity", affinity()},
      {"siblings", first_line("/sys/devices/system/cpu/cpu0/topology/thread_siblings_list")},
      {"caches", caches()},
      {"governor", first_line("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor")},
      {"turbo", turbo()},
      {"huge_pages", first_line("/sys/kernel/mm/transparent_hugepage/enabled")},
      {"virtualised", virtualised()},
      {"memory", proc_value("/proc/meminfo", "MemTotal")},
      {"kernel", kernel()},
      {"compiler", AR3D_COMPILER},
      {"build_type", AR3D_BUILD_TYPE},
      {"flags", AR3D_FLAGS},
      {"invariant_checks", kHeavyChecks ? "heavy" : "light"},
      {"build_kind", *build_kind() == '\0' ? "none" : build_kind()},
      {"version", AR3D_VERSION},
      {"source_hash", AR3D_SOURCE_HASH},
      {"dirty_hash", source_is_dirty() ? dirty_hash() : "none"},
      {"openmp", fmt::format("{}", _OPENMP)},
      {"threads", fmt::format("{}", threads)},
      {"hardware_counters", HardwareCounters().availability()},
      {"load_before", load_average()},
  };
  if (quota_threads() < allowed_cores().size()) {
    entries.push_back({"cpu_quota", fmt::format("{} cores", quota_threads())});
  }
  add_libraries(entries);
  add_variables(entries);
  return entries;
}

}  // namespace ar3d
