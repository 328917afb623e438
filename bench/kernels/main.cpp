// The program ar3d_kernels. Without a filter it runs a selection of some ten seconds; everything
// else is reached by --benchmark_filter (REGEX; '.' is all, --benchmark_list_tests shows names).

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <vector>

#include "inputs.h"

namespace {

char default_filter[] =
    "--benchmark_filter=^(generate|(draw|certify|parse)/[^/]+)/random-(cubic|4-regular)/10000/";
char default_min_time[] = "--benchmark_min_time=0.05";

/// The user's arguments after the defaults, so that theirs win.
std::vector<char*> with_defaults(int argc, char** argv) {
  std::vector<char*> arguments = {argv[0]};
  if (std::getenv("BENCHMARK_FILTER") == nullptr) arguments.push_back(default_filter);
  if (std::getenv("BENCHMARK_MIN_TIME") == nullptr) arguments.push_back(default_min_time);
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  return arguments;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<char*> arguments = with_defaults(argc, argv);
  int count = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  ar3d::kernels::register_catalogues();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
