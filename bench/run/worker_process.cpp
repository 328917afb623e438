// A forked process that makes rows for its parent. Every message carries a checksum, because an
// algorithm under test may write into descriptors that are not its own.
#include "ar3d/bench/run/worker_process.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <xxhash.h>

#include <cerrno>
#include <fstream>

#include "ar3d/base/error.h"
#include "ar3d/bench/measure/cores.h"
#include "ar3d/store/columns/run_columns.h"

namespace ar3d {
namespace {

constexpr char kBegun = 'b';
constexpr char kMade = 'm';

// Checksum, tag and record.
std::size_t message_size() { return sizeof(std::uint64_t) + 1 + run_record_size(); }

std::uint64_t checksum_of(const std::string& message) {
  return XXH3_64bits(message.data() + sizeof(std::uint64_t),
                     message_size() - sizeof(std::uint64_t));
}

// How many processes the kernel has killed for want of memory since it was started.
long long oom_kills() {
  std::ifstream in("/proc/vmstat");
  long long count = 0;
  for (std::string name; in >> name >> count;) {
    if (name == "oom_kill") return count;
  }
  return 0;
}

// Lets this process map at most so much more than now, for its lifetime.
class AddressSpaceLimit {
 public:
  explicit AddressSpaceLimit(const std::optional<double>& bytes) {
    if (!bytes || getrlimit(RLIMIT_AS, &before_) != 0) return;
    rlimit limit = before_;
    const double sum = address_space_bytes() + *bytes;
    if (sum < 9e18) limit.rlim_cur = std::min(limit.rlim_max, static_cast<rlim_t>(sum));
    set_ = setrlimit(RLIMIT_AS, &limit) == 0;
  }
  ~AddressSpaceLimit() {
    if (set_) setrlimit(RLIMIT_AS, &before_);
  }
  AddressSpaceLimit(const AddressSpaceLimit&) = delete;
  AddressSpaceLimit& operator=(const AddressSpaceLimit&) = delete;

 private:
  bool set_ = false;
  rlimit before_{};
};

std::vector<int> descriptors_of_graphs(const StudyPlan& plan) {
  std::vector<int> needed;
  for (const PlannedBlock& block : plan.instances.blocks()) {
    if (const auto& corpus = block.first.choice.corpus) {
      needed.push_back(corpus->graphs->descriptor());
    }
  }
  return needed;
}

// What a worker is told. It has the plan from its parent.
struct RowOrder {
  std::size_t place = 0;  // of the instance
  std::size_t run = 0;    // of its runs
  RowRequest request;
};
static_assert(std::is_trivially_copyable_v<RowOrder>);  // it is sent as it stands in memory

// Everything that a worker says.
class Message {
 public:
  bool send(int socket, char tag, const RunRecord& run) {
    bytes_[sizeof(std::uint64_t)] = tag;
    store_record(run, bytes_.data() + sizeof(std::uint64_t) + 1);
    const std::uint64_t checksum = checksum_of(bytes_);
    std::memcpy(bytes_.data(), &checksum, sizeof(checksum));
    return send_all(socket, bytes_);
  }

 private:
  std::string bytes_ = std::string(message_size(), '\0');
};

// Serves rows until the parent hangs up.
void serve(int socket, const StudyPlan& plan, const WorkerPool& pool, int core) {
  const Pinning pinning(core);
  RowMaker maker({.concurrency = pool.workers + pool.elsewhere,
                  .core = core,
                  .memory = MemoryScope::worker,
                  .certify_memory_bytes = plan.budget.certify_memory_bytes});
  PlannedInstance instance;
  std::optional<std::size_t> prepared;
  Message message;
  RowOrder order;
  while (receive_all(socket, bytes_in(order))) {
    const bool is_new = prepared != order.place;
    if (is_new) instance = plan.instances[order.place];
    const PlannedRun& planned = instance.runs.at(order.run);
    RunRecord run;
    {
      std::optional<double> limit;
      if (plan.budget.row_memory_bytes) limit = (*plan.budget.row_memory_bytes)(instance.n);
      const AddressSpaceLimit memory(limit);
      if (is_new) maker.prepare(instance);
      prepared = order.place;
      if (!message.send(socket, kBegun, maker.begun(planned))) return;
      run = maker.make_row(planned, order.request);
    }
    if (!message.send(socket, kMade, run)) return;
  }
}

}  // namespace

WorkerProcess::WorkerProcess(const StudyPlan& plan, const WorkerPool& pool, int core)
    : oom_kills_before_(oom_kills()) {
  run_record_size();  // so that the columns are made once, by the parent
  child_ = Child::forked({.kept = descriptors_of_graphs(plan)}, [&](int socket) {
    serve(socket, plan, pool, core);
    return 0;
  });
  fcntl(child_.socket(), F_SETFL, O_NONBLOCK);
}

bool WorkerProcess::send(const RowJob& job) {
  const auto run = static_cast<std::size_t>(job.run - job.instance->runs.data());
  RowOrder order{job.place, run, job.request};
  return send_all(child_.socket(),
                  bytes_in(order));  // far less than a socket's buffer: never waits
}

WorkerProcess::News WorkerProcess::read_news() {
  char bytes[4096];
  while (!hung_up_ && received_.size() < message_size()) {
    const ssize_t got = recv(child_.socket(), bytes, sizeof bytes, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0 && errno == EAGAIN) return News::none;
    hung_up_ = got <= 0;
    if (got > 0) received_.append(bytes, static_cast<std::size_t>(got));
  }
  if (received_.size() < message_size()) return News::is_gone;
  // An algorithm may write into descriptors that are not its own.
  std::uint64_t checksum = 0;
  std::memcpy(&checksum, received_.data(), sizeof(checksum));
  const char tag = received_[sizeof(checksum)];
  if (checksum != checksum_of(received_) || (tag != kBegun && tag != kMade)) return News::garbage;
  row_ = load_record(received_.data() + sizeof(checksum) + 1);
  const bool begun = tag == kBegun;
  received_.erase(0, message_size());
  return begun ? News::begun : News::made;
}

double WorkerProcess::cpu_s() const {
  const double seconds = child_.cpu_s();
  return std::isnan(seconds) ? std::numeric_limits<double>::max() : seconds;
}

WorkerEnd WorkerProcess::end() {
  const int status = child_.wait();
  if (WIFEXITED(status)) {
    return {RunStatus::crashed, fmt::format("exited with code {}", WEXITSTATUS(status))};
  }
  const int signal = WTERMSIG(status);
  if (signal == SIGKILL && oom_kills() > oom_kills_before_) {
    return {RunStatus::out_of_memory, "killed by the system for want of memory"};
  }
  return {RunStatus::crashed, fmt::format("killed by signal {} ({})", signal, strsignal(signal))};
}

}  // namespace ar3d
