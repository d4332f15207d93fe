#include "app/compose/heard_samples.h"

#include <utility>

#include "app/compose/profile_rig.h"
#include "core/record/open_recording.h"

namespace stillcut::app {
namespace {

constexpr double kMost = 60.0;  // s

void take(SampleBlock& block, std::vector<std::vector<float>>& samples) {
  for (std::size_t c = 0; c < samples.size(); ++c) {
    if (block.has(kBlockGap)) samples[c].clear();
    const std::span<const float> more = block.channel(static_cast<int>(c));
    samples[c].insert(samples[c].end(), more.begin(), more.end());
  }
}

}  // namespace

Result<HeardSamples> hearDevice(const config::Profile& profile, const std::string& path, int channel, Seconds length,
                                SetUpFault& fault) {
  fault = SetUpFault::Input;
  auto parts = makeProfileParts(profile, path);
  if (!parts) return parts.error();
  daq::DaqSource& device = *parts->device;
  const auto format = device.open();
  if (!format) {
    fault = SetUpFault::Hardware;
    return format.error();
  }
  if (const Status there = checkChannel(format->channels.size(), path, channel); !there) return there.error();
  HeardSamples heard{std::vector<std::vector<float>>(format->channels.size()), format->rate, format->channels};
  const auto wanted = static_cast<std::size_t>(length.value * format->rate.value);
  SampleBlock block;
  block.allocate(static_cast<int>(format->channels.size()), format->blockFrames);
  while (heard.samples.front().size() < wanted && device.read(block)) take(block, heard.samples);
  device.stop();
  if (device.fault().empty()) return heard;
  fault = SetUpFault::Hardware;
  return Error{"", device.fault(), ""};
}

Result<HeardSamples> hearRecording(const std::string& recording, const record::ReadOptions& options) {
  auto reader = record::openRecording(recording, options);
  if (!reader) return reader.error();
  const record::RecordingFormat& format = (*reader)->format();
  HeardSamples heard{std::vector<std::vector<float>>(format.channels.size()), format.rate, {}};
  for (const auto& channel : format.channels) heard.channels.push_back(channel.info);
  SampleBlock block;
  constexpr int kAtOnce = 4096;
  block.allocate(static_cast<int>(format.channels.size()), std::max(kAtOnce, format.blockFrames));
  while (static_cast<double>(heard.samples.front().size()) < kMost * format.rate.value) {
    const Result<bool> more = (*reader)->read(block);
    if (!more) return more.error();
    if (!*more) break;
    take(block, heard.samples);
  }
  return heard;
}

Status checkChannel(std::size_t channels, const std::string& where, int channel) {
  if (channel >= 0 && static_cast<std::size_t>(channel) < channels) return Done{};
  return Error{where, "has no channel " + std::to_string(channel), "it has 0 to " + std::to_string(channels - 1)};
}

}  // namespace stillcut::app
