#include "ar3d/bench/measure/interruption.h"

#include <atomic>
#include <csignal>

namespace ar3d {
namespace {

std::atomic<bool> g_is_interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);  // so that a signal handler may set it

void note(int) { g_is_interrupted = true; }

void note_first(int signal) {
  g_is_interrupted = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

Interruptible::Interruptible(SecondSignal second) {
  g_is_interrupted = false;
  const auto handler = second == SecondSignal::is_ignored ? note : note_first;
  before_int_ = std::signal(SIGINT, handler);
  before_term_ = std::signal(SIGTERM, handler);
}

Interruptible::~Interruptible() {
  std::signal(SIGINT, before_int_);
  std::signal(SIGTERM, before_term_);
  g_is_interrupted = false;
}

bool is_interrupted() { return g_is_interrupted; }

}  // namespace ar3d
