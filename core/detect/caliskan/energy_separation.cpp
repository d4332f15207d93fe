#include "core/detect/caliskan/energy_separation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stillcut::detect {
namespace {

using dsp::kernels::kLanes;
using dsp::kernels::wholeLanes;

constexpr std::size_t kCoefficientRows = 5;
constexpr std::size_t kStateRows = 4;
constexpr std::size_t kLeastCapacity = 4 * EnergySeparation::kMostFrames;
constexpr int kBandsOfLeast = 4;    // a quarter; a narrower one is left out
constexpr double kLastEdge = 0.49;  // of the rate
constexpr double kRetune = 1e-3;    // smaller speed changes move no edge worth mentioning

}  // namespace

void EnergySeparation::prepare(int channels, int bands, Hertz rate, Hertz lowestWidth,
                               const dsp::kernels::Kernels& kernels) {
  kernels_ = kernels;
  bands_ = bands;
  rate_ = rate.value;
  lanes_ = wholeLanes(static_cast<std::size_t>(bands));
  histories_.assign(lanes_, {});
  const double longest = rate_ / (2.0 * lowestWidth.value);  // lag of band 1
  capacity_ = std::max(kLeastCapacity, wholeLanes(4 * static_cast<std::size_t>(longest)));
  std::size_t size = 0;
  for (std::size_t m = 0; m < lanes_; ++m) {
    const auto lag = static_cast<std::size_t>(std::ceil(longest / (2.0 * static_cast<double>(m) + 1.0))) + 1;
    histories_[m] = {size, wholeLanes(4 * lag), 1};
    size += histories_[m].before + capacity_ + kLanes;
  }
  coefficients_.assign(kCoefficientRows * lanes_, 0.0);
  for (auto* v : {&low_, &high_, &scale_}) v->assign(lanes_, 0.0);
  channels_.assign(static_cast<std::size_t>(channels), {});
  for (BandChannel& c : channels_) {
    c.state.assign(kStateRows * lanes_, 0.0);
    c.sums.assign(2 * lanes_, 0.0);
    for (auto* v : {&c.power, &c.frequency, &c.valid}) v->assign(lanes_, 0.0);
    c.signal.assign(size, 0.0);
    c.newest.assign(lanes_, nullptr);
  }
  width_ = 0.0;
  top_ = 0;
  reset();
}

// Neighbouring bands share an edge: tan(pi m width / rate) from the powers of one turn.
void EnergySeparation::tune(Hertz spindle, int bandOrders, int topOrders) {
  const double width = spindle.value * bandOrders;
  if (topOrders == top_ && width_ > 0.0 && std::abs(width / width_ - 1.0) < kRetune) return;
  width_ = width;
  top_ = topOrders;
  const int left = topOrders % bandOrders;
  active_ = std::clamp(topOrders / bandOrders + (kBandsOfLeast * left >= bandOrders ? 1 : 0), 1, bands_);
  used_ = wholeLanes(static_cast<std::size_t>(active_));
  const double turn = std::numbers::pi / rate_;
  const auto n = static_cast<std::size_t>(active_);
  kernels_.powers(std::cos(turn * width_), std::sin(turn * width_), n, low_.data(), high_.data());
  for (std::size_t m = 0; m < n; ++m) high_[m] /= low_[m];
  const double last = std::min({static_cast<double>(n) * width_, topOrders * spindle.value, kLastEdge * rate_});
  high_[n - 1] = std::tan(turn * last);
  low_[0] = std::tan(turn * 0.5 * spindle.value);
  for (std::size_t m = 1; m < n; ++m) low_[m] = high_[m - 1];
  for (std::size_t m = n; m < lanes_; ++m) {  // any filter that is one; nobody listens
    low_[m] = low_[0];
    high_[m] = high_[0];
  }
  kernels_.designBank({low_.data(), high_.data(), used_, lanes_, coefficients_.data()});
  for (std::size_t m = 0; m < n; ++m) {
    const double middle = (static_cast<double>(m) + 0.5) * width_;
    History& h = histories_[m];
    h.lag = std::clamp<std::size_t>(static_cast<std::size_t>(std::lround(rate_ / (4.0 * middle))), 1, h.before / 4);
    scale_[m] = rate_ / (kTwoPi * static_cast<double>(h.lag));
  }
  for (BandChannel& c : channels_) {
    for (std::size_t m = n; m < lanes_; ++m) c.power[m] = c.frequency[m] = c.valid[m] = 0.0;
  }
}

