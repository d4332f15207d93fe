#include "app/python/remarks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/evaluate/picture/sample_store.h"
#include "core/evaluate/picture/signal_guess.h"

namespace stillcut::app {
namespace {

constexpr Rpm kSlow{600.0};  // above it nobody has typed revolutions a second

// Null: it cannot be kept, and nothing is said.
std::shared_ptr<evaluate::SampleStore> storeOf(std::span<const float> samples, std::size_t channels) {
  auto store = evaluate::SampleStore::make(static_cast<int>(channels));
  if (!store) return nullptr;
  constexpr std::size_t kAtOnce = 4096;
  std::vector<std::vector<float>> side(channels);
  for (std::size_t frame = 0; frame < samples.size() / channels; frame += kAtOnce) {
    const std::size_t end = std::min(frame + kAtOnce, samples.size() / channels);
    std::vector<std::span<const float>> spans;
    for (std::size_t c = 0; c < channels; ++c) {
      side[c].clear();
      for (std::size_t f = frame; f < end; ++f) side[c].push_back(samples[f * channels + c]);
      spans.emplace_back(side[c]);
    }
    if (!(*store)->append(spans)) return nullptr;
  }
  return *store;
}

// A sentence where the signal fits sixty times the nominal speed; empty: no doubt, or nothing to be seen.
std::string speedDoubt(const CutSetup& setup, std::span<const float> samples) {
  const Rpm told = setup.nominalSpeed;
  if (!(told.value > 0.0) || told > kSlow) return {};
  const auto store = storeOf(samples, setup.channels.size());
  if (!store) return {};
  evaluate::GuessRequest request;
  request.rate = setup.rate;
  request.told = told;
  for (int c = 0; c < store->channels(); ++c) request.channels.push_back(c);
  const evaluate::SignalGuess guess = evaluate::guessFromSignal(*store, request);
  if (guess.speed.value < 2.0 * told.value) return {};
  char text[160];
  std::snprintf(text, sizeof text, "the signal fits %.0f rpm better than %.4g: was %.4g given in revolutions a second?",
                guess.speed.value, told.value, told.value);
  return text;
}

}  // namespace

std::vector<std::string> remarks(const CutSetup& setup, std::span<const float> samples, Hertz spindle) {
  std::vector<std::string> lines;
  if (setup.teeth <= 0) lines.emplace_back("teeth not given: judged by spindle harmonics alone");
  if (!(setup.nominalSpeed.value > 0.0)) {
    char found[96] = "none found in the signal, nothing can be judged against it";
    if (spindle.value > 0.0)
      std::snprintf(found, sizeof found, "taken from the signal, on average %.0f rpm", toRpm(spindle).value);
    lines.push_back("speed not given: " + std::string(found));
  }
  std::string doubt = speedDoubt(setup, samples);
  if (!doubt.empty()) lines.push_back(std::move(doubt));
  return lines;
}

nlohmann::json toJson(const std::vector<evaluate::AutoValueLog::Entry>& values) {
  nlohmann::json array = nlohmann::json::array();
  for (const evaluate::AutoValueLog::Entry& e : values) {
    array.push_back({{"key", e.decl->key},
                     {"value", std::isfinite(e.value) ? nlohmann::json(e.value) : nlohmann::json()},
                     {"unit", e.decl->unit},
                     {"why", e.why}});
  }
  return array;
}

}  // namespace stillcut::app
