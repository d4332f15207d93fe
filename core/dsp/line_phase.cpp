#include "core/dsp/line_phase.h"

#include <cmath>
#include <complex>

namespace stillcut::detect {
namespace {

constexpr double kWindowTurns = 2.0;
constexpr double kFirstApart = 0.5;   // revolutions: separates frequencies within an order to either side
constexpr double kFurthest = 0.6;     // orders from the rough frequency: beyond half an order it is another line's
constexpr double kSecondApart = 1.0;  // revolutions: twice as fine
constexpr double kAgreement = 0.2;    // orders between the two looks
constexpr double kLeastPart = 0.1;    // of the signal's power in the window

// Sum of hann(n) x(n) exp(-j w n), n counted from the window's begin.
std::complex<double> demodulated(std::span<const double> x, double w, const dsp::kernels::Kernels& kernels) noexcept {
  const double slow = kTwoPi / static_cast<double>(x.size());
  dsp::kernels::HannRun run{x.data(), x.size(), std::cos(w), -std::sin(w), std::cos(slow), std::sin(slow)};
  kernels.demodulate(run);
  return {run.re, run.im};
}

struct Look {
  double error = 0.0;  // rad per frame
  double power = 0.0;  // of the line
};

Look look(std::span<const double> newest, std::size_t window, std::size_t apart, double w,
          const dsp::kernels::Kernels& kernels) noexcept {
  const std::size_t end = newest.size();
  const std::complex<double> now = demodulated(newest.subspan(end - window), w, kernels);
  const std::complex<double> before = demodulated(newest.subspan(end - window - apart, window), w, kernels);
  // The begins of the windows are `apart` frames apart.
  const std::complex<double> turned = std::polar(1.0, -w * static_cast<double>(apart));
  const double amplitude = 4.0 * std::abs(now) / static_cast<double>(window);
  return {std::arg(now * std::conj(before) * turned) / static_cast<double>(apart), 0.5 * amplitude * amplitude};
}

}  // namespace

Hertz linePhaseFrequency(std::span<const double> newest, Hertz rough, Hertz spindle, Hertz rate,
                         const dsp::kernels::Kernels& kernels) noexcept {
  if (!(spindle.value > 0.0) || !(rough.value > 0.0)) return Hertz(0.0);
  const double turn = rate.value / spindle.value;
  const auto window = static_cast<std::size_t>(std::lround(kWindowTurns * turn));
  const auto near = static_cast<std::size_t>(std::lround(kFirstApart * turn));
  const auto far = static_cast<std::size_t>(std::lround(kSecondApart * turn));
  if (near < 1 || window + far > newest.size()) return Hertz(0.0);
  const double order = kTwoPi / turn;  // rad per frame
  const double w = kTwoPi * rough.value / rate.value;
  const Look first = look(newest, window, near, w, kernels);
  if (std::abs(first.error) > kFurthest * order) return Hertz(0.0);
  const Look second = look(newest, window, far, w + first.error, kernels);
  double all = 0.0;
  for (const double x : newest.last(window)) all += x * x;
  const bool stands = second.power * static_cast<double>(window) > kLeastPart * all;
  if (!stands || std::abs(second.error) > kAgreement * order) return Hertz(0.0);
  return rate * ((w + first.error + second.error) / kTwoPi);
}

}  // namespace stillcut::detect
