#pragma once

namespace ar3d {

/// What another SIGINT or SIGTERM does once one has asked to stop.
enum class SecondSignal { ends_program, is_ignored };

/// While an object of this class lives, SIGINT and SIGTERM ask the program to stop instead of
/// ending it. One at a time; afterwards the signals do what they did before.
class Interruptible {
 public:
  explicit Interruptible(SecondSignal second = SecondSignal::ends_program);
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;
  ~Interruptible();

 private:
  void (*before_int_)(int);
  void (*before_term_)(int);
};

/// True once the living Interruptible was asked to stop. Safe in every thread.
bool is_interrupted();

}  // namespace ar3d
