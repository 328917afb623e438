// Talks to a program that draws graphs: one request, one line of answer, a time limit. A process
// that fails is ended with all that it started, and the next graph gets a new one.
#include "ar3d/bench/external/external_drawer.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <pthread.h>
#include <sys/wait.h>

#include <boost/scope_exit.hpp>
#include <cerrno>

#include "ar3d/base/error.h"
#include "ar3d/base/printable.h"
#include "ar3d/bench/measure/instruments.h"

namespace ar3d {
namespace {

constexpr std::size_t kKeptErrors = 400;

std::string last_line(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  const std::size_t end = text.rfind('\n');
  return end == std::string::npos ? text : text.substr(end + 1);
}

// An answer has about 100 bytes per vertex and bend; this is room for drawings with many bends.
std::size_t most_bytes(const Graph& graph) {
  constexpr std::size_t kAlways = std::size_t{1} << 24;
  constexpr std::size_t kEach = std::size_t{1} << 10;
  return kAlways + kEach * (std::size_t{graph.num_vertices()} + graph.num_edges());
}

// A line that comes late would be taken for the answer to the next graph; a program that writes
// such lines does so from the beginning.
constexpr double kListeningSeconds = 0.02;

ProgramAnswer parsed(const ExternalAlgorithm& algorithm, const Graph& graph,
                     const std::string& line) {
  try {
    return parse_answer(algorithm.row.name, graph, line, algorithm.coordinates);
  } catch (const InputError& error) {
    throw ProgramFailure(RunStatus::crashed,
                         fmt::format("its answer is no drawing: {}", error.what()));
  }
}

}  // namespace

ExternalProcess::ExternalProcess(const std::vector<std::string>& command) try {
  auto in = new_pipe();
  auto out = new_pipe();
  auto err = new_pipe();
  child_ =
      Child::of_program(command, {.streams = {in.first.get(), out.second.get(), err.second.get()}});
  if (child_.run_error() != 0) {
    throw InputError(
        fmt::format("cannot run {}: {}", command[0], std::strerror(child_.run_error())));
  }
  input_ = std::move(in.second);
  output_ = std::move(out.first);
  errors_ = std::move(err.first);
  for (const Descriptor* end : {&input_, &output_, &errors_}) {
    fcntl(end->get(), F_SETFL, O_NONBLOCK);
  }
} catch (const InputError& error) {
  throw ProgramFailure(RunStatus::crashed, error.what());
}

std::string ExternalProcess::how_it_ended() {
  // Its output has ended; so will it, or else it is ended.
  for (int tries = 0; tries < 100 && !child_.has_ended(); ++tries) usleep(1000);
  std::string how = "closed its output";
  if (child_.has_ended()) {
    const int status = child_.wait();
    how = WIFEXITED(status) ? fmt::format("ended with code {}", WEXITSTATUS(status))
                            : fmt::format("was killed by signal {} ({})", WTERMSIG(status),
                                          strsignal(WTERMSIG(status)));
  }
  child_.kill();
  while (read_errors()) {
  }
  const std::string line = last_line(last_errors_);
  return how + " before it answered" + (line.empty() ? "" : ": " + printable(line));
}

bool ExternalProcess::read_output(std::size_t most_bytes) {
  std::array<char, 16384> bytes;
  const ssize_t got = read(output_.get(), bytes.data(), bytes.size());
  if (got < 0) return errno == EAGAIN || errno == EINTR;
  received_.append(bytes.data(), static_cast<std::size_t>(got));
  if (received_.size() > most_bytes + bytes.size()) {
    throw ProgramFailure(RunStatus::crashed,
                         fmt::format("answered more than {} bytes", most_bytes));
  }
  return got > 0;
}

// False where there is nothing more to be had now.
bool ExternalProcess::read_errors() {
  std::array<char, 4096> bytes;
  const ssize_t got = read(errors_.get(), bytes.data(), bytes.size());
  if (got <= 0) return got < 0 && errno == EINTR;
  last_errors_.append(bytes.data(), static_cast<std::size_t>(got));
  if (last_errors_.size() > 2 * kKeptErrors) {
    last_errors_.erase(0, last_errors_.size() - kKeptErrors);
  }
  return true;
}

void ExternalProcess::write_request(const std::string& request, std::size_t& written) {
  const ssize_t put = write(input_.get(), request.data() + written, request.size() - written);
  if (put >= 0) {
    written += static_cast<std::size_t>(put);
  } else if (errno != EAGAIN && errno != EINTR) {
    written = request.size();  // it reads no more: what it answers, or how it ends, will tell
  }
}

void ExternalProcess::refuse_second_lines(double wait_s) {
  pollfd event{output_.get(), POLLIN, 0};
  poll(&event, 1, static_cast<int>(std::ceil(1000 * wait_s)));
  std::array<char, 4096> bytes;
  const ssize_t got = read(output_.get(), bytes.data(), bytes.size());
  if (got > 0 || !received_.empty()) {
    throw ProgramFailure(RunStatus::crashed,
                         "answered more than one line to a graph, one of them after its answer");
  }
}

ExternalProcess::Answer ExternalProcess::ask(const std::string& request, double limit_s,
                                             std::size_t most_bytes) {
  // A pipe to a process that has gone raises SIGPIPE, which is not to end the study.
  sigset_t pipe{}, before{};
  sigemptyset(&pipe);
  sigaddset(&pipe, SIGPIPE);
  pthread_sigmask(SIG_BLOCK, &pipe, &before);
  BOOST_SCOPE_EXIT_ALL(&) {
    const timespec no_time{};
    while (sigtimedwait(&pipe, nullptr, &no_time) > 0) {
    }
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  };
  refuse_second_lines(0);
  const double cpu_before = child_.cpu_s();
  const Stopwatch time;
  std::size_t written = 0;
  for (;;) {
    const std::size_t end = received_.find('\n', searched_);
    searched_ = received_.size();
    if (end != std::string::npos) {
      searched_ = 0;
      Answer answer{received_.substr(0, end), time.seconds(), child_.cpu_s() - cpu_before};
      received_.erase(0, end + 1);
      return answer;
    }
    const double left_s = limit_s - time.seconds();
    if (left_s <= 0) {
      child_.kill();
      throw ProgramFailure(RunStatus::timeout, fmt::format("no answer within {:.6g} s", limit_s));
    }
    pollfd events[] = {{output_.get(), POLLIN, 0},
                       {errors_ended_ ? -1 : errors_.get(), POLLIN, 0},
                       {written < request.size() ? input_.get() : -1, POLLOUT, 0}};
    const int ready = poll(events, 3, static_cast<int>(std::ceil(1000 * std::min(left_s, 1.0))));
    if (ready == 0 && child_.has_ended()) {  // what it has started may hold its output open
      throw ProgramFailure(RunStatus::crashed, how_it_ended());
    }
    if (events[1].revents != 0 && !read_errors()) errors_ended_ = true;
    if (events[2].revents != 0) write_request(request, written);
    if (events[0].revents != 0 && !read_output(most_bytes)) {
      throw ProgramFailure(RunStatus::crashed, how_it_ended());
    }
  }
}

static thread_local ExternalDrawer* current_drawer = nullptr;

ExternalDrawer::ExternalDrawer() : before_(std::exchange(current_drawer, this)) {}
ExternalDrawer::~ExternalDrawer() { current_drawer = before_; }

Drawing ExternalDrawer::draw(const ExternalAlgorithm& algorithm, const Graph& graph,
                             const Settings& options) {
  std::optional<ExternalDrawer> of_one_drawing;
  if (current_drawer == nullptr) of_one_drawing.emplace();
  ExternalDrawer& drawer = *current_drawer;
  const std::vector<std::string> command = command_with(algorithm, options);
  const std::string key = fmt::format("{}", fmt::join(command, "\n"));
  std::unique_ptr<ExternalProcess> process = std::move(drawer.processes_[key]);
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
  ProgramAnswer read = parsed(algorithm, graph, answer.line);
  if (!algorithm.one_graph_per_process) drawer.processes_[key] = std::move(process);
  if (!read.drawing) throw InputError(fmt::format("{}: {}", algorithm.row.name, read.refusal));
  drawer.times_ = {"", answer.wall_s, std::isnan(read.own_s) ? answer.cpu_s : read.own_s};
  return std::move(*read.drawing);
}

}  // namespace ar3d
