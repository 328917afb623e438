// The program: its verbs, and what ends it with which exit code.
#include "ar3d/apps/program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/base/nearest_name.h"
#include "ar3d/base/printable.h"
#include "ar3d/base/system_calls.h"
#include "ar3d/bench/measure/environment.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/store/hdf5/results_file.h"
#include "commands.h"
#include "options.h"
#include "view.h"

namespace {

constexpr std::uint64_t kMostThreads = 1024;                     // as --threads
constexpr std::uint64_t kLeastStack = 64, kMostStack = 1 << 20;  // of a thread, in KiB

constexpr std::array<std::string_view, 8> kReadResults = {"check", "compare", "figures", "history",
                                                          "merge", "replay",  "report",  "resume"};

constexpr const char* kExamples = R"(Examples:
  ar3d study run quick
  ar3d generate random-cubic -n 1000 | ar3d draw - --algorithm grid | ar3d verify -
  nauty-geng -D4 7 | ar3d draw - --algorithm diamond | ar3d verify -

Exit codes: 0 pass, 1 internal error, 2 usage or bad input, 3 regression, 4 bound or certificate violated,
5 incomplete, 6 inconclusive, 7 times not judged, 130 interrupted.)";

/// The verb that the words lead to, sub-verbs of `study` included; the program without one.
const CLI::App& verb_in(const CLI::App& app) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  return chosen.empty() ? app : verb_in(*chosen.front());
}

/// "ar3d study run".
std::string command_of(const CLI::App& verb) {
  const CLI::App* const above = verb.get_parent();
  return above == nullptr ? verb.get_name() : command_of(*above) + " " + verb.get_name();
}

