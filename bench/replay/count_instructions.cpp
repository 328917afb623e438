#include "ar3d/bench/replay/count_instructions.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/bench/measure/environment.h"
#include "ar3d/bench/replay/replay_row.h"
#include "ar3d/formats/catalog.h"
#include "ar3d/model/settings.h"

// A name without mangling that no optimiser may remove: callgrind counts from its entry to its end.
extern "C" __attribute__((noinline)) void ar3d_counted_drawing(
    const ar3d::Graph* graph, const ar3d::AlgorithmChoice* choice) {
  ar3d::draw(*choice->algorithm, *graph, choice->options);
  asm volatile("" : : : "memory");
}

namespace ar3d {
namespace {

constexpr std::string_view kFileFamily = "file:";
constexpr const char* kInstall = "sudo apt-get install valgrind";

// A file that is removed when it is no longer used.
class ScratchFile {
 public:
  ScratchFile() {
    const int descriptor = mkstemp(path_.data());
    if (descriptor < 0) {
      throw InputError(fmt::format("cannot create {}: {}", path_, std::strerror(errno)));
    }
    close(descriptor);
  }
  ~ScratchFile() { unlink(path_.c_str()); }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_ = (std::filesystem::temp_directory_path() / "ar3d-callgrind-XXXXXX").string();
};

std::string own_path() {
  char path[PATH_MAX + 1] = {};
  if (readlink("/proc/self/exe", path, PATH_MAX) < 0) {
    throw InputError(fmt::format("cannot read /proc/self/exe: {}", std::strerror(errno)));
  }
  return path;
}

std::vector<std::string> command_line(const RunRecord& row, const std::string& output) {
  return {"valgrind",
          "--tool=callgrind",
          "--callgrind-out-file=" + output,
          "--toggle-collect=ar3d_counted_drawing",
          "--quiet",
          own_path(),
          "study",
          kDrawOnceVerb,
          row.family,
          "parameters:" + row.parameters,
          std::to_string(row.requested_n),
          std::to_string(row.seed),
          row.algorithm,
          "options:" + row.options};
}

// Runs a program of $PATH with its output thrown away; its exit code.
int run_quietly(std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
  pid_t pid = -1;
  const int error =
      posix_spawnp(&pid, words[0].c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    throw InputError(
        fmt::format("cannot run {}: {} ({})", words[0], std::strerror(error), kInstall));
  }
  int status = 0;
  while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

// The total of a callgrind output file: its line "totals: N" or "summary: N".
std::int64_t total_of(const std::string& path) {
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    for (const std::string_view key : {"totals: ", "summary: "}) {
      if (line.starts_with(key)) return std::strtoll(line.c_str() + key.size(), nullptr, 10);
    }
  }
  return 0;
}

}  // namespace

void draw_for_counting(const RunRecord& row) {
  if (row.family.starts_with(kFileFamily)) {
    const Algorithm& algorithm = find_algorithm(row.algorithm);
    const AlgorithmChoice choice{&algorithm,
                                 complete_options(algorithm, parse_settings(row.options))};
    const Graph graph = read_graph(row.family.substr(kFileFamily.size()));
    return ar3d_counted_drawing(&graph, &choice);
  }
  const PlannedInstance instance = plan_of_row(row);
  const Graph graph = graph_of(instance);
  ar3d_counted_drawing(&graph, &instance.runs.front().choice);
}

std::int64_t count_instructions(const RunRecord& row, const StudyOrigin& origin) {
  if (std::string_view(build_kind()) == "sanitised") {
    throw InputError("a sanitised build cannot run under callgrind");
  }
  const ScratchFile output;
  const PlannedInstance instance = plan_of_row(row, origin);
  if (instance.runs.front().choice.program) {
    throw InputError(
        fmt::format("{} is a program of its own: nobody counts its instructions", row.algorithm));
  }
  std::optional<ScratchFile> graph;
  RunRecord drawn = row;
  if (instance.choice.corpus) {
    graph.emplace();
    write_graphs({graph_of(instance)}, find_graph_format("sparse6"), graph->path());
    drawn.family = std::string(kFileFamily) + graph->path();
  }
  const int exit_code = run_quietly(command_line(drawn, output.path()));
  const std::int64_t count = exit_code == 0 ? total_of(output.path()) : 0;
  if (count <= 0) {
    throw InputError(
        fmt::format("callgrind counted nothing for row {} (valgrind ended with code {})",
                    row.row_key, exit_code));
  }
  return count;
}

}  // namespace ar3d
