#include "core/milling/chatter_truth.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace stillcut::milling {

namespace {

constexpr double kEventRatio = 0.2;
constexpr double kSureRatio = 0.35;  // noise and transients of a stable cut do not reach it for long
constexpr double kMarkRatio = 0.5;
constexpr double kOverRatio = 0.1;  // below it chatter has ended
constexpr double kLeastDivisor = 0.3;

double divisor(double chatterHz, double spindleHz) {
  if (!(spindleHz > 0.0)) return 1.0;
  const double s = 2.0 * std::sin(std::numbers::pi * chatterHz / spindleHz);
  return std::max(s * s, kLeastDivisor);
}

// `strongest`: the largest vibration of the run so far. As a cut fades out, what is left is noise: a twentieth of the
// strongest counts as forced in any case.
double ratioOf(double chatterRms, double totalRms, double strongest) {
  const double rest = totalRms * totalRms - chatterRms * chatterRms;
  // Where nearly everything is chatter the difference of squares means little: 1/50 is the least that counts as forced.
  const double forced = std::sqrt(std::max({rest, totalRms * totalRms * 4e-4, strongest * strongest * 25e-4}));
  return forced > 0.0 ? chatterRms / forced : 0.0;
}

}  // namespace

ChatterTruth::ChatterTruth(const Settings& settings) : settings_(settings), perRev_(settings.samplesPerRevolution) {
  window_ = static_cast<std::size_t>(perRev_ * std::max(1.0, 0.008 * settings.nominalHz));
  spectrumLength_ = std::max(0.22, 8.0 / settings.nominalHz);
  for (auto& p : past_) p.assign(static_cast<std::size_t>(2 * perRev_), 0.0);
  chatterSq_.assign(window_, 0.0);
  totalSq_.assign(window_, 0.0);
  difference_.assign(static_cast<std::size_t>(1.1 * spectrumLength_ * settings.fastestHz * perRev_) + 1, 0.0);
  log_.reserve(static_cast<std::size_t>(settings.duration * 1000.0) + 16);
}

void ChatterTruth::follow(double d) noexcept {
  // d(n+1) + d(n-1) = 2 cos(w) d(n) for one tone.
  const double forget = 1.0 - 1.0 / (2.0 * perRev_);
  num_ = forget * num_ + d1_ * (d + d2_);
  den_ = forget * den_ + 2.0 * d1_ * d1_;
  d2_ = d1_;
  d1_ = d;
}

void ChatterTruth::add(const TruthSample& s) noexcept {
  if (s.cutting) {
    ++sinceCut_;
  } else {
    sinceCut_ = 0;
  }
  if (!s.cutting || !s.engagementSteady || sinceCut_ < 3 * static_cast<std::size_t>(perRev_)) {
    unsteadyUntil_ = s.time + settings_.settle;
  }
  const std::size_t half = static_cast<std::size_t>(perRev_), length = 2 * half;
  const auto difference = [&](std::size_t i, double value) {
    const double d = value - 2.0 * past_[i][(pastAt_ + half) % length] + past_[i][pastAt_];
    past_[i][pastAt_] = value;
    return d;
  };
  double raw = 0.0, total = 0.0, sum = 0.0, displacement = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    const double d = difference(i, s.acceleration[i]);
    raw += d * d;
    total += s.acceleration[i] * s.acceleration[i];
    sum += d;  // x and y chatter at one frequency: their sum carries it
    displacement += difference(i + 2, s.displacement[i]);
  }
  pastAt_ = (pastAt_ + 1) % length;
  ++seen_;
  if (seen_ <= length) raw = sum = displacement = 0.0;
  chatterSum_ += raw - chatterSq_[windowAt_];
  totalSum_ += total - totalSq_[windowAt_];
  chatterSq_[windowAt_] = raw;
  totalSq_[windowAt_] = total;
  windowAt_ = (windowAt_ + 1) % window_;
  follow(displacement);
  if (!frozen_) {
    difference_[differenceAt_] = sum;
    differenceAt_ = (differenceAt_ + 1) % difference_.size();
  }
  note(s, std::sqrt(std::max(0.0, chatterSum_) / static_cast<double>(window_)));
}

