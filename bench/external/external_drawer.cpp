#include "ar3d/bench/external/external_drawer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <utility>

#include "ar3d/base/error.h"

namespace ar3d {
namespace {

// An answer has about 100 bytes per vertex and bend; this is room for drawings with many bends.
std::size_t most_bytes(const Graph& graph) {
  constexpr std::size_t kAlways = std::size_t{1} << 24;
  constexpr std::size_t kEach = std::size_t{1} << 10;
  return kAlways + kEach * (std::size_t{graph.num_vertices()} + graph.num_edges());
}

// A line that comes late would be taken for the answer to the next graph; a program that writes
// such lines does so from the beginning.
constexpr double kListeningSeconds = 0.02;

ProgramAnswer parsed(const std::string& name, const Graph& graph, const std::string& line) {
  try {
    return parse_answer(name, graph, line);
  } catch (const InputError& error) {
    throw ProgramFailure(RunStatus::crashed,
                         fmt::format("its answer is no drawing: {}", error.what()));
  }
}

}  // namespace

ExternalDrawing ExternalDrawer::draw(const ExternalAlgorithm& algorithm, const Settings& options,
                                     const Graph& graph) {
  const std::vector<std::string> command = command_with(algorithm, options);
  const std::string key = fmt::format("{}", fmt::join(command, "\n"));
  std::unique_ptr<ExternalProcess> process = std::move(processes_[key]);
  const bool is_new = !process;
  if (is_new) {
    process = std::make_unique<ExternalProcess>(command);
    if (!algorithm.one_graph_per_process) {
      const Graph edge(2, {{0, 1}});
      process->ask(request_of(algorithm, edge), algorithm.limit_s(2), most_bytes(edge));
      process->refuse_second_lines(kListeningSeconds);
    }
  }
  const ExternalProcess::Answer answer = process->ask(
      request_of(algorithm, graph), algorithm.limit_s(graph.num_vertices()), most_bytes(graph));
  if (is_new && !algorithm.one_graph_per_process) process->refuse_second_lines(kListeningSeconds);
  ProgramAnswer read = parsed(algorithm.row.name, graph, answer.line);
  if (!algorithm.one_graph_per_process) processes_[key] = std::move(process);
  if (!read.drawing) throw InputError(fmt::format("{}: {}", algorithm.row.name, read.refusal));
  return {std::move(*read.drawing), answer.wall_s,
          std::isnan(read.own_s) ? answer.cpu_s : read.own_s};
}

}  // namespace ar3d
