#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "ar3d/model/guarantee.h"

namespace ar3d {

/// Holds a promise as the options of ar3d_proved say it (`ar3d list --promise`).
struct PromiseArguments {
  std::optional<std::uint32_t> bends;
  std::string cosine;
  bool exactly = false;
  bool at_least = false;
  std::string gram = "1,1,1";
  std::string directions;
  std::string plane;
  std::string box;
};

/// Adds --bends, --cosine, --exactly, --at-least, --gram, --directions, --plane and --box.
void add_promise_options(CLI::App& verb, PromiseArguments& arguments);

/// Returns the promise, or nothing if --bends was not given; without --box its bound has no name.
/// @throws InputError naming the word that is not understood.
std::optional<Guarantee> promise_of(const PromiseArguments& arguments);

}  // namespace ar3d
