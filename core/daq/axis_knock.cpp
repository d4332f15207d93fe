#include "core/daq/axis_knock.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace stillcut::daq {
namespace {

constexpr double kShortest = 2.0;  // s
constexpr double kFirst = 0.005;   // s after the beginning of a blow
constexpr double kQuiet = 0.1;     // s between two blows: the ringing of one begins no other
constexpr double kBlow = 100.0;    // of the usual power: 20 dB
constexpr double kClear = 6.0;     // dB: twice the motion of any other axis
constexpr const char* kWhere = "knock";
constexpr const char* kOneKnock = "one knock along %1: '%2' measured most, %3 dB above the next";
constexpr const char* kKnocks = "%4 knocks along %1: '%2' measured most, %3 dB above the next";
constexpr const char* kRight = "it is right";
constexpr const char* kExchanged = "'%1' and '%2' are exchanged";
constexpr std::array kWords{kOneKnock, kKnocks, kRight, kExchanged};

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

// [SI squared], around the mean.
std::vector<double> powerOf(std::span<const float> x, double scale) {
  double mean = 0.0;
  for (const float v : x) mean += static_cast<double>(v) / static_cast<double>(x.size());
  std::vector<double> power(x.size());
  std::ranges::transform(x, power.begin(), [&](float v) {
    const double away = scale * (static_cast<double>(v) - mean);
    return away * away;
  });
  return power;
}

// Where blows begin, by the power of all compared channels.
std::vector<std::size_t> blowsIn(const std::vector<std::vector<double>>& powers, double rate) {
  std::vector<double> all(powers.front().size(), 0.0);
  for (const std::vector<double>& power : powers) {
    for (std::size_t n = 0; n < all.size(); ++n) all[n] += power[n];
  }
  std::vector<double> sorted = all;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const double limit = kBlow * *middle;
  const auto quiet = static_cast<std::size_t>(kQuiet * rate);
  std::vector<std::size_t> blows;
  std::size_t calm = quiet;
  for (std::size_t n = 0; n < all.size(); ++n) {
    const bool loud = all[n] > limit;
    if (loud && calm >= quiet) blows.push_back(n);
    calm = loud ? 0 : calm + 1;
  }
  return blows;
}

}  // namespace

Result<KnockResult> analyseKnocks(const std::vector<std::vector<float>>& samples, Hertz rate,
                                  const std::vector<ChannelInfo>& channels, std::size_t told) {
  if (told >= channels.size() || channels[told].axis.empty()) {
    return Error{kWhere, message("the chosen channel has no axis"), message("say which one it should lie along")};
  }
  const ChannelInfo& chosen = channels[told];
  std::vector<std::size_t> compared;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const ChannelInfo& other = channels[c];
    if (other.quantity == chosen.quantity && other.place == chosen.place && !other.axis.empty()) compared.push_back(c);
  }
  if (compared.size() < 2) {
    return Error{kWhere, message("'%1' has no other axis beside it", chosen.name),
                 message("there is nothing to exchange it with")};
  }
  if (static_cast<double>(samples[told].size()) < kShortest * rate.value) {
    return Error{kWhere, message("too short"), message("two seconds are needed")};
  }
  std::vector<std::vector<double>> powers;
  powers.reserve(compared.size());
  for (const std::size_t c : compared) powers.push_back(powerOf(samples[c], channels[c].scale));
  const std::vector<std::size_t> blows = blowsIn(powers, rate.value);
  if (blows.empty()) {
    return Error{kWhere, message("none was measured"),
                 message("knock along %1, hard, with the machine quiet", chosen.axis)};
  }
  const auto first = static_cast<std::size_t>(std::max(1.0, kFirst * rate.value));
  std::vector<std::pair<double, std::size_t>> energies;
  energies.reserve(compared.size());
  for (std::size_t i = 0; i < compared.size(); ++i) {
    double energy = 0.0;
    for (const std::size_t at : blows) {
      for (std::size_t n = at; n < std::min(at + first, powers[i].size()); ++n) energy += powers[i][n];
    }
    energies.emplace_back(energy, compared[i]);
  }
  std::ranges::sort(energies, std::ranges::greater{});
  const double lead = energies[1].first > 0.0 ? 10.0 * std::log10(energies[0].first / energies[1].first) : 99.0;
  if (lead < kClear) {
    return Error{kWhere,
                 message("'%1' and '%2' measured it within %3 dB of each other", channels[energies[0].second].name,
                         channels[energies[1].second].name, number(lead)),
                 message("knock straight along %1, close to the sensor", chosen.axis)};
  }
  return KnockResult{told, energies[0].second, lead, static_cast<int>(blows.size())};
}

std::vector<Message> knockSentence(const KnockResult& heard, const std::vector<ChannelInfo>& channels) {
  const ChannelInfo& told = channels[heard.told];
  const ChannelInfo& loudest = channels[heard.loudest];
  Message most{heard.knocks == 1 ? kOneKnock : kKnocks, {told.axis, loudest.name, number(heard.lead)}};
  if (heard.knocks != 1) most.arguments.emplace_back(std::to_string(heard.knocks));
  if (heard.loudest == heard.told) return {most, {kRight, {}}};
  return {most, {kExchanged, {told.name, loudest.name}}};
}

std::span<const char* const> knockWords() {
  return kWords;
}

void applyKnocks(const KnockResult& heard, std::vector<ChannelInfo>& channels) {
  std::swap(channels[heard.told].axis, channels[heard.loudest].axis);
}

}  // namespace stillcut::daq
