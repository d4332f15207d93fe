#include "core/active/online_identifier.h"

#include <algorithm>
#include <cmath>

#include "core/dsp/kernels/choose.h"

namespace stillcut::active {

namespace {

constexpr int kPredictorTaps = 128;
constexpr double kPredictorShare = 0.05;  // of the step that makes the error vanish
constexpr double kSettling = 0.5;         // [s] for the predictors after a start

}  // namespace

void OnlineIdentifier::PredictionErrorFilter::prepare(int taps, int delay) {
  delay_ = delay;
  predictor_.prepare({.taps = taps, .step = kPredictorShare, .normalised = true});
  past_.prepare(static_cast<std::size_t>(delay));
}

void OnlineIdentifier::PredictionErrorFilter::reset() noexcept {
  predictor_.reset();
  past_.reset();
}

double OnlineIdentifier::PredictionErrorFilter::process(double x) STILLCUT_RT {
  const double rest = predictor_.process(past_.data()[delay_ - 1], x);  // x itself is not in the line yet
  past_.push(x);
  return rest;
}

void OnlineIdentifier::prepare(const OnlineOptions& options, Hertz rate) {
  options_ = options;
  if (!on()) return;
  kernels_ = dsp::kernels::bestKernels();
  options_.lags = static_cast<int>(dsp::kernels::wholeLanes(static_cast<std::size_t>(options.lags)));
  const auto lags = static_cast<std::size_t>(options_.lags);
  added_.prepare(lags + 1);
  error_.prepare(kPredictorTaps, options_.lags + 1);
  output_.prepare(kPredictorTaps, options_.lags + 1);
  window_ = static_cast<std::size_t>(std::max(1.0, std::round(options.window.value * rate.value)));
  settle_ = static_cast<std::size_t>(std::round(kSettling * rate.value)) + lags;
  const Sums empty{std::vector<double>(lags, 0.0), std::vector<double>(lags, 0.0), 0.0};
  sums_ = empty;
  for (int slot = 0; slot < 3; ++slot) {  // each of the three has its memory from here on
    whole_.back() = empty;
    whole_.publish();
    (void)whole_.read();
  }
  impulse_.assign(lags, 0.0);
  reset();
}

void OnlineIdentifier::reset() noexcept {
  if (!on()) return;
  noise_ = milling::NoiseSource(options_.seed);
  added_.reset();
  error_.reset();
  output_.reset();
  std::ranges::fill(sums_.error, 0.0);
  std::ranges::fill(sums_.output, 0.0);
  sums_.power = 0.0;
  samples_ = 0;
  now_ = 0.0;
}

void OnlineIdentifier::hear(double error) STILLCUT_RT {
  const double rest = error_.process(error);
  if (samples_ >= settle_) {
    // added_ ends with the sample before this reading: lag 1.
    kernels_.tapSteer(sums_.error.data(), 1.0, rest, added_.data(), sums_.error.size());
  }
}

double OnlineIdentifier::next() STILLCUT_RT {
  now_ = options_.rms * noise_.normal();
  return now_;
}

void OnlineIdentifier::wrote(double output) STILLCUT_RT {
  const double rest = output_.process(output);
  added_.push(now_);
  if (samples_++ < settle_) return;
  kernels_.tapSteer(sums_.output.data(), 1.0, rest, added_.data(), sums_.output.size());  // from lag 0
  sums_.power += now_ * now_;
  if (samples_ < settle_ + window_) return;
  Sums& out = whole_.back();
  std::ranges::copy(sums_.error, out.error.begin());
  std::ranges::copy(sums_.output, out.output.begin());
  out.power = sums_.power;
  whole_.publish();
  std::ranges::fill(sums_.error, 0.0);
  std::ranges::fill(sums_.output, 0.0);
  sums_.power = 0.0;
  samples_ = settle_;
}

const std::vector<double>* OnlineIdentifier::takeEstimate() {
  const Sums* sums = on() ? whole_.read() : nullptr;
  if (sums == nullptr || !whole_.fresh() || !(sums->power > 0.0)) return nullptr;
  // -c_ve(k) = sum_j c_vy(j) s(k - j), j from 0: long division.
  const double direct = sums->output[0];
  if (!(direct > 0.0)) return nullptr;
  for (std::size_t k = 0; k < impulse_.size(); ++k) {
    double rest = -sums->error[k];
    for (std::size_t j = 1; j <= k; ++j) rest -= sums->output[j] * impulse_[k - j];
    impulse_[k] = rest / direct;
  }
  return std::ranges::all_of(impulse_, [](double s) { return std::isfinite(s); }) ? &impulse_ : nullptr;
}

}  // namespace stillcut::active
