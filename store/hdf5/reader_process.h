#pragma once

#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <string>

#include "ar3d/base/new_file.h"

namespace ar3d {

/// A child process that reads a file whose bytes may crash or hang who reads them, and answers
/// questions about it. It ends with this object, or with this process.
class ReaderProcess {
 public:
  /// Gives the answer to a question, in the child.
  using Answers = std::function<std::string(std::uint64_t question)>;

  /// @param path  of the file, for messages.
  /// @param file  stays open in the child, as no other but the standard ones does.
  /// @throws InputError if the system has no process or socket left.
  ReaderProcess(std::string path, const Descriptor& file, const Answers& answers);
  ~ReaderProcess();
  ReaderProcess(const ReaderProcess&) = delete;
  ReaderProcess& operator=(const ReaderProcess&) = delete;

  /// The answer, valid until the next question. @throws InputError with the message of what the
  /// child has thrown, or naming the file and how the child has ended: by a signal, or since it
  /// needed more than 20 s of CPU time.
  const std::string& ask(std::uint64_t question);

 private:
  [[noreturn]] void refuse();

  std::string path_;
  pid_t pid_ = -1;
  Descriptor socket_;
  std::string answer_;
};

}  // namespace ar3d
