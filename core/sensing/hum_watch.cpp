#include "core/sensing/hum_watch.h"

#include <algorithm>
#include <cmath>

#include "core/dsp/window.h"

namespace stillcut::detect {
namespace {

constexpr std::array<double, 2> kMains{50.0, 60.0};
constexpr std::array<double, 4> kMultiples{1.0, 2.0, 3.0, 5.0};
constexpr double kDecimated = 1000.0;  // Hz, about: five times 60 Hz lies well below half of it
constexpr double kOffMains = 0.2;      // Hz: grids keep within 0.05, times five
// Hz, of a spindle's harmonic: nearer, the phases of a second do not tell it from the mains; and about 2 Hz away, where
// it turns by a whole turn between the halves of a second.
constexpr double kNearSpindle = 2.0 * kOffMains;
constexpr double kWholeTurn = 2.0;
constexpr double kUsable = 0.45;  // of the rate

}  // namespace

void HumWatch::prepare(Hertz rate) {
  decimation_ = std::max(1, static_cast<int>(rate.value / kDecimated));
  const double slow = rate.value / decimation_;
  length_ = static_cast<int>(std::lround(slow));
  window_.resize(static_cast<std::size_t>(std::max(length_, 1)));
  dsp::fillWindow(dsp::WindowKind::Hann, window_);
  std::size_t i = 0;
  for (const double mains : kMains) {
    for (const double multiple : kMultiples) {
      Line& line = lines_[i++];
      line = {};
      line.frequency = mains * multiple < kUsable * slow ? mains * multiple : 0.0;
      line.step = std::polar(1.0, -kTwoPi * line.frequency / slow);
    }
  }
  reset();
}

void HumWatch::reset() noexcept {
  for (Line& line : lines_) {
    line.rotor = 1.0;
    line.windowed = line.firstHalf = line.secondHalf = line.before = 0.0;
    line.known = false;
    line.power = 0.0;
  }
  count_ = index_ = 0;
  frames_ = 0;
  sum_ = squares_ = part_ = meanSquare_ = 0.0;
  mains_ = {};
}

void HumWatch::push(std::span<const double> x, Hertz spindle) noexcept {
  spindle_ = spindle;
  for (std::size_t f = 0; f < x.size();) {
    const auto now = std::min(static_cast<std::size_t>(decimation_ - count_), x.size() - f);
    double squares = squares_;
    double sum = sum_;
    for (const double v : x.subspan(f, now)) {
      squares += v * v;
      sum += v;
    }
    squares_ = squares;
    sum_ = sum;
    f += now;
    frames_ += static_cast<long>(now);
    count_ += static_cast<int>(now);
    if (count_ < decimation_) continue;
    add(sum_ / decimation_);
    sum_ = 0.0;
    count_ = 0;
  }
}

void HumWatch::add(double x) noexcept {
  const double w = window_[static_cast<std::size_t>(index_)];
  const bool early = 2 * index_ < length_;
  for (Line& line : lines_) {
    const std::complex<double> turned = x * line.rotor;
    line.windowed += w * turned;
    (early ? line.firstHalf : line.secondHalf) += turned;
    line.rotor *= line.step;
  }
  if (++index_ >= length_) finish();
}

bool HumWatch::onMains(const Line& line) const noexcept {
  const double turned = std::arg(line.windowed * std::conj(line.before));       // over one second
  const double inside = std::arg(line.secondHalf * std::conj(line.firstHalf));  // over half of one
  return std::abs(turned) < kTwoPi * kOffMains && std::abs(inside) < 0.5 * kTwoPi * kOffMains;
}

bool HumWatch::nearOrder(std::size_t line, Hertz spindle) const noexcept {
  if (!(spindle.value > 0.0)) return false;
  const double order = lines_[line].frequency / spindle.value;
  const double away = std::abs(order - std::round(order)) * spindle.value;
  return away < kNearSpindle || std::abs(away - kWholeTurn) < kNearSpindle;
}

void HumWatch::finish() noexcept {
  meanSquare_ = squares_ / static_cast<double>(std::max(1L, frames_));
  part_ = 0.0;
  for (std::size_t m = 0; m < kMains.size(); ++m) {
    double power = 0.0;
    for (std::size_t k = 0; k < kMultiples.size(); ++k) {
      const std::size_t i = m * kMultiples.size() + k;
      Line& line = lines_[i];
      line.power = 0.0;
      if (line.frequency <= 0.0 || nearOrder(i, spindle_) || !line.known || !onMains(line)) continue;
      const double amplitude = 4.0 * std::abs(line.windowed) / length_;  // the window's mean is a half
      line.power = 0.5 * amplitude * amplitude;
      power += line.power;
    }
    if (meanSquare_ > 0.0 && power / meanSquare_ > part_) {
      part_ = std::min(1.0, power / meanSquare_);
      mains_ = Hertz(kMains[m]);
    }
  }
  for (Line& line : lines_) {
    line.rotor /= std::abs(line.rotor);
    line.before = line.windowed;
    line.known = true;
    line.windowed = line.firstHalf = line.secondHalf = 0.0;
  }
  index_ = 0;
  squares_ = 0.0;
  frames_ = 0;
}

}  // namespace stillcut::detect
