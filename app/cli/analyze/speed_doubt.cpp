#include "app/cli/analyze/speed_doubt.h"

#include <algorithm>
#include <cstdio>
#include <span>
#include <utility>

#include "core/evaluate/picture/signal_guess.h"
#include "core/evaluate/scenario_reader.h"

namespace stillcut::app {
namespace {

constexpr Rpm kSlow{600.0};  // above it nobody has typed revolutions a second

// Null: it cannot be kept, and nothing is said.
std::shared_ptr<evaluate::SampleStore> samplesOf(record::RecordingReader& reader) {
  const auto channels = static_cast<int>(reader.format().channels.size());
  auto store = evaluate::SampleStore::make(channels);
  if (!store) return nullptr;
  constexpr int kAtOnce = 4096;
  SampleBlock block;
  block.allocate(channels, std::max(reader.format().blockFrames, kAtOnce));
  while (true) {
    const Result<bool> more = reader.read(block);
    if (!more) return nullptr;
    if (!*more) return *store;
    std::vector<std::span<const float>> spans;
    for (int c = 0; c < channels; ++c) spans.push_back(std::as_const(block).channel(c));
    if (!(*store)->append(spans)) return nullptr;
  }
}

}  // namespace

std::string speedDoubt(const std::string& path, const record::ReadOptions& read,
                       const std::vector<ChannelAnswer>& channels, Rpm told) {
  if (!(told.value > 0.0) || told > kSlow) return {};
  auto reader = evaluate::openCut(path, read);
  if (!reader) return {};
  const auto samples = samplesOf(**reader);
  if (!samples) return {};
  evaluate::GuessRequest request;
  request.rate = (*reader)->format().rate;
  request.told = told;
  for (const ChannelAnswer& channel : channels) {
    if (channel.index < samples->channels()) request.channels.push_back(channel.index);
  }
  const evaluate::SignalGuess guess = evaluate::guessFromSignal(*samples, request);
  if (guess.speed.value < 2.0 * told.value) return {};
  char text[160];
  std::snprintf(text, sizeof text, "the signal fits %.0f rpm better than %.4g: was %.4g typed in revolutions a second?",
                guess.speed.value, told.value, told.value);
  return text;
}

}  // namespace stillcut::app
