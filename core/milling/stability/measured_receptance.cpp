#include "core/milling/stability/measured_receptance.h"

#include <algorithm>
#include <cmath>

namespace stillcut::milling {

namespace {

std::complex<double> valueAt(const MeasuredResponse& r, double hz) {
  if (r.frequency.empty()) return 0.0;
  const auto after = std::upper_bound(r.frequency.begin(), r.frequency.end(), hz);
  if (after == r.frequency.begin()) return r.value.front();
  if (after == r.frequency.end()) return r.value.back();
  const auto i = static_cast<std::size_t>(after - r.frequency.begin());
  const double part = (hz - r.frequency[i - 1]) / (r.frequency[i] - r.frequency[i - 1]);
  return r.value[i - 1] + part * (r.value[i] - r.value[i - 1]);
}

Status checkOne(const MeasuredResponse& r, const std::string& where) {
  if (r.frequency.size() != r.value.size() || r.frequency.size() == 1) {
    return Error{where, message("a response needs two lines or more, each with a frequency")};
  }
  for (std::size_t i = 0; i < r.frequency.size(); ++i) {
    const bool rises = r.frequency[i] > (i > 0 ? r.frequency[i - 1] : 0.0);
    const bool finite = std::isfinite(r.frequency[i]) && std::isfinite(std::abs(r.value[i]));
    if (!rises || !finite) return Error{where, message("the frequencies of a response must rise from above 0")};
  }
  return Done{};
}

}  // namespace

Status MeasuredReceptance::check(const std::string& where) const {
  if (xx.frequency.empty() && yy.frequency.empty()) {
    return Error{where, message("a response along x or y is needed")};
  }
  for (const MeasuredResponse* r : {&xx, &yy, &xy}) {
    if (Status ok = checkOne(*r, where); !ok) return ok;
  }
  if (!(lowest() < highest())) return Error{where, message("the responses have no frequencies in common")};
  return Done{};
}

Hertz MeasuredReceptance::lowest() const {
  double hz = 0.0;
  for (const MeasuredResponse* r : {&xx, &yy, &xy}) {
    if (!r->frequency.empty()) hz = std::max(hz, r->frequency.front());
  }
  return Hertz(hz);
}

Hertz MeasuredReceptance::highest() const {
  double hz = 1e9;
  for (const MeasuredResponse* r : {&xx, &yy, &xy}) {
    if (!r->frequency.empty()) hz = std::min(hz, r->frequency.back());
  }
  return Hertz(hz);
}

Hertz MeasuredReceptance::step() const {
  double widest = 0.0;
  for (const MeasuredResponse* r : {&xx, &yy, &xy}) {
    for (std::size_t i = 1; i < r->frequency.size(); ++i) {
      if (r->frequency[i - 1] < lowest().value || r->frequency[i] > highest().value) continue;
      widest = std::max(widest, r->frequency[i] - r->frequency[i - 1]);
    }
  }
  return Hertz(widest);
}

std::array<std::complex<double>, 4> MeasuredReceptance::at(Hertz frequency) const {
  const auto cross = valueAt(xy, frequency.value);
  return {valueAt(xx, frequency.value), cross, cross, valueAt(yy, frequency.value)};
}

}  // namespace stillcut::milling
