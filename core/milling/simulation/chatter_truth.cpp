#include "core/milling/simulation/chatter_truth.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace stillcut::milling {

namespace {

constexpr double kEventRatio = 0.2;
constexpr double kMarkRatio = 0.5;
// In power; the gains of the difference at two lines are less far apart, or one of them all but repeats.
constexpr double kClearlyLouder = 10.0;
constexpr double kOverRatio = 0.1;   // below it chatter has ended
constexpr double kMostRatio = 50.0;  // nearly everything is chatter: the difference of squares means little
constexpr double kSureGrowth = 1.0;  // e-folds; a stable cut's disturbance may rise for a while after a change, less
// A growth that beats dips below zero, above all at low immersion where a tooth touches for a moment only: less than
// this is a beat, more an end.
constexpr double kDip = 1.0;  // e-folds
// What has grown for so long is as large as it becomes: chatter, small as teeth that leave the cut, or a force that
// grows less than the chip, may keep it beside the forced vibration.
constexpr double kGrownOut = 10.0;  // e-folds
constexpr double kSmallRatio = 0.03;
constexpr double kLeastGain = 0.3;
constexpr double kLocked = 0.02;       // of a period's frequency
constexpr double kNoiseGain = 2.449;   // of white noise: the root of 1 + 4 + 1
constexpr double kUsualMemory = 0.5;   // [s]
constexpr double kMeanTurns = 2.0;     // the teeth's load makes a slow spindle's speed ripple by some percent
constexpr double kFlicker = 0.05;      // [s]; slow growth is measured below zero for so long at most
constexpr double kLeastForced = 0.05;  // of the strongest forced vibration so far: a cut that fades out
// A drift of the speed by this much takes a line along by far less; a speed that somebody changes passes it at once.
constexpr double kTurned = 1e-2;

// `least`: what counts as forced in any case.
double ratioOf(double chatterRms, double totalRms, double least) {
  const double rest = totalRms * totalRms - chatterRms * chatterRms;
  const double forced = std::sqrt(std::max(rest, least * least));
  return chatterRms > 0.0 ? std::min(chatterRms / std::max(forced, 1e-300), kMostRatio) : 0.0;
}

}  // namespace

ChatterTruth::ChatterTruth(const Settings& settings) : settings_(settings), perRev_(settings.samplesPerRevolution) {
  window_ = static_cast<std::size_t>(perRev_ * std::max(1.0, 0.008 * settings.nominalHz));
  spectrumLength_ = std::max(0.22, 8.0 / settings.nominalHz);
  for (auto& p : past_) p.assign(static_cast<std::size_t>(2 * perRev_ / settings.periodsPerRevolution), 0.0);
  for (Power* p : {&chatter_, &total_, &forced_, &departure_}) p->squares.assign(window_, 0.0);
  difference_.assign(static_cast<std::size_t>(1.1 * spectrumLength_ * settings.fastestHz * perRev_) + 1, 0.0);
  departures_ = differenceTimes_ = difference_;
  log_.reserve(static_cast<std::size_t>(settings.duration * 1000.0) + 16);
}

double ChatterTruth::Power::rms() const noexcept {
  return std::sqrt(std::max(0.0, sum) / static_cast<double>(squares.size()));
}

double ChatterTruth::gain(double chatterHz, double spindleHz) const noexcept {
  if (!(spindleHz > 0.0)) return 1.0;
  const double s = 2.0 * std::sin(std::numbers::pi * chatterHz / (spindleHz * settings_.periodsPerRevolution));
  return std::max(s * s, kLeastGain);
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
  const std::size_t length = past_[0].size(), half = length / 2;
  const auto difference = [&](std::size_t i, double value) {
    const double d = value - 2.0 * past_[i][(pastAt_ + half) % length] + past_[i][pastAt_];
    past_[i][pastAt_] = value;
    return d;
  };
  double raw = 0.0, total = 0.0, forced = 0.0, departure = 0.0, sum = 0.0, away = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    const double d = difference(i, s.acceleration[i]), off = s.acceleration[i] - s.forced[i];
    raw += d * d;
    total += s.acceleration[i] * s.acceleration[i];
    forced += s.forced[i] * s.forced[i];
    departure += off * off;
    sum += d;  // x and y chatter at one frequency: their sum carries it
    away += off;
  }
  pastAt_ = (pastAt_ + 1) % length;
  ++seen_;
  meanHz_ += (s.spindleHz - meanHz_) / std::min(static_cast<double>(seen_), kMeanTurns * perRev_);
  if (seen_ <= length) raw = sum = 0.0;
  chatter_.put(windowAt_, raw);
  total_.put(windowAt_, total);
  forced_.put(windowAt_, forced);
  departure_.put(windowAt_, departure);
  windowAt_ = (windowAt_ + 1) % window_;
  if (!frozen_) {
    difference_[differenceAt_] = sum;
    departures_[differenceAt_] = away;
    differenceTimes_[differenceAt_] = s.time;
    differenceAt_ = (differenceAt_ + 1) % difference_.size();
  }
  note(s, chatter_.rms());
}

