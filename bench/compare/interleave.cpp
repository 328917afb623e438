// Two programs run the same study in turns, on one core. A machine that becomes slower then slows
// both, and each round is a pair of measurements.
#include "ar3d/bench/compare/interleave.h"

#include <boost/scope_exit.hpp>
#include <csignal>
#include <fstream>

#include "ar3d/base/print.h"
#include "ar3d/bench/measure/cores.h"
#include "ar3d/bench/measure/instruments.h"
#include "ar3d/bench/measure/processes.h"

namespace ar3d {
namespace {

namespace fs = std::filesystem;

constexpr int kInterruptedCode = 130;
constexpr std::int64_t kTimedRepetitions = 5;  // of one run at most; the smallest time counts

constexpr const char* kBase = "base";
constexpr const char* kNew = "next";  // as long as "base"

/// Runs the study of a folder once with the program of one side. @return false if interrupted.
bool run_once(const fs::path& folder, const char* side, std::size_t round, int core,
              const InterleaveOptions& options, std::vector<Results>& into) {
  const fs::path results = folder / fmt::format("{}-{}.h5", side, round), log = folder / "log";
  const std::string program = (folder / side / "ar3d").string();
  std::vector<std::vector<std::string>> commands = {{program, "study", "run",
                                                     (folder / "study.toml").string(), "--threads",
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

}  // namespace

std::array<std::vector<Results>, 2> run_interleaved(const std::string& base_program,
                                                    const std::string& new_program,
                                                    const Study& study, const std::string& folder,
                                                    const InterleaveOptions& options) {
  const fs::path own = fs::path(folder) / fmt::format("run-{}", getpid());
  BOOST_SCOPE_EXIT_ALL(&) { remove_folder(own); };
  for (const auto& [side, program] :
       {std::pair{kBase, &base_program}, std::pair{kNew, &new_program}}) {
    fs::create_directories(own / side);
    fs::copy_file(*program, own / side / "ar3d", fs::copy_options::overwrite_existing);
  }
  std::ofstream(own / "study.toml", std::ios::binary) << text_of_a_turn(study, kTimedRepetitions);
  const int core = options.core >= 0 ? options.core : allowed_cores().back();
  const Stopwatch stopwatch;
  std::array<std::vector<Results>, 2> rounds;
  for (std::size_t round = 0; round < options.rounds; ++round) {
    const auto base = [&] { return run_once(own, kBase, round, core, options, rounds[0]); };
    const auto now = [&] { return run_once(own, kNew, round, core, options, rounds[1]); };
    if (round % 2 == 0 ? !(base() && now()) : !(now() && base())) break;
    if (options.progress != nullptr) {
      const double left = static_cast<double>(options.rounds - round - 1) * stopwatch.seconds() /
                          static_cast<double>(round + 1);
      print(options.progress, "round {} of {}, about {:.0f} s left\n", round + 1, options.rounds,
            left);
    }
  }
  return rounds;
}

}  // namespace ar3d
