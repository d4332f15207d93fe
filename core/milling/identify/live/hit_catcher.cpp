#include "core/milling/identify/live/hit_catcher.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stillcut::identify {
namespace {

constexpr double kRecent = 0.02;       // [s]
constexpr int kPieces = 8;             // in which the noise is learned
constexpr double kSlowDrift = 1e-4;    // weight of a sample in the mean: a sensor's offset wanders
constexpr double kNoiseOfRinging = 3;  // times the noise of the quiet channel counts as quiet

}  // namespace

HitCatcher::HitCatcher(double rate, bool withForce, const CatcherOptions& options)
    : rate_(rate), withForce_(withForce), options_(options) {}

std::size_t HitCatcher::samples(double seconds) const {
  return static_cast<std::size_t>(std::max(1.0, std::round(seconds * rate_)));
}

// The quietest of some pieces tells the noise: somebody may be hitting already.
void HitCatcher::learn(double trigger) {
  sum_ += trigger;
  squares_ += trigger * trigger;
  if (++learned_ < samples(options_.settle / kPieces)) return;
  const double n = static_cast<double>(learned_);
  const double mean = sum_ / n;
  const double rms = std::sqrt(std::max(0.0, squares_ / n - mean * mean));
  if (pieces_ == 0 || rms < noise_) {
    noise_ = rms;
    mean_ = mean;
  }
  sum_ = squares_ = 0.0;
  learned_ = 0;
  if (++pieces_ < kPieces) return;
  level_ = std::max(options_.noises * noise_, options_.least);
  state_ = State::Waiting;
}

// The sample at `index` of the kept ones has left the noise.
void HitCatcher::begin(std::size_t index) {
  const std::size_t lead = std::min(index, samples(options_.before));
  hit_ = {};
  hit_.time = static_cast<double>(seen_) / rate_;
  hit_.noise = noise_;
  hit_.tooSoon = state_ == State::Ringing;
  const auto from = static_cast<std::ptrdiff_t>(index - lead);
  const auto to = static_cast<std::ptrdiff_t>(index + 1);
  if (withForce_) hit_.force.assign(force_.begin() + from, force_.begin() + to);
  hit_.response.assign(response_.begin() + from, response_.begin() + to);
  missing_ = samples(options_.length) - 1;
  state_ = State::Catching;
}

bool HitCatcher::ringsDown(double response) {
  const double weight = 1.0 / static_cast<double>(samples(kRecent));
  recent_ += weight * (response * response - recent_);
  const double quiet = std::max(options_.quietShare * largest_, withForce_ ? 0.0 : kNoiseOfRinging * noise_);
  return std::sqrt(recent_) < quiet || ++ringing_ > samples(options_.longestRinging);
}

// Longer than a screen: every sample goes through the states in one place
std::vector<CaughtHit> HitCatcher::feed(std::span<const double> force, std::span<const double> response, bool gap) {
  std::vector<CaughtHit> caught;
  if (gap && state_ == State::Catching) hit_.gap = true;
  if (gap && state_ != State::Catching) {  // what came before does not belong to what comes
    force_.clear();
    response_.clear();
  }
  for (std::size_t i = 0; i < response.size(); ++i, ++seen_) {
    const double f = withForce_ ? force[i] : 0.0;
    if (state_ == State::Catching) {
      if (withForce_) hit_.force.push_back(f);
      hit_.response.push_back(response[i]);
      if (--missing_ > 0) continue;
      largest_ = 0.0;
      for (const double r : hit_.response) largest_ = std::max(largest_, std::abs(r));
      recent_ = largest_ * largest_;
      ringing_ = 0;
      caught.push_back(std::exchange(hit_, {}));
      state_ = State::Ringing;
      force_.clear();
      response_.clear();
      continue;
    }
    if (withForce_) force_.push_back(f);
    response_.push_back(response[i]);
    const double trigger = withForce_ ? f : response[i];
    if (state_ == State::Settling) {
      learn(trigger);
    } else if (state_ == State::Ringing && ringsDown(response[i])) {
      state_ = State::Waiting;
    }
    if (state_ == State::Waiting || (state_ == State::Ringing && withForce_)) {
      if (std::abs(trigger - mean_) > level_) {
        begin(response_.size() - 1);
      } else {
        mean_ += kSlowDrift * (trigger - mean_);
      }
    }
  }
  // Only what a hit that begins now would need.
  const std::size_t kept = samples(options_.before);
  if (state_ != State::Catching && response_.size() > 8 * kept) {
    const auto old = static_cast<std::ptrdiff_t>(response_.size() - kept);
    if (withForce_) force_.erase(force_.begin(), force_.begin() + old);
    response_.erase(response_.begin(), response_.begin() + old);
  }
  return caught;
}

}  // namespace stillcut::identify
