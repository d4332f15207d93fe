#include "core/milling/identify/mean_force.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace stillcut::identify {
namespace {

struct Mean {
  double value = 0.0;
  double error = 0.0;
};

// Mean of revolution means and its standard error. For a first-order correlation r between neighbours the variance of
// the mean is (1 + r) / (1 - r) times that of independent ones.
Mean meanOf(const std::vector<double>& turns) {
  const auto n = static_cast<double>(turns.size());
  Mean mean;
  for (const double v : turns) mean.value += v / n;
  double variance = 0.0;
  double neighbours = 0.0;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const double d = turns[i] - mean.value;
    variance += d * d;
    if (i > 0) neighbours += d * (turns[i - 1] - mean.value);
  }
  const double r = variance > 0.0 ? std::clamp(neighbours / variance, 0.0, 0.9) : 0.0;
  mean.error = std::sqrt(variance / (n - 1.0) / n * (1.0 + r) / (1.0 - r));
  return mean;
}

}  // namespace

Result<MeanForce> meanOverRevolutions(const std::array<std::span<const double>, 3>& force, double rate, Rpm speed,
                                      double feedPerTooth, const std::string& where) {
  if (!(rate > 0.0 && std::isfinite(rate)) || !(speed.value > 0.0 && std::isfinite(speed.value))) {
    return Error{where, message("sampling rate and spindle speed must be positive")};
  }
  const std::size_t count = force[0].size();
  if (force[1].size() != count || force[2].size() != count) {
    return Error{where, message("the three forces differ in length")};
  }
  const double perTurn = rate / toHertz(speed).value;
  if (perTurn < 4.0)
    return Error{where, message("has fewer than 4 samples per revolution"), message("speed or rate is wrong")};
  const auto turns = static_cast<std::size_t>(std::floor(static_cast<double>(count) / perTurn + 1e-9));
  if (turns < 2) return Error{where, message("is shorter than 2 revolutions")};
  MeanForce out;
  out.feedPerTooth = feedPerTooth;
  std::vector<double> means(turns);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t k = 0; k < turns; ++k) {
      const auto begin = static_cast<std::size_t>(std::llround(static_cast<double>(k) * perTurn));
      const auto end = std::min(count, static_cast<std::size_t>(std::llround(static_cast<double>(k + 1) * perTurn)));
      double sum = 0.0;
      for (std::size_t i = begin; i < end; ++i) sum += force[axis][i];
      if (!std::isfinite(sum)) return Error{where, message("holds a force that is not finite")};
      means[k] = sum / static_cast<double>(end - begin);
    }
    const Mean mean = meanOf(means);
    out.mean[axis] = mean.value;
    out.standardError[axis] = mean.error;
  }
  return out;
}

}  // namespace stillcut::identify