// What the stable cut's vibration would be now: the companion's, as much larger as it was when the cut was stable.
double ChatterTruth::usualVibration() const noexcept {
  const double usual = (flips_ ? 1.0 : usual_.vibration) * forced_.rms();
  return std::max(usual, kLeastForced * strongest_);
}

// Chatter to forced, by the departure from the forced companion. Where the cut flips, all of it is: what a runout
// drives there is the flip itself, seeded.
double ChatterTruth::departed() const noexcept {
  const double vibration = usualVibration(), usual = flips_ ? 0.0 : usual_.departure * forced_.rms();
  const double now = departure_.rms();
  if (!(vibration > 0.0)) return 0.0;
  return std::min(kMostRatio, std::sqrt(std::max(0.0, now * now - usual * usual)) / vibration);
}

// Sums the growth of a small disturbance since the cut became unstable.
void ChatterTruth::grow(double folds) noexcept {
  grown_ = std::max(0.0, grown_ + folds);
  mostGrown_ = std::max(mostGrown_, grown_);
  if (grown_ > 0.0 && grown_ > mostGrown_ - kDip) return;
  grown_ = mostGrown_ = 0.0;
}

// How much of what was found is chatter.
void ChatterTruth::count(const TruthSample& s, bool settled) noexcept {
  const double dt = s.time - lastTime_, forced = forced_.rms();
  grow(s.cutting ? s.growth * dt : -std::numeric_limits<double>::infinity());
  if (grown_ > 0.0) liveGain_ = std::max(s.gain, kLeastGain);
  if (grown_ == 0.0 && most_ < kOverRatio) liveGain_ = kNoiseGain;
  flips_ = s.flips;
  if (grown_ > kSureGrowth) {
    repeats_ = s.gain < kLeastGain;
    const double differing = std::sqrt(std::max(0.0, ratio_ * ratio_ - 4.0 * usual_.ratioSquare));
    counted_ = repeats_ ? departed() : differing;
    if (sustained_) counted_ = std::max(counted_, departed());
    most_ = 1.5 * counted_;  // linear decay and what is measured agree to about that
  } else {
    most_ *= std::exp(std::min(0.0, s.growth) * dt);
    counted_ = std::min(std::max(ratio_, departed()), most_);
    if (most_ < kOverRatio && settled && forced > 0.0) {
      usual_.departure = departure_.rms() / forced;
      usual_.vibration = std::max(1.0, totalRms_ / forced);
      usual_.ratioSquare += (ratio_ * ratio_ - usual_.ratioSquare) * (1.0 - std::exp(-dt / kUsualMemory));
    }
  }
  if (!settled) return;
  strongest_ = std::max(strongest_, usualVibration());
  peak_ = std::max(peak_, counted_);
  if (counted_ > kMarkRatio) marked_ += s.path - lastPath_;
}

void ChatterTruth::decide(const TruthSample& s, double middle, bool settled) noexcept {
  const double rate = perRev_ * meanHz_;
  const double least = grown_ > kGrownOut ? kSmallRatio : sustained_ ? kOverRatio : kEventRatio;
  if (settled && counted_ >= least) {
    if (aboveSince_ < 0.0) aboveSince_ = middle;
    // Full chatter is sure; it may lock and hide before six revolutions are over.
    sustained_ = sustained_ || counted_ >= kMarkRatio || middle - aboveSince_ >= std::max(0.05, 6.0 / s.spindleHz);
  } else {
    aboveSince_ = -1.0;
    sustained_ = false;
  }
  if (sustained_ && eventTime_ < 0.0) {
    eventTime_ = aboveSince_;
    eventFlips_ = s.flips;
    eventFolded_ = s.folded;
    eventFoldHz_ = s.foldHz;
    const bool withSpindle = s.folded < kLocked;  // a fold: it drifts away with the forced vibration's own period
    differenceShows_ = s.gain > kLeastGain || (!s.flips && !withSpindle);
    freezeAt_ = aboveSince_ + spectrumLength_;
    differenceRate_ = rate;
  }
  // Freeze once the window lies in the chatter, or as soon as somebody changes the speed.
  if (eventTime_ >= 0.0 && !frozen_) {
    frozen_ = s.time >= freezeAt_ || std::abs(rate / differenceRate_ - 1.0) > kTurned;
  }
}

