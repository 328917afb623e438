#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace ar3d {

/// How a drawing is judged. Only `exact` proves.
struct CertificateMode {
  enum class Kind : std::uint8_t {
    exact,     ///< a proof in integers
    filtered,  ///< angles and meetings in double where the error's bound decides, else exact
    double_precision,  ///< angles and meetings in double, rounded
    sample,            ///< angles exact, meetings of `sample` candidate pairs of segments exact
    none,              ///< nothing is judged
  };
  static constexpr std::uint64_t kLargestSample = 999999999;

  Kind kind = Kind::exact;
  std::uint64_t sample = 0;  ///< candidate pairs that are looked at, drawn without replacement

  bool is_exact() const { return kind == Kind::exact; }
  friend bool operator==(const CertificateMode&, const CertificateMode&) = default;
};

/// "exact", "filtered", "double", "sample=1000", "none": at most 16 characters.
std::string to_string(const CertificateMode& mode);
/// @throws InputError naming the text if it is none of these, or a sample is not 1 to 999999999.
CertificateMode parse_certificate_mode(std::string_view text);

}  // namespace ar3d
