#include "ar3d/verify/certificate_mode.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>

#include "ar3d/base/error.h"
#include "ar3d/base/nearest_name.h"
#include "ar3d/base/printable.h"

namespace ar3d {

std::string to_string(const CertificateMode& mode) {
  switch (mode.kind) {
    case CertificateMode::Kind::exact:
      return "exact";
    case CertificateMode::Kind::filtered:
      return "filtered";
    case CertificateMode::Kind::double_precision:
      return "double";
    case CertificateMode::Kind::sample:
      return fmt::format("sample={}", mode.sample);
    case CertificateMode::Kind::none:
      return "none";
  }
  throw InternalError("no name for a certificate mode");
}

CertificateMode parse_certificate_mode(std::string_view text) {
  using Kind = CertificateMode::Kind;
  for (const Kind kind : {Kind::exact, Kind::filtered, Kind::double_precision, Kind::none}) {
    if (text == to_string(CertificateMode{kind, 0})) return {kind, 0};
  }
  constexpr std::string_view kSample = "sample=";
  if (text.starts_with(kSample)) {
    const char* const begin = text.data() + kSample.size();
    const char* const end = text.data() + text.size();
    std::uint64_t count = 0;
    const auto [rest, error] = std::from_chars(begin, end, count);
    if (error == std::errc() && rest == end && count >= 1 &&
        count <= CertificateMode::kLargestSample) {
      return {Kind::sample, count};
    }
  }
  throw InputError(
      fmt::format("certificate '{}' is none of exact, filtered, double, none and sample=K with K "
                  "from 1 to {}{}",
                  printable(std::string(text)), CertificateMode::kLargestSample,
                  did_you_mean(text, {"exact", "filtered", "double", "none"})));
}

}  // namespace ar3d