/// The nearest option or verb to a word that was not expected.
std::string nearest_word(const CLI::App& verb, const std::string& word) {
  std::vector<std::string> names;
  if (word.starts_with("--")) {
    for (const CLI::Option* option : verb.get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
  } else {
    for (const CLI::App* sub : verb.get_subcommands([](const CLI::App*) { return true; })) {
      names.push_back(sub->get_name());
    }
  }
  return ar3d::did_you_mean(word.substr(0, word.find('=')), {names.begin(), names.end()});
}

/// Is that the name of an algorithm's option, or of a family's parameter where --set is also called
/// --parameter?
bool is_setting(const CLI::App& verb, const CLI::Option& option, const std::string& name) {
  const auto has = [&](const std::vector<ar3d::SettingSpec>& settings) {
    return std::ranges::any_of(settings, [&](const auto& one) { return one.name == name; });
  };
  return (option.check_lname("set") && verb.get_option_no_throw("--algorithm") != nullptr &&
          std::ranges::any_of(ar3d::algorithms(), has, &ar3d::Algorithm::options)) ||
         (option.check_lname("parameter") &&
          std::ranges::any_of(ar3d::families(), has, &ar3d::Family::parameters));
}

/// "; did you mean '--set effort=2'?" for --effort 2 and --effort=2; else the nearest option.
/// @param words  the whole command line, which has `word`.
std::string meant_by(const CLI::App& verb, const std::vector<std::string>& words,
                     const std::string& word) {
  const std::size_t equals = std::min(word.find('='), word.size());
  const std::size_t begin = std::min(word.find_first_not_of('-'), equals);
  const std::string name = word.substr(begin, equals - begin);
  const auto at = std::ranges::find(words, word);
  const bool has_next = at != words.end() && at + 1 != words.end();
  const std::string value = equals < word.size() ? word.substr(equals + 1) : has_next ? at[1] : "…";
  for (const CLI::Option* option : verb.get_options()) {
    if (is_setting(verb, *option, name)) {
      return fmt::format("; did you mean '--{} {}={}'?", option->get_lnames().front(), name, value);
    }
  }
  return nearest_word(verb, word);
}

/// An option of the verb that stands before it.
bool is_option_of(const CLI::App& verb, const std::string& word) {
  const CLI::Option* const option = verb.get_option_no_throw(word);
  return option != nullptr && word.starts_with("--");
}

void print_usage(const CLI::App& app, const CLI::ParseError& error,
                 const std::vector<std::string>& words) {
  const CLI::App& verb = verb_in(app);
  const std::vector<std::string> rest = app.remaining(true);
  std::string message = error.what();
  if (!rest.empty()) {
    const std::string& word = rest.front();
    const bool is_verb = &verb == &app && !word.starts_with("-");
    message = fmt::format("{} '{}'{}", is_verb ? "unknown verb" : "not expected:", word,
                          is_option_of(verb, word)
                              ? fmt::format(" here; write '{} {}'", command_of(verb), word)
                              : meant_by(verb, words, word));
  }
  ar3d::print(stderr, "ar3d: {} (see {} --help)\n", ar3d::printable(message), command_of(verb));
}

/// `ar3d help`, `help VERB`, `help study run`: what --help behind the words says.
void add_help(CLI::App& app) {
  CLI::App* verb = app.add_subcommand("help", "Shows this, or what `ar3d VERB --help` does");
  const auto words = std::make_shared<std::vector<std::string>>();
  verb->add_option("VERB", *words, "a verb, or two words such as `study run`");
  verb->footer("Example: ar3d help draw");
  verb->callback([&app, words] {
    const CLI::App* asked = &app;
    for (const std::string& word : *words) {
      const auto found =
          asked->get_subcommands([&](const CLI::App* sub) { return sub->get_name() == word; });
      if (found.empty()) {
        throw ar3d::InputError(
            fmt::format("unknown verb '{}'{}", word, nearest_word(*asked, word)));
      }
      asked = found.front();
    }
    const std::string name = command_of(*asked);
    ar3d::print("{}", asked->get_formatter()->make_help(asked, name, CLI::AppFormatMode::Normal));
  });
}

/// Adds -q to every verb without its own, and --accept-changed to those that read results files. An empty list is no default to show, nor is -1, which
/// stands for what is found out.
void complete_verbs(CLI::App& app) {
  const std::vector<CLI::App*> verbs = app.get_subcommands([](CLI::App*) { return true; });
  if (verbs.empty() && app.get_name() != "help" && app.get_option_no_throw("-q") == nullptr) {
    app.add_flag("-q,--quiet", ar3d::is_quiet_output, "no progress or notes on standard error");
  }
  if (std::ranges::find(kReadResults, app.get_name()) != kReadResults.end()) {
    app.add_flag("--accept-changed", ar3d::accept_changed_results,
                 "also read results whose rows another program may have changed");
  }
  for (CLI::Option* option : app.get_options()) {
    const std::string shown = option->get_default_str();
    if (shown == "[]" || shown == "-1") option->default_str("");
    if (shown == "[-]") option->default_str("-");
  }
  for (CLI::App* verb : verbs) complete_verbs(*verb);
}

int run(int argc, char** argv) {
  CLI::App app{
      "Draws graphs of degree at most 3 and 4 in 3D with optimal angles; proves them right."};
  app.name("ar3d");
  app.set_version_flag("-V,--version", ar3d::build_summary());
  app.require_subcommand(1);
  app.footer(kExamples);
  app.option_defaults()->always_capture_default();
  int exit_code = ar3d::kPass;
  ar3d::is_quiet_output = ar3d::is_json_output = false;
  ar3d::accept_changed_results = false;
  ar3d::register_program_formats();
  using namespace ar3d;
  for (const auto add : {add_list, add_generate, add_draw, add_view, add_play, add_verify,
                         add_optimum, add_study, add_check, add_report, add_figures, add_compare,
                         add_history, add_replay, add_hunt, add_shrink}) {
    add(app, exit_code);
  }
  add_help(app);
  complete_verbs(app);
  if (argc == 1) {
    ar3d::print(stderr, "{}", app.help());
    return ar3d::kUsage;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    print_usage(app, error, {argv + 1, argv + argc});
    return ar3d::kUsage;
  }
  return exit_code;
}

// Mends what the starting program may have left: a standard descriptor that is closed
// would become the next file's, which then takes messages (it becomes one that neither reads nor
// writes); children that are not waited for; a file size limit is an error of the
// write, like a full disk.
void begin_process() {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(number, F_GETFD) >= 0 || errno != EBADF) continue;
    (void)!open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
  std::signal(SIGCHLD, SIG_DFL);
  std::signal(SIGXFSZ, SIG_IGN);
}

