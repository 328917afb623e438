// Tells from a row which certificate was asked for, also in results of older versions.
#include "ar3d/store/columns/asked_certificate.h"

namespace ar3d {
namespace {

constexpr std::string_view kBefore = "certificate ";
constexpr std::string_view kBehind = " did not accept it; ";

}  // namespace

std::string asked_certificate(const RunRecord& run) {
  if (!run.certificate.empty()) return run.certificate;
  const std::size_t behind = run.message.find(kBehind);
  if (!run.message.starts_with(kBefore) || behind == std::string::npos) return "exact";
  return run.message.substr(kBefore.size(), behind - kBefore.size());
}

}  // namespace ar3d
