// The only file that knows MPI. Rank 0 gives out the tickets: a thread of its own answers requests
// while the others make rows. All waiting is by looking every now and then: MPI's own waiting keeps
// a core busy, which rank 0's timed rows would feel.

#define OMPI_SKIP_MPICXX 1
#include <mpi.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>
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

constexpr int kRequestTag = 1;
constexpr int kAnswerTag = 2;
constexpr int kJobTag = 3;     // rank 0: what to make ready; nothing: go home
constexpr int kReadyTag = 4;   // another rank: it is
constexpr int kGoTag = 5;      // rank 0: all are
constexpr int kDoneTag = 6;    // another rank: it has done it
constexpr int kToldTag = 7;    // another rank: what came out, or why it failed
constexpr int kResultTag = 8;  // another rank, after it: which of the two

// What a rank tells rank 0 with kRequestTag: that it wants a portion, or that it wants no more.
constexpr int kMore = 0;
constexpr int kDone = 1;

// Tickets [begin, end); empty: there are no more.
struct Portion {
  std::uint64_t begin = 0;
  std::uint64_t end = 0;
};

// The time between two looks for something that may come soon or late: the longer nothing has come,
// the longer, so that looking takes next to nothing from whoever computes on this core.
class Patience {
 public:
  void pause() const {
    constexpr Clock::duration kShortest = std::chrono::microseconds(200);
    constexpr Clock::duration kLongest = std::chrono::milliseconds(5);
    std::this_thread::sleep_for(std::clamp((Clock::now() - since_) / 16, kShortest, kLongest));
  }
  void renew() { since_ = Clock::now(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point since_ = Clock::now();
};

void wait_quietly(MPI_Request& request) {
  const Patience patience;
  int done = 0;
  while (MPI_Test(&request, &done, MPI_STATUS_IGNORE), done == 0) patience.pause();
}

// Deals tickets in portions that are a share of the work that is left: large at first, single
// ones at the end.
class PortionDealer {
 public:
  PortionDealer(const std::vector<double>& work, int shares)
      : work_(work), left_(std::accumulate(work.begin(), work.end(), 0.0)), shares_(shares) {}

  Portion take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    const double most = left_ / shares_;
    Portion portion{next_, next_};
    double taken = 0;
    while (portion.end < work_.size() &&
           (portion.end == portion.begin || taken + work_[portion.end] <= most)) {
      taken += work_[portion.end++];
    }
    next_ = portion.end;
    left_ -= taken;
    return portion;
  }

 private:
  const std::vector<double>& work_;
  std::mutex mutex_;
  std::uint64_t next_ = 0;
  double left_;
  int shares_;
};

// A rank's tickets: one after the other from portions. The next portion is asked for in the middle
// of one, so that nobody waits for the answer; not of a short one, since then the work nears its
// end, and a ticket that waits here might be made by a rank that has nothing left.
class Portions {
 public:
  // `ask_for` asks for a portion, `receive` waits for it.
  Portions(std::function<void()> ask_for, std::function<Portion()> receive)
      : ask_for_(std::move(ask_for)), receive_(std::move(receive)) {}
  ~Portions() {
    if (asked_) receive_();
  }

  std::optional<std::size_t> next() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (portion_.begin == portion_.end && !over_) refill();
    if (over_) return std::nullopt;
    const std::uint64_t ticket = portion_.begin++;
    if (ticket == ask_at_) ask();
    return ticket;
  }

 private:
  static constexpr std::uint64_t kShort = 4;

  void ask() {
    ask_for_();
    asked_ = true;
  }
  void refill() {
    if (!asked_) ask();
    portion_ = receive_();
    asked_ = false;
    over_ = portion_.begin == portion_.end;
    const std::uint64_t size = portion_.end - portion_.begin;
    ask_at_ = size < kShort ? portion_.end : portion_.begin + size / 2;
  }

  std::function<void()> ask_for_;
  std::function<Portion()> receive_;
  std::mutex mutex_;
  Portion portion_;
  std::uint64_t ask_at_ = 0;  // the ticket with which to ask; the portion's end: none
  bool asked_ = false;
  bool over_ = false;
};

// Rank 0: answers the other ranks until all of them are done, or it has failed itself.
void serve(PortionDealer& dealer, int others, const std::atomic<bool>& failed) {
  Patience patience;
  while (others > 0 && !failed) {
    int waiting = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, kRequestTag, MPI_COMM_WORLD, &waiting, &status);
    if (waiting == 0) {
      patience.pause();
      continue;
    }
    patience.renew();
    int request = kDone;
    MPI_Recv(&request, 1, MPI_INT, status.MPI_SOURCE, kRequestTag, MPI_COMM_WORLD,
             MPI_STATUS_IGNORE);
    if (request == kDone) {
      --others;
      continue;
    }
    const Portion portion = dealer.take();
    const std::array<std::uint64_t, 2> answer = {portion.begin, portion.end};
    MPI_Send(answer.data(), 2, MPI_UINT64_T, status.MPI_SOURCE, kAnswerTag, MPI_COMM_WORLD);
  }
}

void send_text(const std::string& text, int to, int tag) {
  MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, to, tag, MPI_COMM_WORLD);
}

