#include "core/active/model_renewal.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/active/identify_path.h"

namespace stillcut::active {

namespace {

constexpr double kConvincing = 0.5;  // of two estimates of one path, the one differs by twice the noise of an estimate
constexpr double kMostTurned = std::numbers::pi / 3.0;

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

}  // namespace

void ModelRenewal::prepare(const PathModel& model, std::vector<Hertz> lines, Hertz rate) {
  model_ = model;
  lines_ = std::move(lines);
  rate_ = rate;
  before_.clear();
}

std::optional<PathModel> ModelRenewal::judge(const std::vector<double>& impulse) {
  const std::vector<double> first = std::exchange(before_, impulse);
  if (first.size() != impulse.size()) return std::nullopt;
  const std::vector<double> old = model_.impulse(static_cast<int>(impulse.size()));
  if (distance(first, impulse) >= kConvincing * distance(old, impulse)) return std::nullopt;

  std::vector<double> mean(impulse.size());
  for (std::size_t k = 0; k < mean.size(); ++k) mean[k] = 0.5 * (first[k] + impulse[k]);
  auto found = modelOf(mean, model_, "on-line model");
  if (!found) return std::nullopt;
  if (distance(found->impulse(static_cast<int>(impulse.size())), impulse) >= distance(old, impulse))
    return std::nullopt;
  for (const Hertz line : lines_) {
    if (std::abs(phaseError(*found, model_.response(line, rate_), line, rate_)) > kMostTurned) return std::nullopt;
  }
  model_ = *found;
  before_.clear();  // what confirmed it cannot speak against it
  return model_;
}

}  // namespace stillcut::active
