#pragma once

#include <string>

#include "ar3d/base/error.h"
#include "support/test.h"

namespace ar3d::testing {

/// What the step is refused with; `none` if it is not.
template <class Step>
std::string problem(const Step& step, const std::string& none = "") {
  try {
    step();
  } catch (const InputError& error) {
    return error.what();
  }
  return none;
}

}  // namespace ar3d::testing
