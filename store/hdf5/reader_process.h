#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "ar3d/base/new_file.h"
#include "ar3d/base/system_calls.h"

namespace ar3d {

/// Represents a child process that reads a file whose bytes may crash or hang who reads them, and
/// answers questions about it. It ends with this object, or with this process.
class ReaderProcess {
 public:
  /// Gives the answer to a question, in the child.
  using Answers = std::function<std::string(std::uint64_t question)>;

  /// @param path  of the file, for messages.
  /// @param file  stays open in the child, as no other but the standard ones does.
  /// @param limit_s  wall time of an answer.
  /// @throws InputError if the system has no process or socket left.
  ReaderProcess(std::string path, const Descriptor& file, const Answers& answers,
                double limit_s = 60);

  /// Returns the answer, valid until the next question. @throws InputError with the message of what
  /// the child has thrown, or naming the file and how the child has ended: by a signal, or since it
  /// needed more than 20 s of CPU time or the limit.
  const std::string& ask(std::uint64_t question);

 private:
  bool receive(std::span<char> bytes, double& left_s);
  [[noreturn]] void refuse(double left_s);

  std::string path_;
  double limit_s_;
  Child child_;
  std::string answer_;
};

}  // namespace ar3d
