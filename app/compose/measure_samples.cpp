#include "app/compose/measure_samples.h"

#include <utility>

#include "app/compose/profile_rig.h"
#include "core/session/open_recording.h"

namespace stillcut::app {
namespace {

constexpr double kMost = 60.0;  // s

}  // namespace

Result<daq::MeasuredSamples> measureDevice(const config::Profile& profile, const std::string& path, int channel,
                                           Seconds length, SetUpFault& fault, const std::atomic<bool>* ended) {
  fault = SetUpFault::Input;
  auto parts = makeProfileParts(profile, path);
  if (!parts) return parts.error();
  const auto format = parts->device->open();
  if (!format) {
    fault = SetUpFault::Hardware;
    return format.error();
  }
  if (const Status there = checkChannel(format->channels.size(), path, channel); !there) return there.error();
  fault = SetUpFault::Hardware;
  daq::MeasureRequest request;
  request.length = length;
  request.told = profile.cut.channels;
  request.ended = ended;
  return daq::measure(*parts->device, *format, request);
}

Result<daq::MeasuredSamples> measureRecording(const std::string& recording, const record::ReadOptions& options) {
  auto reader = record::openRecording(recording, options);
  if (!reader) return reader.error();
  const record::RecordingFormat& format = (*reader)->format();
  daq::LongestStretch stretch(format.channels.size());
  daq::MeasuredSamples heard;
  heard.rate = format.rate;
  for (const auto& channel : format.channels) heard.channels.push_back(channel.info);
  SampleBlock block;
  constexpr int kAtOnce = 4096;
  block.allocate(static_cast<int>(format.channels.size()), std::max(kAtOnce, format.blockFrames));
  while (static_cast<double>(stretch.length()) < kMost * format.rate.value) {
    const Result<bool> more = (*reader)->read(block);
    if (!more) return more.error();
    if (!*more) break;
    stretch.take(block);
  }
  heard.samples = std::move(stretch).samples();
  return heard;
}

Status checkChannel(std::size_t channels, const std::string& where, int channel) {
  if (channel >= 0 && static_cast<std::size_t>(channel) < channels) return Done{};
  return Error{where, message("has no channel %1", std::to_string(channel)),
               message("it has 0 to %1", std::to_string(channels - 1))};
}

}  // namespace stillcut::app
