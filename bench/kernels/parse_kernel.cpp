// Reading throughput of the graph formats on one core (bytes_per_second of the text), from memory:
//   tokenize/F  the raw tokenising of a file of numbers or of six-bit characters, nothing kept
//   parse/F     the format's parser up to the finished Graph (rows built, parallel edges refused)
// The graph is a random cubic graph with n vertices (parameter), the same for all.

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "ar3d/formats/catalog.h"
#include "ar3d/formats/tokens.h"
#include "ar3d/generators/catalog.h"

namespace ar3d {
namespace {

const std::string& text_of(const GraphFormat& format, std::uint64_t n) {
  static std::string name;
  static std::uint64_t size = 0;
  static std::string text;
  if (name == format.name && size == n) return text;
  const std::string path =
      (std::filesystem::temp_directory_path() / ("ar3d-parse-kernel-" + std::to_string(getpid())))
          .string();
  write_graphs({generate(find_family("random-cubic"), n, 1)}, format, path);
  std::ostringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  std::filesystem::remove(path);
  name = format.name;
  size = n;
  text = content.str();
  return text;
}

void parse(benchmark::State& state, const GraphFormat* format) {
  const std::string& text = text_of(*format, static_cast<std::uint64_t>(state.range(0)));
  for (auto _ : state) {
    GraphReader reader(TextInput("memory", bytes_of(text)), {.format = format->name});
    benchmark::DoNotOptimize(reader.next());
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(text.size()) * state.iterations());
}

void tokenize_numbers(benchmark::State& state, const GraphFormat* format) {
  const std::string& text = text_of(*format, static_cast<std::uint64_t>(state.range(0)));
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
  for (const GraphFormat& format : graph_formats()) {
    if (format.name == "graph6") continue;  // n^2 bits
    benchmark::RegisterBenchmark(("parse/" + format.name).c_str(), parse, &format)
        ->Arg(format.name == "graphml" ? 10'000 : 1'000'000)
        ->Unit(benchmark::kMillisecond);
  }
  for (const char* name : {"matrixmarket", "metis"}) {
    benchmark::RegisterBenchmark((std::string("tokenize/") + name).c_str(), tokenize_numbers,
                                 &find_graph_format(name))
        ->Arg(1'000'000)
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace ar3d
