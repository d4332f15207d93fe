#include "app/compose/tone_samples.h"

#include <utility>

#include "app/compose/profile_rig.h"
#include "core/record/open_recording.h"

namespace stillcut::app {
namespace {

constexpr double kMost = 60.0;  // s

void take(SampleBlock& block, int channel, std::vector<float>& samples) {
  if (block.has(kBlockGap)) samples.clear();
  const std::span<const float> more = block.channel(channel);
  samples.insert(samples.end(), more.begin(), more.end());
}

}  // namespace

Result<ToneSamples> listenToTone(const config::Profile& profile, const std::string& path, int channel, Seconds length,
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
  if (channel < 0 || static_cast<std::size_t>(channel) >= format->channels.size()) {
    return Error{path, "has no channel " + std::to_string(channel),
                 "it has 0 to " + std::to_string(format->channels.size() - 1)};
  }
  ToneSamples heard{{}, format->rate, format->channels[static_cast<std::size_t>(channel)]};
  const auto wanted = static_cast<std::size_t>(length.value * format->rate.value);
  SampleBlock block;
  block.allocate(static_cast<int>(format->channels.size()), format->blockFrames);
  while (heard.samples.size() < wanted && device.read(block)) take(block, channel, heard.samples);
  device.stop();
  if (device.fault().empty()) return heard;
  fault = SetUpFault::Hardware;
  return Error{"", device.fault(), ""};
}

Result<ToneSamples> readTone(const std::string& recording, const record::ReadOptions& options) {
  auto reader = record::openRecording(recording, options);
  if (!reader) return reader.error();
  const record::RecordingFormat& format = (*reader)->format();
  ToneSamples heard{{}, format.rate, format.channels.front().info};
  SampleBlock block;
  constexpr int kAtOnce = 4096;
  block.allocate(static_cast<int>(format.channels.size()), std::max(kAtOnce, format.blockFrames));
  while (static_cast<double>(heard.samples.size()) < kMost * format.rate.value) {
    const Result<bool> more = (*reader)->read(block);
    if (!more) return more.error();
    if (!*more) break;
    take(block, 0, heard.samples);
  }
  return heard;
}

}  // namespace stillcut::app
