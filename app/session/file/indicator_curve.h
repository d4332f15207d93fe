// IndicatorCurve: the first indicator of a detector's verdicts over a recording of any length, as its largest values in
// even steps, at most so many. Thread: one.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/model/verdict.h"
#include "ui/facade/file_controller.h"

namespace stillcut::app {

class IndicatorCurve {
 public:
  static constexpr std::size_t kMost = 8192;

  // Of a block from `begin` to `end`, since the first sample. What was not judged leaves a hole.
  void add(const Verdict& verdict, Seconds begin, Seconds end) {
    const double value = std::abs(verdict.indicators[0]);
    if (!verdict.valid || !std::isfinite(value) || !(end > begin)) return;
    while (end.value / step_.value > static_cast<double>(kMost)) halve();
    const auto first = static_cast<std::size_t>(std::max(begin.value, 0.0) / step_.value);
    const auto last = std::max(static_cast<std::size_t>(std::ceil(end.value / step_.value)), first + 1);
    if (highest_.size() < last) highest_.resize(last, kNone);
    for (std::size_t k = first; k < last; ++k) highest_[k] = larger(highest_[k], static_cast<float>(value));
  }
  ui::FileCurve curve(const QString& name, double limit) const { return {name, step_, highest_, limit}; }

 private:
  static constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  static float larger(float a, float b) { return std::isnan(a) || b > a ? b : a; }
  void halve() {
    std::vector<float> half((highest_.size() + 1) / 2, kNone);
    for (std::size_t k = 0; k < highest_.size(); ++k) half[k / 2] = larger(half[k / 2], highest_[k]);
    highest_ = std::move(half);
    step_ = step_ * 2.0;
  }

  Seconds step_{0.005};
  std::vector<float> highest_;
};

}  // namespace stillcut::app
