#include "core/active/model_renewal.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/active/identify_path.h"

namespace stillcut::active {

namespace {

constexpr double kConvincing = 0.5;  // of two estimates of one path, the one differs by twice the noise of an estimate
constexpr double kSlight = 0.2;      // of a response: 12 degrees
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

  auto found = modelOf(first, model_, "on-line model");
  if (!found) return std::nullopt;
  const std::vector<double> made = found->impulse(static_cast<int>(impulse.size()));
  if (distance(made, impulse) >= kConvincing * distance(old, impulse)) return std::nullopt;
  const PathModel measured{impulse, {}, 0};
  for (const Hertz line : lines_) {
    const std::complex<double> here = measured.response(line, rate_);
    const double before = std::abs(model_.response(line, rate_) - here);
    const double after = std::abs(found->response(line, rate_) - here);
    if (after > std::max(before, kSlight * std::abs(here))) return std::nullopt;
    if (std::abs(phaseError(*found, model_.response(line, rate_), line, rate_)) > kMostTurned) return std::nullopt;
  }
  model_ = *found;
  before_.clear();  // what confirmed it cannot speak against it
  return model_;
}

}  // namespace stillcut::active