void ChatterTruth::note(const TruthSample& s, double raw) noexcept {
  const double rate = perRev_ * meanHz_;
  const double middle = s.time - 0.5 * static_cast<double>(window_) / rate;
  totalRms_ = total_.rms();
  const bool settled = s.time >= unsteadyUntil_;
  ratio_ = s.cutting ? ratioOf(std::min(raw / liveGain_, totalRms_), totalRms_, kLeastForced * strongest_) : 0.0;
  count(s, settled);
  lastPath_ = s.path;
  lastTime_ = s.time;
  decide(s, middle, settled);
  if (s.time - lastLog_ >= 0.001 && log_.size() < log_.capacity()) {
    lastLog_ = s.time;
    log_.push_back({static_cast<float>(middle), static_cast<float>(raw), static_cast<float>(totalRms_),
                    static_cast<float>(meanHz_), static_cast<float>(s.path),
                    static_cast<float>(repeats_ ? departed() : ratio_), settled && s.cutting && grown_ > 0.0,
                    repeats_});
  }
}

double ChatterTruth::ratioAt(const LogEntry& e, Hertz chatter) const {
  const double total = static_cast<double>(e.forcedAndChatterRms);
  const double part = static_cast<double>(e.chatterRms) / gain(chatter.value, static_cast<double>(e.spindleHz));
  const double differing = ratioOf(std::min(part, total), total, 0.0);
  // What does not repeat is chatter also where most of it does.
  return e.repeats ? std::max(static_cast<double>(e.ratio), differing) : differing;
}

ChatterOnset ChatterTruth::onset() const {
  ChatterOnset result;
  if (eventTime_ < 0.0) return result;
  const Hertz chatter = chatterFrequency();
  // From the event backwards, until the ratio is below the mark, or what was seen then far below it: with a frequency
  // near a spindle harmonic the one divisor for all times makes much of little.
  const auto lastBelow = [&](double mark) {
    double from = eventTime_;
    double unstable = eventTime_;
    for (auto it = log_.rbegin(); it != log_.rend(); ++it) {
      const auto time = static_cast<double>(it->time);
      if (time > eventTime_ + 0.02) continue;
      if (!it->unstable) {
        if (unstable - time > kFlicker) break;
        continue;
      }
      unstable = time;
      const bool far = !it->repeats && static_cast<double>(it->ratio) < 0.5 * mark;
      if (far || ratioAt(*it, chatter) < mark) break;
      from = time;
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

// Near a line of the linearised cut; large chatter shifts a little. Noise elsewhere, in another mode, is not meant.
// Where two modes become unstable one after the other, the linearised cut follows them late: then what is there counts.
bool ChatterTruth::expected(double hz) const noexcept {
  if (!(eventFoldHz_ > 0.0)) return true;
  const double order = hz / eventFoldHz_;
  return std::abs(std::abs(order - std::round(order)) - eventFolded_) < 0.06;
}

Hertz ChatterTruth::chatterFrequency() const {
  if (eventTime_ < 0.0 || !(differenceRate_ > 0.0)) return Hertz(0.0);
  const std::size_t n = std::min(difference_.size(), static_cast<std::size_t>(spectrumLength_ * differenceRate_));
  std::vector<double> d(n), times(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t at = (differenceAt_ + difference_.size() - n + i) % difference_.size();
    const double u = std::sin(std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(n));
    d[i] = (differenceShows_ ? difference_ : departures_)[at] * u * u;
    times[i] = differenceTimes_[at];
  }
  // Samples come at equal angles, which is not at equal times where the speed drifts.
  const auto power = [&](double hz) {
    std::complex<double> sum = 0.0;
    for (std::size_t i = 0; i < n; ++i) sum += d[i] * std::polar(1.0, -kTwoPi * hz * times[i]);
    return std::norm(sum);
  };
  double best = 0.0, bestPower = -1.0, loudest = 0.0, loudestPower = -1.0;
  const double top = std::min(0.45 * differenceRate_, 2.0 * settings_.highestHz);
  const int lines = static_cast<int>(std::ceil(0.5 * top));
  for (int i = 1; i < lines; ++i) {
    const double hz = 2.0 * i;
    const double p = power(hz);
    if (p > loudestPower) {
      loudestPower = p;
      loudest = hz;
    }
    if (p > bestPower && expected(hz)) {
      bestPower = p;
      best = hz;
    }
  }
  if (loudestPower > kClearlyLouder * bestPower) {
    best = loudest;
    bestPower = loudestPower;
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

ChatterKind ChatterTruth::kind() const {
  if (eventTime_ < 0.0) return ChatterKind::Unknown;
  return eventFlips_ ? ChatterKind::Flip : ChatterKind::Hopf;
}

}  // namespace stillcut::milling
