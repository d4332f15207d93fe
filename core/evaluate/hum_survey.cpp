#include "core/evaluate/hum_survey.h"

#include <algorithm>
#include <cmath>

namespace stillcut::evaluate {
namespace {

constexpr Hertz kHighPass{20.0};     // offset and drift are no part of what is compared
constexpr int kSettles = 1;          // s: the filter's, and the first that HumWatch compares
constexpr int kFewest = 2;           // s that were judged
constexpr double kHumPart = 0.5;     // of the power, as core/sensing/sensor_check.cpp has it
constexpr double kNearlyAll = 0.8;   // of the seconds
constexpr double kToldDoubt = 0.03;  // relative, of a told speed
constexpr double kSteady = 4.0;      // 6 dB between the strongest and the weakest second: a cut is as much above air

bool mayBeForced(Hertz mains, Hertz told) {
  if (!(told.value > 0.0)) return false;
  const double order = mains / told;
  return order > 0.5 && std::abs(order - std::round(order)) < kToldDoubt * order;
}

}  // namespace

HumSurvey::HumSurvey(std::size_t channels, Hertz rate)
    : length_(static_cast<std::size_t>(std::max(1.0, std::round(rate.value)))), channels_(channels) {
  for (HumChannel& c : channels_) {
    c.watch.prepare(rate);
    c.highPass.highPass(2, kHighPass, rate);
    c.second.reserve(length_);
  }
}

void HumSurvey::see(std::size_t channel, std::span<const float> samples) {
  HumChannel& c = channels_[channel];
  if (c.seconds >= static_cast<int>(kLongest.value)) return;
  for (const float v : samples) {
    c.second.push_back(c.highPass.process(std::isfinite(v) ? static_cast<double>(v) : 0.0));
    if (c.second.size() == length_) finishSecond(c);
  }
}

void HumSurvey::finishSecond(HumChannel& c) const {
  c.watch.push(c.second, Hertz(0.0));
  c.second.clear();
  ++c.seconds;
  if (c.seconds <= kSettles) return;
  const double hum = c.watch.part() * c.watch.meanSquare();
  if (c.watch.part() > kHumPart) {
    ++c.ofHum;
    c.mains = c.watch.mains();
    c.least = c.ofHum == 1 ? hum : std::min(c.least, hum);
    c.most = std::max(c.most, hum);
  }
}

bool HumSurvey::isHum(const HumChannel& c) {
  const int judged = c.seconds - kSettles;
  return judged >= kFewest && c.ofHum >= kNearlyAll * judged && c.most < kSteady * c.least;
}

std::vector<Hertz> HumSurvey::hums(Hertz told) const {
  std::vector<Hertz> hums(channels_.size());
  const bool all = std::all_of(channels_.begin(), channels_.end(), isHum);
  for (std::size_t c = 0; c < channels_.size() && !all; ++c) {
    if (isHum(channels_[c]) && !mayBeForced(channels_[c].mains, told)) hums[c] = channels_[c].mains;
  }
  return hums;
}

}  // namespace stillcut::evaluate