void ChatterTruth::note(const TruthSample& s, double raw) noexcept {
  const double rate = perRev_ * s.spindleHz;
  totalRms_ = std::sqrt(std::max(0.0, totalSum_) / static_cast<double>(window_));
  liveHz_ = den_ > 0.0 ? std::acos(std::clamp(num_ / den_, -1.0, 1.0)) * rate / kTwoPi : 0.0;
  const bool settled = s.time >= unsteadyUntil_;
  if (settled) strongest_ = std::max(strongest_, totalRms_);
  ratio_ = s.cutting ? ratioOf(std::min(raw / divisor(liveHz_, s.spindleHz), totalRms_), totalRms_, strongest_) : 0.0;
  if (settled) peak_ = std::max(peak_, ratio_);
  if (ratio_ > kMarkRatio && settled) marked_ += s.path - lastPath_;
  lastPath_ = s.path;
  if (settled && ratio_ >= (sustained_ ? kOverRatio : kEventRatio)) {
    if (aboveSince_ < 0.0) aboveSince_ = s.time;
    highest_ = std::max(highest_, ratio_);
    sustained_ = highest_ >= kSureRatio && s.time - aboveSince_ >= std::max(0.05, 6.0 / s.spindleHz);
  } else {
    aboveSince_ = -1.0;
    highest_ = 0.0;
    sustained_ = false;
  }
  if (sustained_ && eventTime_ < 0.0) {
    eventTime_ = aboveSince_;
    eventHz_ = s.spindleHz;
    freezeAt_ = aboveSince_ + spectrumLength_;
    differenceRate_ = rate;
  }
  // Freeze once the window lies in the chatter, or as soon as somebody turns the speed.
  if (eventTime_ >= 0.0 && !frozen_) {
    frozen_ = s.time >= freezeAt_ || std::abs(rate / differenceRate_ - 1.0) > 1e-3;
  }
  if (s.time - lastLog_ >= 0.001 && log_.size() < log_.capacity()) {
    lastLog_ = s.time;
    log_.push_back({static_cast<float>(s.time), static_cast<float>(raw), static_cast<float>(totalRms_),
                    static_cast<float>(s.spindleHz), static_cast<float>(s.path), static_cast<float>(ratio_),
                    settled && s.cutting});
  }
}

double ChatterTruth::ratioAt(const LogEntry& e, Hertz chatter) const {
  const double total = static_cast<double>(e.forcedAndChatterRms);
  const double part = static_cast<double>(e.chatterRms) / divisor(chatter.value, static_cast<double>(e.spindleHz));
  return ratioOf(std::min(part, total), total, 0.0);
}

ChatterOnset ChatterTruth::onset() const {
  ChatterOnset result;
  if (eventTime_ < 0.0) return result;
  const Hertz chatter = chatterFrequency();
  // From the event backwards, until the ratio is below the mark, or what was seen then far below it: with a frequency
  // near a spindle harmonic the one divisor for all times makes much of little.
  const auto lastBelow = [&](double mark) {
    double from = eventTime_;
    for (auto it = log_.rbegin(); it != log_.rend(); ++it) {
      if (static_cast<double>(it->time) > eventTime_ + 0.02) continue;
      if (!it->settled || ratioAt(*it, chatter) < mark || static_cast<double>(it->ratio) < 0.5 * mark) break;
      from = static_cast<double>(it->time);
    }
    return from;
  };
  result.at1 = lastBelow(0.01);
  result.at20 = lastBelow(kEventRatio);
  for (const LogEntry& e : log_) {
    if (static_cast<double>(e.time) < result.at20 || ratioAt(e, chatter) < 0.5) continue;
    result.at50 = static_cast<double>(e.time);
    break;
  }
  return result;
}

Hertz ChatterTruth::chatterFrequency() const {
  if (eventTime_ < 0.0 || !(differenceRate_ > 0.0)) return Hertz(0.0);
  const std::size_t n = std::min(difference_.size(), static_cast<std::size_t>(spectrumLength_ * differenceRate_));
  std::vector<double> d(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t at = (differenceAt_ + difference_.size() - n + i) % difference_.size();
    const double u = std::sin(std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(n));
    d[i] = difference_[at] * u * u;
  }
  const auto power = [&](double hz) {
    const std::complex<double> turn = std::polar(1.0, -kTwoPi * hz / differenceRate_);
    std::complex<double> phase = 1.0, sum = 0.0;
    for (double v : d) {
      sum += v * phase;
      phase *= turn;
    }
    return std::norm(sum);
  };
  double best = 0.0, bestPower = -1.0;
  const double top = std::min(0.45 * differenceRate_, 2.0 * settings_.highestHz);
  const int lines = static_cast<int>(std::ceil(0.5 * top));
  for (int i = 1; i < lines; ++i) {
    const double hz = 2.0 * i;
    const double p = power(hz);
    if (p > bestPower) {
      bestPower = p;
      best = hz;
    }
  }
  double step = 1.0;
  for (int halving = 0; halving < 8; ++halving, step *= 0.5) {  // down to 8 mHz
    for (double hz : {best - step, best + step}) {
      const double p = power(hz);
      if (p > bestPower) {
        bestPower = p;
        best = hz;
      }
    }
  }
  return Hertz(best);
}

ChatterKind ChatterTruth::kind(int teeth) const {
  if (eventTime_ < 0.0) return ChatterKind::Unknown;
  const double tooth = eventHz_ * teeth;
  const double order = chatterFrequency().value / tooth;
  const double offHalf = std::abs(order - std::floor(order) - 0.5) * tooth;
  // A flip locks on half the tooth-passing frequency; 0.22 s of signal tell frequencies apart to about 2 Hz.
  return offHalf < 2.0 ? ChatterKind::Flip : ChatterKind::Hopf;
}

}  // namespace stillcut::milling
