#include "ar3d/analysis/scaling/bootstrap.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "ar3d/model/random.h"

namespace ar3d {
namespace {

constexpr double kLackOfFitLevel = 0.01;
constexpr std::uint64_t kInstanceStream = 1;
constexpr std::uint64_t kSizeStream = 2;

/// Basic bootstrap: [c - q(high), c - q(low)] of the replicates' errors, widened to t with df
/// degrees of freedom.
Interval basic_interval(double coefficient, std::vector<double> errors, double df,
                        double confidence) {
  const double tail = (1 - confidence) / 2;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double widening =
      student_t_quantile(1 - tail, df) / student_t_quantile(1 - tail, kInfinity);
  std::sort(errors.begin(), errors.end());
  return {coefficient - widening * quantile(errors, 1 - tail),
          coefficient - widening * quantile(errors, tail)};
}

double draw(const std::vector<double>& values, RandomStream& random) {
  return values[random.below(static_cast<std::uint32_t>(values.size()))];
}

/// Deviations from the size's mean, inflated so that their variance is the unbiased one.
std::vector<double> inflated_deviations(const std::vector<double>& values) {
  const double k = static_cast<double>(values.size());
  const double centre = mean(values);
  std::vector<double> deviations;
  for (const double value : values) {
    deviations.push_back((value - centre) * std::sqrt(k / (k - 1)));
  }
  return deviations;
}

/// Degrees of freedom of sum over s of projection[s]^2 * variance[s] / k[s], 1 at least. Welch's
/// form of Satterthwaite's formula, (sum)^2 / sum(part^2 / (k + 1)) - 2, since the plain one is far
/// too small for k = 2.
double satterthwaite(const std::vector<std::vector<double>>& values,
                     const std::vector<double>& projection) {
  double sum = 0, square_sum = 0;
  for (std::size_t s = 0; s < values.size(); ++s) {
    const double k = static_cast<double>(values[s].size());
    const double part = projection[s] * projection[s] * variance(values[s]) / k;
    sum += part;
    square_sum += part * part / (k + 1);
  }
  return square_sum > 0 ? std::max(1.0, sum * sum / square_sum - 2)
                        : std::numeric_limits<double>::infinity();
}

std::vector<double> replicate(const BootstrapOptions& options, std::uint64_t stream,
                              const std::function<double(RandomStream&)>& error) {
  RandomStream random(options.seed, stream);
  std::vector<double> errors(options.replicates);
  for (double& value : errors) value = error(random);
  return errors;
}

}  // namespace

Spread choose_spread(const std::vector<std::vector<double>>& values, const LinearFit& fit) {
  double within = 0, df_within = 0;
  for (const std::vector<double>& size : values) {
    if (size.size() < 2) return Spread::sizes;
    const double df = static_cast<double>(size.size() - 1);
    within += df * variance(size);
    df_within += df;
  }
  const double df_between = static_cast<double>(values.size() - fit.coefficients.size());
  if (df_between < 1) return Spread::instances;
  if (within == 0) return Spread::sizes;
  const double ratio = (fit.weighted_square_sum / df_between) / (within / df_within);
  return fisher_f_tail(ratio, df_between, df_within) < kLackOfFitLevel ? Spread::sizes
                                                                       : Spread::instances;
}

Interval interval_over_instances(const std::vector<std::vector<double>>& values,
                                 const LinearFit& fit, std::size_t coefficient,
                                 const BootstrapOptions& options) {
  const std::vector<double>& projection = fit.projection[coefficient];
  std::vector<std::vector<double>> deviations;
  for (const std::vector<double>& size : values) deviations.push_back(inflated_deviations(size));
  const auto error = [&](RandomStream& random) {
    double sum = 0;
    for (std::size_t s = 0; s < deviations.size(); ++s) {
      double size_sum = 0;
      for (std::size_t i = 0; i < deviations[s].size(); ++i)
        size_sum += draw(deviations[s], random);
      sum += projection[s] * size_sum / static_cast<double>(deviations[s].size());
    }
    return sum;
  };
  return basic_interval(fit.coefficients[coefficient], replicate(options, kInstanceStream, error),
                        satterthwaite(values, projection), options.confidence);
}

Interval interval_over_sizes(const LinearFit& fit, std::size_t coefficient,
                             const BootstrapOptions& options) {
  const std::vector<double>& projection = fit.projection[coefficient];
  std::vector<double> residuals;
  for (std::size_t s = 0; s < fit.residuals.size(); ++s) {
    residuals.push_back(fit.residuals[s] / std::sqrt(std::max(1e-9, 1 - fit.leverages[s])));
  }
  const double centre = mean(residuals);
  for (double& residual : residuals) residual -= centre;
  const auto error = [&](RandomStream& random) {
    double sum = 0;
    for (const double weight : projection) sum += weight * draw(residuals, random);
    return sum;
  };
  const double df = static_cast<double>(residuals.size() - fit.coefficients.size());
  return basic_interval(fit.coefficients[coefficient], replicate(options, kSizeStream, error),
                        std::max(1.0, df), options.confidence);
}

}  // namespace ar3d
