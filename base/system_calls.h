#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ar3d {

/// Bytes through a descriptor that waits, as many calls as it takes, signals or not.
/// @return how many. Where they are fewer than asked for, errno is the reason; 0 if the file or the
/// other side has ended.
/// Nothing written is EIO.
std::size_t write_whole(int descriptor, std::span<const char> bytes);
std::size_t write_whole(int descriptor, std::span<const char> bytes, std::uint64_t offset);
std::size_t read_whole(int descriptor, std::span<char> bytes, std::uint64_t offset);

/// The same through a socket. False if the other side is gone.
bool send_all(int socket, std::span<const char> bytes);
bool receive_all(int socket, std::span<char> bytes);

/// The bytes of a plain value, to be sent or received.
template <class Value>
std::span<char> bytes_in(Value& value) {
  return {reinterpret_cast<char*>(&value), sizeof(value)};
}

/// Closes all descriptors but the standard ones and those.
void close_descriptors_but(std::vector<int> kept);

/// From here on this process leaves no core file.
void leave_no_core();

/// Waits until a child has ended. @return its status as waitpid() gives it; 0 if it is none.
int wait_for_end(pid_t child);

/// Ends a child that leads a process group of its own, and all that it has started there.
void end_group(pid_t child);

/// What this process has mapped.
double address_space_bytes();

/// CPU time of a process so far, in seconds; NaN once it has ended.
double cpu_seconds_of(pid_t process);

}  // namespace ar3d