std::string receive_text(int from, int tag) {
  const Patience patience;
  MPI_Status status;
  int there = 0;
  while (MPI_Iprobe(from, tag, MPI_COMM_WORLD, &there, &status), there == 0) patience.pause();
  int size = 0;
  MPI_Get_count(&status, MPI_CHAR, &size);
  std::string text(static_cast<std::size_t>(size), '\0');
  MPI_Recv(text.data(), size, MPI_CHAR, from, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return text;
}

using Tell = std::function<std::string()>;

Tell what_failed() {
  return [failure = std::current_exception()]() -> std::string { std::rethrow_exception(failure); };
}

// Puts into `text` what is told, or why it failed.
StepResult told_by(const Tell& tell, std::string& text) {
  try {
    text = tell();
    if (text.size() > std::numeric_limits<int>::max()) {
      throw InternalError("internal error: a rank's rows pass 2 GiB, the most that MPI sends");
    }
    return StepResult::done;
  } catch (const std::exception& error) {
    text = error.what();
    return StepResult::failed;
  }
}

// A job that was made ready, or that tells why it could not be.
Work made_ready(const MakeReady& make_ready, const std::string& job) {
  try {
    return make_ready(job);
  } catch (...) {
    return {[] {}, what_failed()};
  }
}

// Does a job; what is to be told of it.
Tell done(const Work& work) {
  try {
    work.run();
    return work.tell;
  } catch (...) {
    return what_failed();
  }
}

void send_word(int to, int tag) { MPI_Send(nullptr, 0, MPI_CHAR, to, tag, MPI_COMM_WORLD); }

// Not by looking every now and then: for what is timed.
void receive_word(int from, int tag) {
  MPI_Recv(nullptr, 0, MPI_CHAR, from, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
}

void send_result(StepResult result, int to) {
  const int code = static_cast<int>(result);
  MPI_Send(&code, 1, MPI_INT, to, kResultTag, MPI_COMM_WORLD);
}

StepResult receive_result(int from) {
  int code = 0;
  MPI_Recv(&code, 1, MPI_INT, from, kResultTag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return static_cast<StepResult>(code);
}

class MpiRanks final : public Ranks {
 public:
  MpiRanks() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    if (provided < MPI_THREAD_SERIALIZED) MPI_Abort(MPI_COMM_WORLD, 1);
  }
  ~MpiRanks() override { MPI_Finalize(); }

  int rank() const override { return rank_; }
  int size() const override { return size_; }

  std::string from_first(const std::string& text) override { return from(0, text); }

  StepResult agree(StepResult mine, std::string& why) override {
    const int candidate = mine == StepResult::done ? size_ : rank_;
    int first = size_;
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Iallreduce(&candidate, &first, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD, &request);
    wait_quietly(request);
    if (first == size_) return StepResult::done;
    why = from(first, why);
    int code = static_cast<int>(mine);
    MPI_Bcast(&code, 1, MPI_INT, first, MPI_COMM_WORLD);
    return static_cast<StepResult>(code);
  }

  void share_out(const std::vector<double>& work,
                 const std::function<void(const Tickets&)>& use) override {
    if (size_ == 1) return Ranks::share_out(work, use);
    std::exception_ptr failure;
    std::atomic<bool> failed = false;
    PortionDealer dealer(work, 4 * size_);
    std::thread server;
    if (is_first()) server = std::thread([&] { serve(dealer, size_ - 1, failed); });
    std::array<std::uint64_t, 2> answer{};
    MPI_Request pending = MPI_REQUEST_NULL;
    try {
      Portions portions(
          [&] {
            if (is_first()) return;
            MPI_Irecv(answer.data(), 2, MPI_UINT64_T, 0, kAnswerTag, MPI_COMM_WORLD, &pending);
            MPI_Send(&kMore, 1, MPI_INT, 0, kRequestTag, MPI_COMM_WORLD);
          },
          [&] {
            if (is_first()) return dealer.take();
            wait_quietly(pending);
            return Portion{answer[0], answer[1]};
          });
      use([&] { return portions.next(); });
    } catch (...) {
      failure = std::current_exception();
      failed = true;
    }
    if (is_first()) {
      server.join();
    } else {
      MPI_Send(&kDone, 1, MPI_INT, 0, kRequestTag, MPI_COMM_WORLD);
    }
    if (failure) std::rethrow_exception(failure);
  }

  DoneAtOnce at_once(int count, const std::string& job, const MakeReady& make_ready) override {
    for (int rank = 1; rank < count; ++rank) send_text(job, rank, kJobTag);
    const Work work = made_ready(make_ready, job);
    for (int rank = 1; rank < count; ++rank) receive_text(rank, kReadyTag);
    const Stopwatch time;
    for (int rank = 1; rank < count; ++rank) send_word(rank, kGoTag);
    const Tell tell = done(work);
    for (int rank = 1; rank < count; ++rank) receive_word(rank, kDoneTag);
    const double wall_s = time.wall_s();
    std::vector<std::string> told(1);
    std::vector<StepResult> results = {told_by(tell, told[0])};
    for (int rank = 1; rank < count; ++rank) {
      told.push_back(receive_text(rank, kToldTag));
      results.push_back(receive_result(rank));
    }
    for (std::size_t i = 0; i < told.size(); ++i) {  // after all have come: none is left over
      if (results[i] != StepResult::done) throw InternalError(told[i]);
    }
    return {wall_s, std::move(told)};
  }

  void help(const MakeReady& make_ready) override {
    for (std::string job = receive_text(0, kJobTag); !job.empty(); job = receive_text(0, kJobTag)) {
      const Work work = made_ready(make_ready, job);
      send_word(0, kReadyTag);
      receive_word(0, kGoTag);
      const Tell tell = done(work);
      send_word(0, kDoneTag);
      std::string text;
      const StepResult result = told_by(tell, text);
      send_text(text, 0, kToldTag);
      send_result(result, 0);
    }
  }

  void give_up(int exit_code) override {
    if (size_ > 1) MPI_Abort(MPI_COMM_WORLD, exit_code);
  }

  void dismiss() override {
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
