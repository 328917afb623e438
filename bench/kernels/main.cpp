// The main function of ar3d_kernels and ar3d_limits. Without a filter they run a selection;
// everything else is reached by --benchmark_filter (REGEX; '.' is all, --benchmark_list_tests shows
// names).

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "ar3d/bench/measure/environment.h"
#include "inputs.h"

namespace {

/// The user's arguments after the defaults, so that theirs win, as do variables of the environment.
std::vector<std::string> with_defaults(int argc, char** argv) {
  std::vector<std::string> arguments = {argv[0]};
  for (const std::string default_argument : ar3d::kernels::default_arguments()) {
    std::string variable = default_argument.substr(2, default_argument.find('=') - 2);
    for (char& c : variable) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    if (std::getenv(variable.c_str()) == nullptr) arguments.push_back(default_argument);
  }
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  return arguments;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> arguments = with_defaults(argc, argv);
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  int count = static_cast<int>(pointers.size());
  pointers.push_back(nullptr);
  benchmark::Initialize(&count, pointers.data());
  if (benchmark::ReportUnrecognizedArguments(count, pointers.data())) return 2;
  benchmark::AddCustomContext("ar3d", ar3d::build_summary());
  ar3d::kernels::register_catalogues();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
