#pragma once

#include <functional>
#include <string>

namespace ar3d {

/// Does a step in a child process, so that a crash or an endless loop in it ends the child only.
/// The step's effects on memory are lost; what it writes into files stays. It gets `cpu_seconds` of
/// CPU time.
/// @return empty, or what went wrong: the message of the exception that it threw, or how the
/// process ended. @throws InputError if there can be no process.
std::string do_apart(const std::function<void()>& step, unsigned cpu_seconds);

}  // namespace ar3d
