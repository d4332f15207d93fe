#include "core/detect/growth/new_line.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/dsp/kernels/choose.h"

namespace stillcut::detect {
namespace {

constexpr std::size_t kWindowTurns = 2;  // Hann: zeros at the orders beside the nearest
constexpr std::size_t kMostTurns = 20;
// Further back the forced vibration need not be what it was: loads change in time, not in turns. A slow spindle's line
// takes some turns all the same.
constexpr Seconds kStays{0.2};
constexpr std::size_t kLeastTurns = 12;
constexpr std::size_t kStillTurns = 3;  // what they hold is the forced vibration, and what they differ by its unrest
constexpr double kMostDoubt = 0.1;      // rad a turn: a third of what sixteen turns of a spectrum resolve

static_assert(kMostTurns + kStillTurns + kWindowTurns == NewLine::kTurnsBack);

// E_0 .. E_(count - 1).
using Turns = std::array<std::complex<double>, kMostTurns + kStillTurns>;

// Phase by which the line is ahead of `rough` [rad per frame] in a turn, if it has come since `still` turns ago, times
// its part of the power; 0 if the forced vibration's unrest there, adding up turn by turn, leaves that phase in doubt.
std::complex<double> turning(const Turns& e, std::size_t still, double rough, const NewLine::TurnsAgo& ago) {
  const std::complex<double> forced = (e[still] + e[still + 1] + e[still + 2]) / 3.0;
  const double unrest = std::max(std::abs(e[still] - e[still + 1]), std::abs(e[still + 1] - e[still + 2]));
  std::complex<double> product = 0.0;
  double power = 0.0;
  double astray = 0.0;
  for (std::size_t k = 0; k < still; ++k) {
    const std::complex<double> line = e[k] - forced;
    // From the middle of one window to that of the next.
    const double turn = ago[k + 2] - ago[k + 1];
    product += line * std::conj(e[k + 1] - forced) * std::polar(1.0, -rough * turn);
    power += std::norm(line);
    astray += std::norm(line * static_cast<double>(still - k));
  }
  if (unrest * std::sqrt(astray) > kMostDoubt * std::abs(product)) return 0.0;
  return product / (power + std::norm(forced));
}

}  // namespace

void NewLine::prepare(int channels, int window, Hertz rate) {
  kernels_ = dsp::kernels::bestKernels();
  rate_ = rate.value;
  channels_ = channels;
  ring_.prepare(channels, window);
}

void NewLine::reset() {
  ring_.reset();
}

void NewLine::push(const double* x, std::ptrdiff_t stride, std::size_t frames) {
  for (std::size_t done = 0; done < frames;) {
    const std::size_t now = std::min(frames - done, ring_.window());
    ring_.push(x + done, stride, now);
    done += now;
  }
}

NewLine::TurnsAgo NewLine::atSpeed(Hertz spindle) const {
  TurnsAgo ago{};
  for (std::size_t k = 0; k < ago.size(); ++k) ago[k] = static_cast<double>(k) * rate_ / spindle.value;
  return ago;
}

// E_k at an order, which may be a fraction. False where less is remembered.
bool NewLine::windowOf(std::span<const double> newest, double order, const TurnsAgo& ago, std::size_t k,
                       std::complex<double>& out) const {
  const double length = ago[k + kWindowTurns] - ago[k];
  if (!(length >= 1.0)) return false;
  const auto window = static_cast<std::size_t>(std::lround(length));
  const auto back = static_cast<std::size_t>(std::lround(ago[k]));
  if (window == 0 || back + window > newest.size()) return false;
  const double w = kTwoPi * order * static_cast<double>(kWindowTurns) / length;
  const double slow = kTwoPi / static_cast<double>(window);
  dsp::kernels::HannRun run{newest.data() + (newest.size() - window - back),
                            window,
                            std::cos(w),
                            -std::sin(w),
                            std::cos(slow),
                            std::sin(slow)};
  kernels_.demodulate(run);
  // Phases count from each window's own begin, which is a whole number of frames back; a turn need not be. While the
  // speed changes windows differ in length, and what the forced vibration leaves in them must not.
  const double begin = static_cast<double>(back + window) - ago[k + kWindowTurns];
  out = std::complex(run.re, run.im) * std::polar(2.0 / static_cast<double>(window), w * begin);
  return true;
}

// 0: no line has come.
std::complex<double> NewLine::advance(std::span<const double> newest, double order, double w,
                                      const TurnsAgo& ago) const {
  Turns e{};
  const auto turns = static_cast<std::size_t>(kStays.value * rate_ / ago[1]);
  const std::size_t most = std::clamp(turns, kLeastTurns, kMostTurns);
  for (std::size_t k = 0; k < most + kStillTurns; ++k) {
    if (!windowOf(newest, order, ago, k, e[k])) return 0.0;
    if (k < kStillTurns) continue;
    const std::complex<double> found = turning(e, k + 1 - kStillTurns, w, ago);
    if (found != 0.0) return found;
  }
  return 0.0;
}

std::span<const double> NewLine::newest(int channel) const {
  return ring_.newest(channel).last(ring_.seen());
}

bool NewLine::turnsOf(int channel, Hertz rough, Hertz spindle, std::span<std::complex<double>> out) const {
  const TurnsAgo ago = atSpeed(spindle);
  const std::span<const double> all = newest(channel);
  for (std::size_t k = 0; k < out.size(); ++k) {
    if (!windowOf(all, rough / spindle, ago, k, out[k])) return false;
  }
  return true;
}

Hertz NewLine::frequency(Hertz rough, Hertz spindle, const TurnsAgo& ago) const {
  if (!(spindle.value > 0.0) || !(rough.value > 0.0)) return Hertz(0.0);
  std::complex<double> all = 0.0;
  for (int c = 0; c < channels_; ++c) {
    all += advance(newest(c), rough / spindle, kTwoPi * rough.value / rate_, ago);
  }
  return std::abs(all) > 0.0 ? rough + spindle * (std::arg(all) / kTwoPi) : Hertz(0.0);
}

}  // namespace stillcut::detect
