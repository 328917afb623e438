// The only file that knows MPI. Ranks make rows without a word to each other; they meet between the
// steps of a study, and for batches. Waiting is by looking every now and then: MPI's own waiting
// keeps a core busy, which rank 0's timed rows would feel.

#define OMPI_SKIP_MPICXX 1
#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <thread>

#include "ar3d/base/error.h"
#include "ar3d/bench/run/ranks.h"

#ifdef __SANITIZE_ADDRESS__
// OpenMPI's plugins never free their tables and are unloaded before leaks are looked for, so no
// suppression can name them. The same program without MPI is searched for leaks.
extern "C" const char* __asan_default_options() { return "detect_leaks=0"; }
#endif

namespace ar3d {
namespace {

constexpr int kJobTag = 1;                  // rank 0: the job to prepare; empty: stop
constexpr int kReadyTag = 2;                // another rank: it is prepared
constexpr int kGoTag = 3;                   // rank 0: all are prepared
constexpr int kDoneTag = 4;                 // another rank: the job is done
constexpr int kResultTag = 5;               // another rank: the result, or why it failed
constexpr char kDone = '+', kFailed = '-';  // before it

// The time between two looks for something that may come soon or late: the longer nothing has come,
// the longer, so that looking takes next to nothing from what computes on this core.
void pause(const Stopwatch& waiting) {
  const std::chrono::duration<double> pause(std::clamp(waiting.seconds() / 16, 200e-6, 5e-3));
  std::this_thread::sleep_for(pause);
}

void wait_quietly(MPI_Request& request) {
  const Stopwatch waiting;
  int done = 0;
  while (MPI_Test(&request, &done, MPI_STATUS_IGNORE), done == 0) pause(waiting);
}

void send_text(const std::string& text, int to, int tag) {
  MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, to, tag, MPI_COMM_WORLD);
}

std::string receive_text(int from, int tag) {
  const Stopwatch waiting;
  MPI_Status status;
  int there = 0;
  while (MPI_Iprobe(from, tag, MPI_COMM_WORLD, &there, &status), there == 0) pause(waiting);
  int size = 0;
  MPI_Get_count(&status, MPI_CHAR, &size);
  std::string text(static_cast<std::size_t>(size), '\0');
  MPI_Recv(text.data(), size, MPI_CHAR, from, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return text;
}

GetResult what_failed() {
  return [failure = std::current_exception()]() -> std::string { std::rethrow_exception(failure); };
}

// The result, or kFailed and why it failed.
std::string result_of(const GetResult& get_result) {
  try {
    std::string text = kDone + get_result();
    if (text.size() > std::numeric_limits<int>::max()) {
      throw InternalError("internal error: a rank's rows pass 2 GiB, the most that MPI sends");
    }
    return text;
  } catch (const std::exception& error) {
    return kFailed + std::string(error.what());
  }
}

// A prepared job, or one that reports why it could not be prepared.
std::function<GetResult()> made_ready(const MakeReady& make_ready, const std::string& job) {
  try {
    return make_ready(job);
  } catch (...) {
    return [failed = what_failed()] { return failed; };
  }
}

// Does a job. Returns how its result is reported.
GetResult done(const std::function<GetResult()>& work) {
  try {
    return work();
  } catch (...) {
    return what_failed();
  }
}

void send_word(int to, int tag) { MPI_Send(nullptr, 0, MPI_CHAR, to, tag, MPI_COMM_WORLD); }

// Not by looking every now and then: for what is timed.
void receive_word(int from, int tag) {
  MPI_Recv(nullptr, 0, MPI_CHAR, from, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
}

class MpiRanks final : public Ranks {
 public:
  MpiRanks() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    if (provided < MPI_THREAD_FUNNELED) MPI_Abort(MPI_COMM_WORLD, 1);
  }
  ~MpiRanks() override { MPI_Finalize(); }

  int rank() const override { return rank_; }
  int size() const override { return size_; }

  std::string from_first(const std::string& text) override { return from(0, text); }

  std::string agree(const std::string& failure) override {
    const int candidate = failure.empty() ? size_ : rank_;
    int first = size_;
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Iallreduce(&candidate, &first, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD, &request);
    wait_quietly(request);
    return first == size_ ? "" : from(first, failure);
  }

  std::pair<double, std::vector<std::string>> at_once(int count, const std::string& job,
                                                      const MakeReady& make_ready) override {
    for (int rank = 1; rank < count; ++rank) send_text(job, rank, kJobTag);
    const auto work = made_ready(make_ready, job);
    for (int rank = 1; rank < count; ++rank) receive_text(rank, kReadyTag);
    const Stopwatch time;
    for (int rank = 1; rank < count; ++rank) send_word(rank, kGoTag);
    const GetResult get_result = done(work);
    for (int rank = 1; rank < count; ++rank) receive_word(rank, kDoneTag);
    const double wall_s = time.seconds();
    std::vector<std::string> texts = {result_of(get_result)};
    for (int rank = 1; rank < count; ++rank) texts.push_back(receive_text(rank, kResultTag));
    for (std::string& text : texts) {  // after all have come: none is left over
      if (text.front() == kFailed) throw InternalError(text.substr(1));
      text.erase(0, 1);
    }
    return {wall_s, std::move(texts)};
  }

  void serve(const MakeReady& make_ready) override {
    for (std::string job = receive_text(0, kJobTag); !job.empty(); job = receive_text(0, kJobTag)) {
      const auto work = made_ready(make_ready, job);
      send_word(0, kReadyTag);
      receive_word(0, kGoTag);
      const GetResult get_result = done(work);
      send_word(0, kDoneTag);
      send_text(result_of(get_result), 0, kResultTag);
    }
  }

  void abort_all(int exit_code) override {
    if (size_ > 1) MPI_Abort(MPI_COMM_WORLD, exit_code);
  }

  void stop_serving() override {
    for (int rank = 1; rank < size_; ++rank) send_text("", rank, kJobTag);
  }

 private:
  std::string from(int rank, std::string text) const {
    std::uint64_t size = text.size();
    MPI_Bcast(&size, 1, MPI_UINT64_T, rank, MPI_COMM_WORLD);
    text.resize(size);
    MPI_Bcast(text.data(), static_cast<int>(size), MPI_CHAR, rank, MPI_COMM_WORLD);
    return text;
  }

  int rank_ = 0;
  int size_ = 1;
};

}  // namespace

std::unique_ptr<Ranks> join_ranks() { return std::make_unique<MpiRanks>(); }

}  // namespace ar3d