void EnergySeparation::clear(BandChannel& c) {
  for (auto* v : {&c.state, &c.sums, &c.power, &c.frequency, &c.valid, &c.signal}) std::fill(v->begin(), v->end(), 0.0);
}

void EnergySeparation::reset() {
  position_ = pending_ = frames_ = 0;
  for (BandChannel& c : channels_) {
    clear(c);
    point(c);
  }
}

void EnergySeparation::point(BandChannel& c) {
  for (std::size_t m = 0; m < lanes_; ++m) {
    c.newest[m] = c.signal.data() + histories_[m].offset + histories_[m].before + position_;
  }
}

void EnergySeparation::process(int channel, const double* rest, std::size_t frames) {
  BandChannel& c = channels_[static_cast<std::size_t>(channel)];
  kernels_.bank({rest, frames, used_, lanes_, coefficients_.data(), c.state.data(), c.newest.data()});
}

void EnergySeparation::advance(std::size_t frames) {
  position_ += frames;
  pending_ += frames;
  if (pending_ == kMostFrames) accumulate();
  if (position_ + kMostFrames > capacity_) compact();
  for (BandChannel& c : channels_) point(c);
}

// Stretches are cut by the hops alone, so that sums do not depend on how the stream came in blocks.
void EnergySeparation::accumulate() {
  if (pending_ == 0) return;
  for (BandChannel& c : channels_) {
    for (std::size_t m = 0; m < static_cast<std::size_t>(active_); ++m) {
      const History& h = histories_[m];
      const double* first = c.signal.data() + h.offset + h.before + position_ - pending_;
      kernels_.operatorSums({first, pending_, h.lag, &c.sums[m], &c.sums[lanes_ + m]});
    }
  }
  frames_ += pending_;
  pending_ = 0;
}

// The newest frames become the history of those to come.
void EnergySeparation::compact() {
  for (BandChannel& c : channels_) {
    for (const History& h : histories_) {
      const auto begin = c.signal.begin() + static_cast<std::ptrdiff_t>(h.offset);
      const auto from = begin + static_cast<std::ptrdiff_t>(position_ - pending_);
      std::copy(from, from + static_cast<std::ptrdiff_t>(h.before + pending_), begin);
    }
  }
  position_ = pending_;
}

void EnergySeparation::estimate() {
  accumulate();
  if (frames_ == 0) return;
  for (BandChannel& c : channels_) {
    double all = 0.0;
    for (const double sum : c.sums) all += sum;
    if (!std::isfinite(all)) clear(c);
    kernels_.separate({c.sums.data(), c.sums.data() + lanes_, used_, static_cast<double>(frames_), scale_.data(),
                       c.power.data(), c.frequency.data(), c.valid.data()});
  }
  frames_ = 0;
}

BandEstimate EnergySeparation::band(int channel, int m) const {
  const BandChannel& c = channels_[static_cast<std::size_t>(channel)];
  const auto i = static_cast<std::size_t>(m);
  return {c.power[i], Hertz(c.frequency[i]), c.valid[i] != 0.0};
}

double EnergySeparation::weightedPower(int channel, int eta) const {
  const BandChannel& c = channels_[static_cast<std::size_t>(channel)];
  double sum = 0.0;
  for (std::size_t m = 0; m < static_cast<std::size_t>(active_); ++m) {
    const double f2 = c.frequency[m] * c.frequency[m];
    if (f2 > 0.0) sum += eta == 0 ? c.power[m] : eta > 0 ? c.power[m] * f2 : c.power[m] / f2;
  }
  return sum;
}

}  // namespace stillcut::detect
