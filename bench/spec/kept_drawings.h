#pragma once

#include <cstdint>
#include <string_view>

namespace ar3d {

/// Which drawings of a study are kept. Each drawing is kept once, however many rows are of it.
enum class KeptDrawings : std::uint8_t {
  none,
  worst,     ///< the worst one of every curve: algorithm with options, family with parameters
  violated,  ///< those that were proved wrong
  all        ///< those of all rows that were drawn
};
/// "none", "worst", "violated", "all".
const char* to_string(KeptDrawings kept);
/// @throws InputError naming the text and the choices if it is none of them.
KeptDrawings parse_kept_drawings(std::string_view text);

}  // namespace ar3d
