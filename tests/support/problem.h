#pragma once

#include <string>

#include "ar3d/base/error.h"

namespace ar3d::testing {

/// What the step is refused with; empty if it is not.
template <class Step>
std::string problem(const Step& step) {
  try {
    step();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace ar3d::testing
