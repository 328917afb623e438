// The raw tokenising of a format's text on one core (bytes_per_second), from memory, nothing kept:
// the floor under parse/F of catalogue_kernel.cpp.
//   tokenize/F  a file of numbers: a random cubic graph with n vertices (parameter)

#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>

#include "ar3d/formats/tokens.h"
#include "inputs.h"

namespace ar3d::kernels {
namespace {

void tokenize_numbers(benchmark::State& state, const GraphFormat* format) {
  const std::string& text =
      text_of(*format, find_family("random-cubic"), static_cast<std::uint64_t>(state.range(0)));
  for (auto _ : state) {
    TextInput input("memory", bytes_of(text));
    std::uint64_t sum = 0;
    while (const auto line = input.next_line()) {
      Tokens tokens(input, *line);
      while (!line->starts_with('%') && !tokens.done()) sum += tokens.number("a number");
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(text.size()) * state.iterations());
}

[[maybe_unused]] const bool kRegistered = [] {
  for (const char* name : {"matrixmarket", "metis"}) {
    benchmark::RegisterBenchmark((std::string("tokenize/") + name).c_str(), tokenize_numbers,
                                 &find_graph_format(name))
        ->Arg(1'000'000)
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace ar3d::kernels
