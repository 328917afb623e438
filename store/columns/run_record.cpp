// Names of statuses and phases, as results files hold them, and the certificate that was asked for.
#include "ar3d/store/columns/run_record.h"

#include <fmt/format.h>

#include "ar3d/base/error.h"

namespace ar3d {
namespace {
constexpr std::array<const char*, 7> kNames = {"ok",       "timeout", "out_of_memory", "refused",
                                               "violated", "crashed", "measured"};
constexpr std::array<const char*, 6> kPhases = {"metrics", "timing",   "strong",
                                                "weak",    "strong_r", "weak_r"};

// The index of a text in a table of names.
template <std::size_t N>
std::size_t index_of(std::string_view text, const std::array<const char*, N>& names,
                     const char* what) {
  for (std::size_t i = 0; i < N; ++i) {
    if (text == names[i]) return i;
  }
  throw InputError(fmt::format("unknown {} '{}'", what, text));
}

}  // namespace

const char* to_string(RunStatus status) { return kNames.at(static_cast<std::size_t>(status)); }

RunStatus parse_run_status(std::string_view text) {
  return static_cast<RunStatus>(index_of(text, kNames, "status"));
}

const char* to_string(RunPhase phase) { return kPhases.at(static_cast<std::size_t>(phase)); }

RunPhase parse_run_phase(std::string_view text) {
  return static_cast<RunPhase>(index_of(text, kPhases, "phase"));
}

std::string asked_certificate(const RunRecord& run) {
  constexpr std::string_view kBefore = "certificate ", kBehind = " did not accept it; ";
  if (!run.certificate.empty()) return run.certificate;
  const std::size_t behind = run.message.find(kBehind);
  if (!run.message.starts_with(kBefore) || behind == std::string::npos) return "exact";
  return run.message.substr(kBefore.size(), behind - kBefore.size());
}

}  // namespace ar3d
