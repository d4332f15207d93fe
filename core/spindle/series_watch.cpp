#include "core/spindle/series_watch.h"

#include <algorithm>
#include <cmath>

#include "core/dsp/fft.h"
#include "core/dsp/order.h"

namespace stillcut::detect {
namespace {

// Orders are told apart by 16 turns; lines of machine and chatter by 0.4 s, in which full chatter must be heard.
constexpr double kTurns = 16.0;
constexpr double kShortest = 0.4;      // s
constexpr double kLongest = 2.0;       // s
constexpr double kUnknown = 0.6;       // s, where nobody told a speed
constexpr Hertz kHighest{6000.0};      // tools chatter below; above, sound holds what chips and air make
constexpr double kUsableBand = 0.45;   // of the rate
constexpr double kLowest = 0.5;        // orders: below are the high-pass and the machine's sway
constexpr double kLineDoubt = 0.25;    // bins, to which a line's place is known
constexpr double kMachines = 4.0;      // 6 dB: a line that rose by less since the air is the machine's
constexpr double kLeaves = 0.5;        // of the power of the last looks: 3 dB less
constexpr double kMargin = 1.2;        // past the stated doubt, so that its end is still a peak
constexpr double kUnforced = 0.1;      // ... of what the teeth force: what rings on as they leave is no chatter
constexpr double kSteady = 1.5e-3;     // relative: orders move by less than what tells lines apart
constexpr double kAgrees = 2e-3;       // relative: further apart, one of two ways to tell the speed is wrong
constexpr double kDriveRipple = 20.0;  // Hz: what is left of a drive's tone as its torque ripples
constexpr std::size_t kLobe = 2;       // bins beside a Hann line
constexpr double kSpeedDoubt = 1e-4;   // of one cell of the belief
constexpr int kSideLines = 3;          // with the line itself: fewer stand on one spacing by chance
constexpr double kMostly = 0.5;        // of the line power
constexpr double kExplained = 0.25;    // of the lines' weight by two series: more than by chance
constexpr int kForcedLines = 4;        // on the orders: blows of teeth make a series of many, as in a cut

// Below this part of the most that it was of late; the newest value goes into the row.
template <std::size_t N>
bool fell(std::array<double, N>& row, double now, double part) {
  const bool below = now < part * *std::max_element(row.begin(), row.end());
  std::rotate(row.begin(), row.begin() + 1, row.end());
  row.back() = now;
  return below;
}

}  // namespace

void SeriesWatch::prepare(const CutSetup& setup, double doubt) {
  channels_ = static_cast<int>(setup.channels.size());
  teeth_ = setup.teeth;
  quantities_.clear();
  for (const ChannelInfo& c : setup.channels) quantities_.push_back(c.quantity);
  rate_ = setup.rate.value;
  doubt_ = doubt;
  const double told = toHertz(setup.nominalSpeed).value;
  const double seconds = told > 0.0 ? std::clamp(kTurns / told, kShortest, kLongest) : kUnknown;
  window_ = dsp::fastFftSize(std::clamp(static_cast<int>(seconds * rate_), 256, 1 << 18));
  hop_ = window_ / kLooksPerWindow;
  heard_.prepare(channels_, static_cast<int>(window_));
  spectrum_.prepare(static_cast<int>(window_), setup.rate, dsp::WindowKind::Hann);
  const auto bins = static_cast<std::size_t>(spectrum_.bins());
  powers_.assign(static_cast<std::size_t>(channels_), std::vector<double>(bins, 0.0));
  air_.assign(static_cast<std::size_t>(channels_), std::vector<double>(bins, 0.0));
  lists_.assign(static_cast<std::size_t>(channels_), {});
  for (LineList& list : lists_) list.prepare(spectrum_.bins(), Hertz(spectrum_.binWidth()));
  belief_.prepare(kMargin * std::max(doubt, 1e-3));
  reset();
}

void SeriesWatch::reset() noexcept {
  interrupt();
  since_ = inAir_ = inCut_ = 0;
  levels_ = forced_ = {};
  speeds_ = {};
  drives_ = {};
  centre_ = 0.0;
  airHeard_ = false;
  for (auto& row : air_) std::fill(row.begin(), row.end(), 0.0);
  look_ = {};
  beginCut();
}

void SeriesWatch::beginCut() noexcept {
  belief_.begin(doubt_ / 3.0);
  look_.certain = false;
  look_.free = {};
}

void SeriesWatch::push(const double* const* samples, int frames, bool air) noexcept {
  const std::ptrdiff_t stride = channels_ > 1 ? samples[1] - samples[0] : 0;
  heard_.push(samples[0], stride, static_cast<std::size_t>(frames));
  remembered_ += frames;
  since_ += frames;
  inAir_ = air ? inAir_ + frames : 0;
  inCut_ = air ? 0 : inCut_ + frames;
}

void SeriesWatch::learnAir() noexcept {
  for (std::size_t c = 0; c < air_.size(); ++c) {
    std::transform(air_[c].begin(), air_[c].end(), powers_[c].begin(), air_[c].begin(),
                   [](double a, double b) { return std::max(a, b); });
  }
  airHeard_ = true;
}

void SeriesWatch::setDrives(std::span<const double> hertz) noexcept {
  drives_ = {};
  std::copy(hertz.begin(), hertz.end(), drives_.begin());
}

bool SeriesWatch::besideDrive(Hertz line) const noexcept {
  return std::any_of(drives_.begin(), drives_.end(),
                     [line](double drive) { return drive > 0.0 && std::abs(line.value - drive) < kDriveRipple; });
}

void SeriesWatch::markMachines(std::size_t channel) noexcept {
  for (SpectralLine& line : lists_[channel].lines()) line.machines = besideDrive(line.frequency);
  if (!airHeard_) return;
  const std::vector<double>& air = air_[channel];
  for (SpectralLine& line : lists_[channel].lines()) {
    double most = 0.0;
    for (std::size_t b = line.bin - std::min(line.bin, kLobe); b <= line.bin + kLobe && b < air.size(); ++b) {
      most = std::max(most, air[b]);
    }
    line.machines = line.machines || line.power < kMachines * most;
  }
}

void SeriesWatch::gather(Hertz told) noexcept {
  series_.begin(Hertz(kLineDoubt * spectrum_.binWidth()));
  const Hertz high(std::min(kHighest.value, kUsableBand * rate_));
  for (std::size_t c = 0; c < lists_.size(); ++c) {
    spectrum_.transform(heard_.newest(static_cast<int>(c)));
    spectrum_.powers(powers_[c]);
    lists_[c].find(powers_[c], told * kLowest, high);
    markMachines(c);
    series_.add(lists_[c].lines());
  }
  look_.whole = inCut_ >= window_;
}

void SeriesWatch::compare(Hertz followed) noexcept {
  look_.agreed = !(followed.value > 0.0) || std::abs(followed / look_.spindle - 1.0) < kAgrees;
}

void SeriesWatch::look(Hertz told, double sd) noexcept {
  const Seconds since(static_cast<double>(since_) / rate_);
  since_ = 0;
  ++look_.count;
  gather(told);
  if (!(told.value > 0.0)) {
    const unsigned count = look_.count;
    look_ = {};
    look_.count = count;
    if (inAir_ >= window_ + hop_) learnAir();
    return;
  }
  // A speed that is told anew keeps the ratio of true to told speed only where it is near.
  if (std::abs(told.value - centre_) > doubt_ * centre_) belief_.begin(sd);
  centre_ = told.value;
  belief_.look(series_, told, since);
  judge(told);
  // What the first look finds may yet be a cut, and what chatters in one is no machine's.
  if (inAir_ >= window_ + hop_ && !look_.familyLeads) learnAir();
}

void SeriesWatch::judgeFamily() noexcept {
  const int family = look_.free.members > 1 ? look_.free.members : 0;  // a tone alone is none
  const int onOrders = series_.onOrders(look_.spindle);
  look_.seriesLines = onOrders + family;
  look_.familyStands = look_.teethHeard && look_.free.members >= kSideLines && look_.free.share > kMostly;
  look_.familyLeads = look_.familyStands && onOrders >= kForcedLines && look_.explained > kExplained;
}

// The mean over the likely speeds.
double SeriesWatch::expectedShare(std::size_t channel, Hertz told) const noexcept {
  double all = 0.0;
  double share = 0.0;
  for (std::size_t i = 0; i < belief_.cells(); ++i) {
    if (!belief_.plausible(i)) continue;
    const double p = belief_.likelihood(i);
    all += p;
    share += p * series_.freeOf(lists_[channel].lines(), told * belief_.ratioAt(i), kSpeedDoubt).share;
  }
  return all > 0.0 ? share / all : 0.0;
}

void SeriesWatch::judge(Hertz told) noexcept {
  const Hertz before = look_.spindle;
  look_.spindle = told * belief_.ratio();
  // What stood on the orders of another speed is no measure of what the teeth force.
  if (std::abs(look_.spindle.value - before.value) > kSteady * before.value) forced_ = {};
  look_.sd = belief_.sd();
  look_.certain = belief_.certain() && !belief_.atEdge();
  look_.certainty = belief_.atEdge() ? 0.0 : belief_.certainty();
  look_.teethHeard = false;
  look_.lines = series_.lines();
  look_.explained = series_.explained(look_.spindle);
  look_.free = {};
  std::array<double, kMaxChannels> off{};
  std::array<double, kMaxChannels> all{};
  std::array<double, kMaxChannels> onOrders{};
  for (std::size_t c = 0; c < lists_.size(); ++c) {
    FreeFamily free = series_.freeOf(lists_[c].lines(), look_.spindle, look_.sd);
    const Hertz alone = told * belief_.ofNewest();
    const double ofNewest = series_.freeOf(lists_[c].lines(), alone, kSpeedDoubt).share;
    for (const SpectralLine& line : lists_[c].lines()) all[c] += line.machines ? 0.0 : line.power;
    onOrders[c] = (1.0 - free.share) * all[c];
    free.share = std::min({free.share, expectedShare(c, told), ofNewest});
    off[c] = free.share * all[c];
    if (c == 0 || free.share > look_.free.share) {
      look_.free = free;
      look_.channel = static_cast<int>(c);
    }
    for (const SpectralLine& line : lists_[c].lines()) {
      const auto order = std::lround(line.frequency / look_.spindle);
      const double away = std::abs(dsp::orderOffset(line.frequency, look_.spindle)) * look_.spindle.value;
      const bool on = !line.machines && order > 0 && away < spectrum_.binWidth();
      look_.teethHeard = look_.teethHeard || (on && teeth_ > 0 && order % teeth_ == 0);
    }
  }
  double offAll = 0.0;
  double inAll = 0.0;
  double forced = 0.0;
  for (std::size_t c = 0; c < lists_.size(); ++c) {
    if (quantities_[c] != quantities_[static_cast<std::size_t>(look_.channel)]) continue;
    offAll += off[c];
    inAll += all[c];
    forced += onOrders[c];
  }
  const bool quieter = fell(levels_, inAll, kLeaves);
  const bool unforced = fell(forced_, forced, kUnforced);
  look_.leaving = quieter || unforced;
  look_.joint = inAll > 0.0 ? offAll / inAll : 0.0;
  watchSpeed(told * belief_.ofNewest());
  judgeFamily();
}

// Lines are smeared, and the likely speed lags, where the spindle changed its speed within what was looked at.
// Where it goes over to another speed that was likely before, it did not move: what was thought is forgotten.
void SeriesWatch::watchSpeed(Hertz newest) noexcept {
  const bool went = std::abs(newest.value - speeds_.back()) > kSteady * newest.value;
  if (went && belief_.newestWasLikely()) speeds_.fill(newest.value);
  std::rotate(speeds_.begin(), speeds_.begin() + 1, speeds_.end());
  speeds_.back() = newest.value;
  const auto [least, most] = std::minmax_element(speeds_.begin(), speeds_.end());
  const double apart = std::max(*most - *least, std::abs(newest.value - look_.spindle.value));
  look_.steady = *least > 0.0 && apart < kSteady * look_.spindle.value;
}

}  // namespace stillcut::detect
