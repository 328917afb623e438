// Two programs run the same study in turns, on one core. A machine that becomes slower then slows
// both, and each round is a pair of measurements.
#include "ar3d/bench/compare/interleave.h"

#include <csignal>
#include <filesystem>
#include <fstream>

#include "ar3d/base/say.h"
#include "ar3d/bench/measure/cores.h"
#include "ar3d/bench/measure/instruments.h"
#include "ar3d/bench/measure/processes.h"

namespace ar3d {
namespace {

namespace fs = std::filesystem;

constexpr int kInterruptedCode = 130;
constexpr std::int64_t kTimedRepetitions = 5;  // of one run at most; the smallest time counts

std::string last_line(const fs::path& path) {
  std::ifstream file(path);
  std::string last;
  for (std::string line; std::getline(file, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

/// The two programs, the study and their results, in a folder of its own.
class Arena {
 public:
  Arena(const std::string& base_program, const std::string& new_program, const StudySpec& spec,
        const std::string& folder)
      : root_(fs::path(folder) / fmt::format("run-{}", getpid())) {
    for (const auto& [side, program] :
         {std::pair{kBase, &base_program}, std::pair{kNew, &new_program}}) {
      fs::create_directories(root_ / side);
      fs::copy_file(*program, root_ / side / "ar3d", fs::copy_options::overwrite_existing);
    }
    std::ofstream(root_ / "study.toml", std::ios::binary)
        << text_of_a_turn(spec, kTimedRepetitions);
  }
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;
  ~Arena() {
    std::error_code ignored;
    fs::remove_all(root_, ignored);
  }

  static constexpr const char* kBase = "base";
  static constexpr const char* kNew = "next";  // as long as "base"

  /// Runs the study once. @return false if it was interrupted.
  bool run(const char* side, std::size_t round, int core, const InterleaveOptions& options,
           std::vector<Results>& into) {
    const fs::path results = root_ / fmt::format("{}-{}.h5", side, round), log = root_ / "log";
    const std::string program = (root_ / side / "ar3d").string();
    std::vector<std::vector<std::string>> commands = {{program, "study", "run",
                                                       (root_ / "study.toml").string(), "--threads",
                                                       "1", "--quiet", "-o", results.string()}};
    if (options.count && round == 0) {
      commands.push_back({program, "study", "count", results.string()});
    }
    for (const std::vector<std::string>& command : commands) {
      const int code =
          run_child(command, {.output = log.string(), .core = core, .ends_when_interrupted = true});
      if (is_interrupted() || code == kInterruptedCode || code == 128 + SIGINT) return false;
      if (code != 0 && code != 4 && code != 5) {  // verdicts on the rows, which are there
        throw InputError(fmt::format("round {}: the {} program ended with code {}: {}", round, side,
                                     code, last_line(log)));
      }
    }
    into.push_back(read_results(results.string()));
    fs::remove(results);
    return true;
  }

 private:
  fs::path root_;
};

}  // namespace

InterleavedRounds run_interleaved(const std::string& base_program, const std::string& new_program,
                                  const StudySpec& spec, const std::string& folder,
                                  const InterleaveOptions& options) {
  Arena arena(base_program, new_program, spec, folder);
  const int core = options.core >= 0 ? options.core : allowed_cores().back();
  const Stopwatch stopwatch;
  InterleavedRounds rounds;
  for (std::size_t round = 0; round < options.rounds; ++round) {
    const auto base = [&] { return arena.run(Arena::kBase, round, core, options, rounds.base); };
    const auto now = [&] { return arena.run(Arena::kNew, round, core, options, rounds.now); };
    rounds.interrupted = round % 2 == 0 ? !(base() && now()) : !(now() && base());
    if (rounds.interrupted) break;
    if (options.progress != nullptr) {
      const double left = static_cast<double>(options.rounds - round - 1) * stopwatch.wall_s() /
                          static_cast<double>(round + 1);
      say(options.progress, "round {} of {}, about {:.0f} s left\n", round + 1, options.rounds,
          left);
    }
  }
  return rounds;
}

}  // namespace ar3d