// OpenMP's library takes 2^32 threads as none, crashes on small stacks and ends the process where it
// gets no large ones.
void check_openmp() {
  const auto begin_of = [](const char* name) {
    const char* const text = std::getenv(name);
    return text == nullptr ? "" : text;
  };
  const char* at = begin_of("OMP_NUM_THREADS");
  for (char* end = nullptr; *at != '\0'; at = *end == '\0' ? end : end + 1) {  // one number a level
    if (const std::uint64_t threads = std::strtoull(at, &end, 10); threads > kMostThreads) {
      throw ar3d::InputError(fmt::format("OMP_NUM_THREADS asks for {} threads; {} are the most",
                                         std::string_view(at, static_cast<std::size_t>(end - at)),
                                         kMostThreads));
    }
  }
  at = begin_of("OMP_STACKSIZE");
  char* unit = nullptr;
  const std::uint64_t size = std::strtoull(at, &unit, 10);
  if (unit == at) return;  // it is none, which OpenMP says
  unit += std::strspn(unit, " \t");
  const std::uint64_t kibibyte = *unit == 'b' || *unit == 'B' ? 1024 : 1;  // of its units
  const std::uint64_t scale = *unit == 'm' || *unit == 'M'   ? 1 << 10
                              : *unit == 'g' || *unit == 'G' ? 1 << 20
                                                             : 1;
  if (size > kMostStack * kibibyte / scale || size * scale / kibibyte < kLeastStack) {
    throw ar3d::InputError(fmt::format("OMP_STACKSIZE is {}; 64k to 1G are possible", at));
  }
}

// A verdict that cannot be read is none: standard output that could not take all of it (a full
// disk) is an error of every verb.
int with_output_flushed(int exit_code) {
  errno = 0;
  const bool flushed = std::fflush(stdout) == 0;
  if (flushed && std::ferror(stdout) == 0) return exit_code;
  ar3d::print(stderr, "ar3d: cannot write to standard output: {}\n",
              std::strerror(errno != 0 ? errno : EIO));
  return ar3d::kUsage;
}

}  // namespace

int ar3d::run_program(int argc, char** argv) {
  begin_process();
  try {
    check_openmp();
    ar3d::respect_quota();
    ar3d::note_on_results = [](const std::string& text) {
      static std::set<std::string> seen;
      if (seen.insert(text).second) ar3d::log_notes({text});
    };
    return with_output_flushed(run(argc, argv));
  } catch (const ar3d::InputError& error) {
    ar3d::print(stderr, "ar3d: {}\n", ar3d::printable(error.what()));
    return ar3d::kUsage;
  } catch (const std::system_error& error) {
    const bool is_output = std::ferror(stdout) != 0;
    const bool is_thread = error.code() == std::errc::resource_unavailable_try_again;
    ar3d::print(stderr, "ar3d: {}{}\n",
                is_output   ? "cannot write to standard output: "
                : is_thread ? "cannot start a thread: "
                            : "",
                is_output ? error.code().message() : error.what());
    return is_output || is_thread ? ar3d::kUsage : ar3d::kInternalError;
  } catch (const std::bad_alloc&) {
    ar3d::print(stderr, "ar3d: out of memory\n");
    return ar3d::kInternalError;
  } catch (const std::exception& error) {
    ar3d::print(stderr, "ar3d: {}\n", ar3d::printable(error.what()));
    return ar3d::kInternalError;
  }
}
