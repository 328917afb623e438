#pragma once

namespace ar3d::report {

/// The page's style sheet (light, dark, print, narrow screens) and its one script (hover, keys,
/// replay panel).
extern const char* const kStyle;
extern const char* const kScript;

}  // namespace ar3d::report
