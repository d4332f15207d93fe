#include "core/milling/identify/live/tap_test.h"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/FFT>
#include <utility>

#include "core/milling/identify/hammer_hits.h"
#include "core/milling/identify/live/free_decay.h"

namespace stillcut::identify {
namespace {

constexpr double kReaches = 0.1;  // of the force's largest line

// The lower of the two in the middle: one of two that differ does not spoil the other.
double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double largest(const std::vector<double>& signal) {
  double most = 0.0;
  for (const double v : signal) most = std::max(most, std::abs(v));
  return most;
}

void takeOffset(std::vector<double>& signal, std::size_t quiet) {
  double mean = 0.0;
  for (std::size_t i = 0; i < quiet; ++i) mean += signal[i] / static_cast<double>(quiet);
  for (double& v : signal) v -= mean;
}

// |a - b| over the mean size of both, over the lines that both have.
double distance(const std::vector<std::complex<double>>& a, const std::vector<std::complex<double>>& b) {
  double difference = 0.0, sizes = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    difference += std::norm(a[i] - b[i]);
    sizes += 0.5 * (std::norm(a[i]) + std::norm(b[i]));
  }
  return sizes > 0.0 ? std::sqrt(difference / sizes) : 0.0;
}

}  // namespace

TapTest::TapTest(double rate, const TapTestOptions& options)
    : rate_(rate), options_(options), catcher_(rate, options.withForce, options.catcher) {}

TapTest::Phase TapTest::phase() const {
  if (good() >= options_.enough) return Phase::Enough;
  switch (catcher_.state()) {
    case HitCatcher::State::Settling:
      return Phase::Settling;
    case HitCatcher::State::Waiting:
      return Phase::Waiting;
    case HitCatcher::State::Catching:
      return Phase::Recording;
    case HitCatcher::State::Ringing:
      return Phase::Ringing;
  }
  return Phase::Settling;
}

int TapTest::good() const {
  return static_cast<int>(std::count_if(hits_.begin(), hits_.end(), [](const TapHit& hit) { return hit.used(); }));
}

bool TapTest::feed(std::span<const double> force, std::span<const double> response, bool gap) {
  if (good() >= options_.enough) return false;
  std::vector<CaughtHit> caught = catcher_.feed(force, response, gap);
  for (CaughtHit& hit : caught) {
    if (good() >= options_.enough) break;
    hits_.push_back(judgeAlone(hit));
    compare();
  }
  return !caught.empty();
}

void TapTest::use(std::size_t hit, bool use) {
  if (hit < hits_.size()) hits_[hit].asked = use;
}

std::vector<HammerRecord> TapTest::records() const {
  std::vector<HammerRecord> used;
  for (std::size_t i = 0; i < hits_.size(); ++i) {
    if (hits_[i].used()) used.push_back(records_[i]);
  }
  return used;
}

// What a hit shows by itself, and its record with offsets taken off and the push positive.
TapHit TapTest::judgeAlone(CaughtHit& caught) {
  const auto quiet = static_cast<std::size_t>(0.8 * options_.catcher.before * rate_);
  HammerRecord record;
  record.rate = rate_;
  record.quantity = options_.quantity;
  record.axis = options_.axis;
  record.source = "hit " + std::to_string(hits_.size() + 1);
  const bool responseOver = options_.responseRange > 0.0 && largest(caught.response) >= 0.999 * options_.responseRange;
  const bool forceOver = options_.forceRange > 0.0 && largest(caught.force) >= 0.999 * options_.forceRange;
  takeOffset(caught.response, std::min(quiet, caught.response.size()));
  if (options_.withForce) takeOffset(caught.force, std::min(quiet, caught.force.size()));
  record.response = std::move(caught.response);
  record.force = std::move(caught.force);
  TapHit hit;
  hit.time = caught.time;
  hit.peak = largest(options_.withForce ? record.force : record.response);
  FoundHit found;
  if (options_.withForce) {
    const auto [low, high] = std::minmax_element(record.force.begin(), record.force.end());
    if (-*low > *high) {
      for (double& v : record.force) v = -v;
    }
    const std::vector<FoundHit> all = findHits(record, options_.hammer);
    if (!all.empty()) found = all.front();
    hit.width = found.hit.width;
  }
  std::vector<double> peaks;
  for (const TapHit& other : hits_) {
    if (other.used()) peaks.push_back(other.peak);
  }
  const bool weak = hit.peak < options_.weakNoises * caught.noise || hit.peak < options_.weakShare * median(peaks);
  hit.fault = caught.gap                                   ? HitFault::Gap
              : forceOver || found.hit.forceOverload       ? HitFault::ForceOverload
              : responseOver || found.hit.responseOverload ? HitFault::ResponseOverload
              : weak                                       ? HitFault::Weak
              : found.hit.doubleHit                        ? HitFault::DoubleHit
              : caught.tooSoon                             ? HitFault::TooSoon
                                                           : HitFault::None;
  signatures_.push_back(hit.fault == HitFault::None ? signature(record) : std::vector<std::complex<double>>());
  records_.push_back(std::move(record));
  return hit;
}

// Response over force on the lines that the hammer reaches; without a hammer the spectrum of the decay, of size 1.
std::vector<std::complex<double>> TapTest::signature(const HammerRecord& record) const {
  if (!options_.withForce) return decaySignature(record);
  Eigen::FFT<double> fft;
  std::vector<std::complex<double>> f, x;
  fft.fwd(f, record.force);
  fft.fwd(x, record.response);
  double strongest = 0.0;
  for (const auto& line : f) strongest = std::max(strongest, std::abs(line));
  std::vector<std::complex<double>> ratio;
  for (std::size_t k = 1; k < record.force.size() / 2 && std::abs(f[k]) > kReaches * strongest; ++k) {
    ratio.push_back(x[k] / f[k]);
  }
  return ratio;
}

// Of those that are sound by themselves; the first one may turn out to have been too weak.
void TapTest::compare() {
  std::vector<std::size_t> sound;
  for (std::size_t i = 0; i < hits_.size(); ++i) {
    if (!signatures_[i].empty()) sound.push_back(i);
  }
  for (const std::size_t i : sound) {
    std::vector<double> distances, peaks;
    for (const std::size_t j : sound) {
      if (i == j) continue;
      distances.push_back(distance(signatures_[i], signatures_[j]));
      peaks.push_back(hits_[j].peak);
    }
    TapHit& hit = hits_[i];
    hit.difference = median(distances);
    const bool several = sound.size() > 2;
    hit.fault = several && hit.peak < options_.weakShare * median(peaks) ? HitFault::Weak
                : several && hit.difference > options_.differs           ? HitFault::Incoherent
                                                                         : HitFault::None;
  }
}

}  // namespace stillcut::identify
