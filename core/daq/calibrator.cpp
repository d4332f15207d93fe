#include "core/daq/calibrator.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>
#include <vector>

#include "core/base/conversions.h"

namespace stillcut::daq {
namespace {

constexpr double kShortest = 2.0;    // s
constexpr double kPiece = 0.25;      // s
constexpr double kReach = 0.05;      // of the frequency: calibrators keep 2 %, a device's clock far less
constexpr double kPure = 0.9;        // of the power: 10 dB above all else
constexpr double kSteady = 0.05;     // standard deviation of the pieces' levels
constexpr double kQuietest = 20e-6;  // Pa, 0 dB
constexpr double kBeyond = 1.015;    // amplitude over reach; half a step of a coarse converter stays below

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

double meanOf(std::span<const float> x) {
  double sum = 0.0;
  for (const float v : x) sum += static_cast<double>(v);
  return sum / static_cast<double>(x.size());
}

// Root mean square of the best sine of this frequency, least squares for cosine and sine together.
double toneRms(std::span<const float> x, double mean, double radPerSample) {
  std::complex<double> rotor(1.0, 0.0);
  const std::complex<double> step = std::polar(1.0, radPerSample);
  double cc = 0.0, ss = 0.0, cs = 0.0, xc = 0.0, xs = 0.0;
  for (const float v : x) {
    const double c = rotor.real();
    const double s = rotor.imag();
    const double value = static_cast<double>(v) - mean;
    cc += c * c;
    ss += s * s;
    cs += c * s;
    xc += value * c;
    xs += value * s;
    rotor *= step;
  }
  const double det = cc * ss - cs * cs;
  const double a = (xc * ss - xs * cs) / det;
  const double b = (xs * cc - xc * cs) / det;
  return std::sqrt(0.5 * (a * a + b * b));
}

// The frequency within reach at which the sine is largest: a grid finer than the main lobe, then a golden section.
double findFrequency(std::span<const float> x, double mean, double rate, double around) {
  const double seconds = static_cast<double>(x.size()) / rate;
  const double step = 0.25 / seconds;
  const auto size = [&](double f) { return toneRms(x, mean, 2.0 * std::numbers::pi * f / rate); };
  double best = around;
  double most = 0.0;
  const int steps = static_cast<int>(2.0 * kReach * around / step);
  for (int i = 0; i <= steps; ++i) {
    const double f = (1.0 - kReach) * around + i * step;
    const double s = size(f);
    if (s <= most) continue;
    most = s;
    best = f;
  }
  double low = best - step;
  double high = best + step;
  constexpr int kRounds = 24;
  for (int i = 0; i < kRounds; ++i) {
    const double part = (high - low) * (std::numbers::phi - 1.0);
    if (size(high - part) > size(low + part)) {
      high = low + part;
    } else {
      low = high - part;
    }
  }
  return 0.5 * (low + high);
}

// A sine never swings further than it reaches; one that is cut off does, by 1.7 % when a fiftieth of it is gone. Where
// few samples make a period, the nearest may miss the top by half a step.
bool cutOff(std::span<const float> x, double mean, double rms, double radPerSample) {
  const auto [least, greatest] = std::minmax_element(x.begin(), x.end());
  const double reach = std::min(static_cast<double>(*greatest) - mean, mean - static_cast<double>(*least));
  return std::numbers::sqrt2 * rms * std::cos(0.5 * radPerSample) > kBeyond * reach;
}

}  // namespace

Result<double> levelFrom(const std::string& text, SensorQuantity quantity) {
  double value = 0.0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  std::string unit(end, text.data() + text.size());
  std::erase(unit, ' ');
  const bool sound = quantity == SensorQuantity::Sound;
  const bool acceleration = quantity == SensorQuantity::Acceleration;
  if (problem == std::errc() && unit == "dB" && sound && std::isfinite(value)) {
    return kQuietest * std::pow(10.0, value / 20.0);
  }
  if (problem == std::errc() && value > 0.0 && std::isfinite(value)) {
    if (unit == "g" && acceleration) return value * kStandardGravity;
    if (unit.empty() || unit == siUnit(quantity) || (acceleration && unit == "m/s2")) return value;
  }
  return Error{message("the calibrator's level"), message("'%1' is none", text),
               sound          ? message("rms in %1, or as \"94 dB\"", siUnit(quantity))
               : acceleration ? message("rms in %1, or as \"1 g\"", siUnit(quantity))
                              : message("rms in %1", siUnit(quantity))};
}

Result<Calibration> calibrate(std::span<const float> samples, Hertz rate, const CalibratorTone& tone) {
  const std::string where = "calibrator";
  const double f = tone.frequency.value;
  if (!(f > 0.0) || !((1.0 + kReach) * f < 0.5 * rate.value)) {
    return Error{where, message("%1 Hz cannot be measured at %2 samples a second", number(f), number(rate.value))};
  }
  if (!(tone.level > 0.0)) return Error{where, message("its level must be above zero")};
  if (static_cast<double>(samples.size()) < kShortest * rate.value) {
    return Error{where, message("too short"), message("two seconds of the tone are needed")};
  }
  const double mean = meanOf(samples);
  double power = 0.0;
  for (const float v : samples) power += (static_cast<double>(v) - mean) * (static_cast<double>(v) - mean);
  power /= static_cast<double>(samples.size());
  if (!(power > 0.0)) return Error{where, message("there is no signal"), message("is the sensor connected?")};

  Calibration found;
  const auto second = static_cast<std::size_t>(rate.value);
  found.frequency = Hertz(findFrequency(samples.first(second), mean, rate.value, f));
  const double turn = 2.0 * std::numbers::pi * found.frequency.value / rate.value;
  const auto piece = static_cast<std::size_t>(kPiece * rate.value);
  std::vector<double> levels;
  double tonePower = 0.0;
  for (std::size_t at = 0; at + piece <= samples.size(); at += piece) {
    levels.push_back(toneRms(samples.subspan(at, piece), mean, turn));
    tonePower += levels.back() * levels.back();
  }
  const double count = static_cast<double>(levels.size());
  found.pure = tonePower / count / power;
  if (found.pure < kPure) {
    return Error{where, message("only %1 % of the signal is a tone near %2 Hz", number(100.0 * found.pure), number(f)),
                 message("does the calibrator run, on this channel, and is the machine quiet?")};
  }
  for (const double level : levels) found.rms += level / count;
  if (cutOff(samples, mean, found.rms, turn))
    return Error{where, message("the tone is cut off at the input's limit"), message("set its gain lower")};
  double squares = 0.0;
  for (const double level : levels) squares += (level - found.rms) * (level - found.rms);
  const double sd = std::sqrt(squares / (count - 1.0));
  if (sd > kSteady * found.rms) {
    return Error{where, message("the level moves by %1 %", number(100.0 * sd / found.rms)),
                 message("hold sensor and calibrator still")};
  }
  found.scale = tone.level / found.rms;
  found.scaleSd = found.scale * sd / found.rms / std::sqrt(count);
  return found;
}

void applyCalibration(const Calibration& found, ChannelInfo& channel) {
  channel.scale = found.scale;
  if (channel.sensitivity == 0.0 || channel.volts == 0.0) return;
  channel.sensitivity = scaleOf(channel.quantity, found.scale, channel.volts);  // the relation is its own inverse
}

}  // namespace stillcut::daq
