#pragma once

#include <string>

#include "ar3d/model/guarantee.h"

namespace ar3d {

/// Reads what SizeBound::formula() writes: files of version 2 have a bound as this text only. The
/// text may have been cut behind its third axis. @throws InputError naming the text.
SizeBound parse_formula(const std::string& text);

}  // namespace ar3d
